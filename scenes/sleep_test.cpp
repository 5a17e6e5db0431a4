// The towers fall asleep, and each wakes by itself.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

TEST(SleepScene, comes_to_rest_and_a_ball_wakes_one_tower)
{
    const auto scene = make_scene("sleep", {{"balls", false}});
    step(*scene, 420);
    EXPECT_EQ(scene->world().awake_body_count(), 0);
    click(*scene, {1.5f, 8});
    int most = 0;
    for (int i = 0; i < 120; ++i)
    {
        scene->step();
        most = std::max(most, scene->world().awake_body_count());
    }
    EXPECT_GE(most, 7) << "a tower and the ball";
    EXPECT_LE(most, 21) << "not the whole city";
    scene->key("w");
    EXPECT_GE(scene->world().awake_body_count(), 96);
}

} // namespace carom::scenes
