// The bridge holds, and more can be laid on it and taken away.
#include "scenes/registry.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

/// The largest joint error in so many steps [m].
float largest_error(Scene& scene, int steps)
{
    float largest = 0;
    for (int i = 0; i < steps; ++i)
    {
        scene.step();
        for (const JointId joint : scene.world().joints()) largest = std::max(largest, scene.world().joint(joint).error());
    }
    return largest;
}

} // namespace

TEST(Bridge, holds_for_ten_seconds)
{
    // While the loads strike pins give way a little; once they lie no more than half a millimetre.
    for (const double density : {0.1, 1.0, 2.0})
    {
        const auto scene = make_scene("bridge", {{"density", density}});
        const float all = largest_error(*scene, 480);
        const float rest = largest_error(*scene, 120);
        EXPECT_LT(all, 0.01f) << density;
        EXPECT_LT(rest, 0.0005f) << density;
        EXPECT_EQ(scene->world().joint_count(), 21) << density;
    }
}

TEST(Bridge, gathers_itself_after_loads_much_heavier_than_a_plank)
{
    const auto scene = make_scene("bridge", {{"density", 10}});
    EXPECT_LT(largest_error(*scene, 480), 0.2f);
    EXPECT_LT(largest_error(*scene, 120), 0.002f);
}

TEST(Bridge, loads_come_and_go)
{
    const auto scene = make_scene("bridge", {{"loads", 0}});
    const int empty = scene->world().body_count();
    scene->pointer({PointerEvent::Action::Down, PointerEvent::Button::Left, {0, 5}});
    EXPECT_EQ(scene->world().body_count(), empty + 1);
    largest_error(*scene, 300);
    EXPECT_GT(scene->world().body(scene->world().bodies().back()).position().y, -4);
    scene->key("x");
    scene->key("x");
    EXPECT_EQ(scene->world().body_count(), empty);
}

} // namespace carom::scenes
