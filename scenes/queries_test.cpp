// The queries scene: what it shows follows the bodies.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

std::size_t lines(const Scene& scene, Layer layer)
{
    DrawList list;
    scene.draw(list);
    return list.layer(layer).lines.size();
}

} // namespace

TEST(QueriesScene, every_ray_ends_somewhere)
{
    const auto scene = make_scene("queries", {{"rays", 100}});
    for (int i = 0; i < 60; ++i) scene->step();
    EXPECT_EQ(lines(*scene, Layer::Trails), 100u + 2u) << "the field is closed; two lines are the way of the box";
}

TEST(QueriesScene, a_click_pushes_what_is_near)
{
    const auto scene = make_scene("queries", {{"speed", 0}});
    for (const BodyId body : scene->world().bodies())
        if (scene->world().body(body).type() == BodyType::Dynamic) scene->world().body(body).set_linear_velocity({});
    scene->pointer({PointerEvent::Action::Move, PointerEvent::Button::None, {0, 0}});
    click(*scene, {0, 0});
    int moving = 0;
    for (const BodyId body : scene->world().bodies())
    {
        const Vec2 velocity = scene->world().body(body).linear_velocity();
        if (velocity == Vec2{}) continue;
        ++moving;
        EXPECT_GT(dot(velocity, scene->world().body(body).center_of_mass()), 0) << "away from the click";
    }
    EXPECT_GT(moving, 0);
    EXPECT_LT(moving, scene->world().body_count() - 1);
}

TEST(QueriesScene, what_overlaps_the_circle_shines)
{
    const auto shining = [](const Scene& scene)
    {
        DrawList list;
        scene.draw(list);
        std::size_t count = 0;
        for (const DrawnShape& shape : list.layer(Layer::Bodies).shapes) count += shape.paint.line == rgb(1.0f, 0.84f, 0.25f);
        return count;
    };
    const auto scene = make_scene("queries", {{"bodies", 60}});
    scene->pointer({PointerEvent::Action::Move, PointerEvent::Button::None, {0, 0}});
    for (int i = 0; i < 30; ++i) scene->pointer({PointerEvent::Action::Wheel, PointerEvent::Button::None, {0, 0}, 5});
    const std::size_t with_large = shining(*scene);
    EXPECT_GT(with_large, 5u);
    for (int i = 0; i < 30; ++i) scene->pointer({PointerEvent::Action::Wheel, PointerEvent::Button::None, {0, 0}, -5});
    EXPECT_LT(shining(*scene), with_large);
}

} // namespace carom::scenes
