// The arch scene: it stands by friction, and not without.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

TEST(Arch, stands_for_a_minute_without_sleep)
{
    const auto scene = make_scene("arch");
    scene->world().set_sleep_tuning({.is_enabled = false});
    EXPECT_LT(farthest_way(*scene, dynamic_bodies(*scene), 3600), 0.02f);
}

TEST(Arch, falls_without_friction)
{
    const auto scene = make_scene("arch", {{"friction", 0}});
    EXPECT_GT(farthest_way(*scene, dynamic_bodies(*scene), 300), 0.5f);
}

TEST(Arch, a_heavy_weight_brings_it_down)
{
    const auto scene = make_scene("arch", {{"weight", 500}});
    const std::vector<BodyId> stones = dynamic_bodies(*scene);
    scene->key("space");
    EXPECT_GT(farthest_way(*scene, stones, 400), 0.5f);
}

} // namespace carom::scenes
