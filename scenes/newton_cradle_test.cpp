// Newton's cradle: as much comes out at the far end as went in.
#include "scenes/registry.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

float speed_of(const Scene& scene, std::size_t ball) { return scene.world().body(scene.world().bodies()[ball]).linear_velocity().x; }

} // namespace

TEST(NewtonCradleScene, the_last_ball_gets_the_momentum_of_the_first)
{
    for (const int balls : {3, 5, 9})
    {
        const auto scene = make_scene("newton-cradle", {{"balls", balls}, {"lifted", 1}});
        const auto last = static_cast<std::size_t>(balls) - 1;
        float before = 0;
        for (int i = 0; i < 120 && speed_of(*scene, last) < 1; ++i)
        {
            before = std::max(before, speed_of(*scene, 0));
            scene->step();
        }
        EXPECT_GT(before, 4) << balls;
        EXPECT_NEAR(speed_of(*scene, last), before, 0.02f * before) << balls;
        EXPECT_NEAR(speed_of(*scene, 0), 0, 0.02f * before) << balls;
    }
}

TEST(NewtonCradleScene, two_in_two_out)
{
    const auto scene = make_scene("newton-cradle", {{"lifted", 2}});
    for (int i = 0; i < 120 && speed_of(*scene, 4) < 1; ++i) scene->step();
    ASSERT_GE(speed_of(*scene, 4), 1);
    EXPECT_NEAR(speed_of(*scene, 3), speed_of(*scene, 4), 0.05f * speed_of(*scene, 4));
    for (const std::size_t ball : {0u, 1u, 2u}) EXPECT_NEAR(speed_of(*scene, ball), 0, 0.05f * speed_of(*scene, 4)) << ball;
}

TEST(NewtonCradleScene, a_key_lifts_again)
{
    const auto scene = make_scene("newton-cradle");
    const BodyId first = scene->world().bodies().front();
    const Vec2 before = scene->world().body(first).position();
    for (int i = 0; i < 60; ++i) scene->step();
    EXPECT_GT(distance(scene->world().body(first).position(), before), 1);
    scene->key("space");
    EXPECT_LT(distance(scene->world().body(first).position(), before), 0.1f);
}

} // namespace carom::scenes
