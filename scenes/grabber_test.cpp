// Dragging: what is taken hold of, what happens to it, and when it is let go.
#include "scenes/grabber.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

using Action = PointerEvent::Action;

PointerEvent event(Action action, Vec2 place) { return {.action = action, .button = PointerEvent::Button::Left, .position = place}; }

} // namespace

TEST(Grabber, drags_a_body_by_the_point_that_was_taken)
{
    World world({.gravity = {0, 0}});
    const BodyId body = world.create_body({.angular_damping = 3}, box(2, 1));
    Grabber grabber;
    EXPECT_TRUE(grabber.on_pointer(world, event(Action::Down, {0.8f, 0.3f})));
    EXPECT_TRUE(grabber.on_pointer(world, event(Action::Move, {5, 4})));
    for (int i = 0; i < 240; ++i) world.step(1 / 60.0f);
    EXPECT_LT(distance(world.body(body).transform() * Vec2{0.8f, 0.3f}, {5, 4}), 0.01f);
    EXPECT_TRUE(grabber.on_pointer(world, event(Action::Up, {5, 4})));
    EXPECT_EQ(world.joint_count(), 0);
    EXPECT_FALSE(grabber.holds(world));
}

TEST(Grabber, takes_neither_air_nor_what_stands_fast)
{
    World world;
    world.create_body({.type = BodyType::Static}, box(2, 2));
    world.create_body({.type = BodyType::Kinematic, .position = {5, 0}}, box(2, 2));
    Grabber grabber;
    for (const Vec2 place : {Vec2{0, 0}, {5, 0}, {9, 9}}) EXPECT_FALSE(grabber.on_pointer(world, event(Action::Down, place)));
    EXPECT_FALSE(grabber.on_pointer(world, event(Action::Move, {1, 1})));
    EXPECT_FALSE(grabber.on_pointer(world, event(Action::Up, {1, 1})));
    EXPECT_EQ(world.joint_count(), 0);
}

TEST(Grabber, wakes_what_sleeps)
{
    World world({.gravity = {0, 0}});
    const BodyId body = world.create_body({}, circle(1));
    world.body(body).set_awake(false);
    Grabber grabber;
    grabber.on_pointer(world, event(Action::Down, {}));
    grabber.on_pointer(world, event(Action::Move, {3, 0}));
    for (int i = 0; i < 60; ++i) world.step(1 / 60.0f);
    EXPECT_GT(world.body(body).position().x, 2);
}

TEST(Grabber, outlives_the_body_that_it_holds_and_takes_another_without_letting_go)
{
    World world({.gravity = {0, 0}});
    const BodyId first = world.create_body({}, circle(1));
    const BodyId second = world.create_body({.position = {5, 0}}, circle(1));
    Grabber grabber;
    grabber.on_pointer(world, event(Action::Down, {}));
    grabber.on_pointer(world, event(Action::Down, {5, 0}));
    EXPECT_EQ(world.joint_count(), 1);
    EXPECT_EQ(world.joints_of(first).size(), 0u);
    world.destroy_body(second);
    EXPECT_FALSE(grabber.on_pointer(world, event(Action::Move, {1, 1})));
    EXPECT_FALSE(grabber.on_pointer(world, event(Action::Up, {1, 1})));
    EXPECT_TRUE(grabber.on_pointer(world, event(Action::Down, {})));
    DrawList list;
    grabber.draw(world, list);
    EXPECT_EQ(list.layer(Layer::Marks).lines.size(), 1u);
}

} // namespace carom::scenes
