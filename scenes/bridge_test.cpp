// The bridge holds, and more can be laid on it and taken away.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

/// While the loads strike, pins give way a little; later they hold exactly, but for what still rolls about.
TEST(Bridge, holds_for_ten_seconds)
{
    struct Bound
    {
        double density;
        float struck; // [m]
        float later;
    };
    for (const Bound& bound : {Bound{0.1, 0.004f, 0.0005f}, {1, 0.01f, 0.001f}, {2, 0.015f, 0.0015f}, {10, 0.06f, 0.003f}})
        for (const std::uint64_t seed : {1u, 2u, 3u, 4u})
        {
            const auto scene = make_scene("bridge", {{"density", bound.density}}, seed);
            EXPECT_LT(largest_joint_error(*scene, 480), bound.struck) << bound.density << ", seed " << seed;
            EXPECT_LT(largest_joint_error(*scene, 120), bound.later) << bound.density << ", seed " << seed;
            EXPECT_EQ(scene->world().joint_count(), 21) << bound.density;
        }
}

TEST(Bridge, loads_come_and_go)
{
    const auto scene = make_scene("bridge", {{"loads", 0}});
    const int empty = scene->world().body_count();
    click(*scene, {0, 5});
    EXPECT_EQ(scene->world().body_count(), empty + 1);
    step(*scene, 300);
    EXPECT_GT(scene->world().body(scene->world().bodies().back()).position().y, -4);
    scene->key("x");
    scene->key("x");
    EXPECT_EQ(scene->world().body_count(), empty);
}

} // namespace carom::scenes
