// Every stone falls, and they can be set up again.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

/// Stones that lean to the right by more than 0.6 rad.
int fallen(const Scene& scene)
{
    int count = 0;
    for (const BodyId id : scene.world().bodies()) count += scene.world().body(id).angle() < -0.6f;
    return count;
}

} // namespace

TEST(Domino, all_fall_one_after_the_other)
{
    for (const int stones : {8, 10, 20, 40})
    {
        const auto scene = make_scene("domino", {{"stones", stones}});
        step(*scene, 30);
        EXPECT_LT(fallen(*scene), 2 * stones) << stones;
        step(*scene, 570);
        EXPECT_EQ(fallen(*scene), 4 * stones) << stones;
    }
}

TEST(Domino, stands_when_set_up_again_and_falls_when_pushed)
{
    const auto scene = make_scene("domino");
    step(*scene, 300);
    scene->key("s");
    step(*scene, 300);
    EXPECT_EQ(fallen(*scene), 0);
    scene->key("space");
    step(*scene, 600);
    EXPECT_EQ(fallen(*scene), 40);
}

} // namespace carom::scenes
