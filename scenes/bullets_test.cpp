#include "scenes/registry.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace carom::scenes
{

namespace
{

/// Dynamic bodies outside of the field after a while.
int outside(Scene& scene, int steps)
{
    int count = 0;
    for (int i = 0; i < steps; ++i)
    {
        scene.step();
        for (const BodyId id : scene.world().bodies())
        {
            const BodyView body = scene.world().body(id);
            const Vec2 p = body.position();
            count += body.type() == BodyType::Dynamic && (std::abs(p.x) > 20 || p.y < 0 || p.y > 22) ? 1 : 0;
        }
    }
    return count;
}

std::string status_of(const Scene& scene)
{
    DrawList list;
    scene.draw(list);
    std::string all;
    for (const DrawnText& text : list.layer(Layer::Captions).texts) all += text.text + "\n";
    return all;
}

} // namespace

TEST(Bullets, none_escapes)
{
    const auto scene = make_scene("bullets");
    EXPECT_EQ(outside(*scene, 1800), 0);
    EXPECT_NE(status_of(*scene).find(" 0 escaped"), std::string::npos) << status_of(*scene);
}

/// Lively ones whirl at thousands of radians in a second.
TEST(Bullets, none_escapes_at_any_speed)
{
    for (const double speed : {300.0, 900.0, 2000.0})
        for (const double restitution : {0.3, 1.0})
            for (const std::uint64_t seed : {5u, 6u})
            {
                const auto scene = make_scene("bullets", {{"speed", speed}, {"restitution", restitution}}, seed);
                for (int i = 0; i < 600; ++i) scene->step();
                EXPECT_NE(status_of(*scene).find(" 0 escaped"), std::string::npos) << status_of(*scene) << ", seed " << seed;
            }
}

TEST(Bullets, they_do_without_continuous_collision)
{
    const auto scene = make_scene("bullets", {{"speed", 900.0}});
    scene->key("c");
    EXPECT_FALSE(scene->world().is_continuous());
    for (int i = 0; i < 120; ++i) scene->step();
    EXPECT_EQ(status_of(*scene).find(" 0 escaped"), std::string::npos) << status_of(*scene);
}

} // namespace carom::scenes
