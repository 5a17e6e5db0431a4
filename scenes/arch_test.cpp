// The arch scene: it stands by friction, and not without.
#include "scenes/registry.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

/// The way of the stone that has moved most [m].
float farthest_way(Scene& scene, int steps)
{
    const std::vector<BodyId> bodies = scene.world().bodies();
    const auto place = [&](int stone) { return scene.world().body(bodies[static_cast<std::size_t>(stone + 1)]).position(); };
    const int stones = scene.parameters().integer("stones");
    std::vector<Vec2> before;
    for (int i = 0; i < stones; ++i) before.push_back(place(i));
    for (int i = 0; i < steps; ++i) scene.step();
    float farthest = 0;
    for (int i = 0; i < stones; ++i) farthest = std::max(farthest, distance(before[static_cast<std::size_t>(i)], place(i)));
    return farthest;
}

} // namespace

TEST(Arch, stands_for_a_minute_without_sleep)
{
    const auto scene = make_scene("arch");
    scene->world().set_sleep_tuning({.is_enabled = false});
    EXPECT_LT(farthest_way(*scene, 3600), 0.02f);
}

TEST(Arch, falls_without_friction)
{
    const auto scene = make_scene("arch", {{"friction", 0}});
    EXPECT_GT(farthest_way(*scene, 300), 0.5f);
}

TEST(Arch, a_heavy_weight_brings_it_down)
{
    const auto scene = make_scene("arch", {{"weight", 500}});
    scene->key("space");
    EXPECT_GT(farthest_way(*scene, 400), 0.5f);
}

} // namespace carom::scenes
