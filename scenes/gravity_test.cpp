// The gravity scene: the pyramid, the ball, dropping and taking away.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

const ParameterValues empty = {{"pyramid", 0}, {"pile", 0}, {"ball", false}};

} // namespace

TEST(Gravity, the_pyramid_stands)
{
    const auto scene = make_scene("gravity", {{"pile", 0}, {"ball", false}});
    const BodyId top = scene->world().bodies().back();
    const Vec2 before = scene->world().body(top).position();
    step(*scene, 600);
    EXPECT_NEAR(distance(scene->world().body(top).position(), before), 0, 0.1);
}

TEST(Gravity, the_ball_knocks_it_over)
{
    const auto scene = make_scene("gravity", {{"pile", 0}});
    const BodyId top = scene->world().bodies()[78]; // after the ground the bricks, and the ball at the end
    const float before = scene->world().body(top).position().y;
    step(*scene, 200);
    EXPECT_NEAR(scene->world().body(top).position().y, before, 0.1);
    step(*scene, 300);
    EXPECT_LT(scene->world().body(top).position().y, before - 2);
}

TEST(Gravity, every_kind_can_be_dropped_and_comes_to_rest)
{
    const auto scene = make_scene("gravity", empty);
    for (int kind = 0; kind < 5; ++kind)
    {
        scene->key(std::to_string(kind + 1));
        click(*scene, {-4 + 2 * static_cast<float>(kind), 2});
    }
    step(*scene, 400);
    const std::vector<BodyId> bodies = scene->world().bodies();
    ASSERT_EQ(bodies.size(), 6u);
    for (std::size_t i = 1; i < bodies.size(); ++i)
    {
        EXPECT_LT(std::abs(scene->world().body(bodies[i]).linear_velocity().y), 0.05f);
        EXPECT_GT(scene->world().body(bodies[i]).position().y, 0.1f);
    }
}

TEST(Gravity, the_pointer_takes_bodies_away)
{
    const auto scene = make_scene("gravity", empty);
    click(*scene, {0, 5});
    EXPECT_EQ(scene->world().body_count(), 2);
    click(*scene, {3, 5}, PointerEvent::Button::Right);
    EXPECT_EQ(scene->world().body_count(), 2);
    click(*scene, {0, 5}, PointerEvent::Button::Right);
    EXPECT_EQ(scene->world().body_count(), 1);
    click(*scene, {0, -2}, PointerEvent::Button::Right); // the ground stays
    EXPECT_EQ(scene->world().body_count(), 1);
}

TEST(Gravity, clear_takes_away_everything_but_the_ground)
{
    const auto scene = make_scene("gravity");
    step(*scene, 60);
    scene->key("c");
    EXPECT_EQ(scene->world().body_count(), 1);
    step(*scene, 10);
    DrawList list;
    scene->draw(list);
    EXPECT_EQ(list.layer(Layer::Bodies).shapes.size(), 6u);
}

TEST(Gravity, size_stays_in_its_range)
{
    const auto scene = make_scene("gravity", empty);
    for (int i = 0; i < 100; ++i) scene->key("up");
    EXPECT_EQ(scene->parameters().real("size"), 5);
    for (int i = 0; i < 100; ++i) scene->pointer({PointerEvent::Action::Wheel, PointerEvent::Button::None, {}, -100});
    EXPECT_NEAR(scene->parameters().real("size"), 0.2, 1e-6);
    click(*scene, {0, 5});
    EXPECT_EQ(scene->world().body_count(), 2);
}

TEST(Gravity, what_falls_off_the_ground_is_taken_away)
{
    const auto scene = make_scene("gravity", empty);
    click(*scene, {60, 5});
    EXPECT_EQ(scene->world().body_count(), 2);
    step(*scene, 300);
    EXPECT_EQ(scene->world().body_count(), 1);
}

TEST(Gravity, gravity_can_be_turned_around)
{
    const auto scene = make_scene("gravity", empty);
    scene->key("g");
    EXPECT_NEAR(scene->world().gravity().y, 9.81, 1e-5);
}

} // namespace carom::scenes
