// Nothing passes through anything, unless continuous collision is off.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

constexpr Aabb frame{{-20, 0}, {20, 22}};

} // namespace

TEST(Bullets, none_escapes)
{
    const auto scene = make_scene("bullets");
    EXPECT_EQ(times_outside(*scene, frame, 1800), 0);
    EXPECT_NE(captions_of(*scene).find(" 0 escaped"), std::string::npos) << captions_of(*scene);
}

/// Lively ones whirl at thousands of radians in a second.
TEST(Bullets, none_escapes_at_any_speed)
{
    for (const double speed : {300.0, 900.0, 2000.0})
        for (const double restitution : {0.3, 1.0})
            for (const std::uint64_t seed : {5u, 6u})
            {
                const auto scene = make_scene("bullets", {{"speed", speed}, {"restitution", restitution}}, seed);
                step(*scene, 600);
                EXPECT_NE(captions_of(*scene).find(" 0 escaped"), std::string::npos) << captions_of(*scene) << ", seed " << seed;
            }
}

TEST(Bullets, they_do_without_continuous_collision)
{
    const auto scene = make_scene("bullets", {{"speed", 900.0}});
    scene->key("c");
    EXPECT_FALSE(scene->world().is_continuous());
    step(*scene, 120);
    EXPECT_NE(captions_of(*scene).find(" escaped"), std::string::npos) << captions_of(*scene);
    EXPECT_EQ(captions_of(*scene).find(" 0 escaped"), std::string::npos) << captions_of(*scene);
}

} // namespace carom::scenes
