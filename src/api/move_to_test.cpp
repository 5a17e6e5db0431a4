// Kinematic bodies that are led from place to place: they arrive exactly, carry what stands on them, and refuse what can't be.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace carom
{

namespace
{

/// A closed path that turns as it goes.
Transform on_path(int step)
{
    const float t = 0.01f * static_cast<float>(step);
    return {{100 + 5 * std::sin(t), 3 * std::sin(2 * t)}, rotation(2 * std::sin(0.7f * t))};
}

} // namespace

TEST(MoveTo, arrives_exactly_after_each_of_10000_steps)
{
    World world;
    const BodyId id = world.create_body({.type = BodyType::Kinematic, .position = {100, 0}}, offset_box(2, 1, {0.3f, 0.1f}));
    for (int i = 1; i <= 10'000; ++i)
    {
        const Transform target = on_path(i);
        world.body(id).move_to(target, dt);
        world.step(dt, 1 + i % 5);
        ASSERT_EQ(world.body(id).position(), target.p) << i;
        ASSERT_NEAR(relative(world.body(id).transform().q, target.q).s, 0, 1e-6f) << i;
    }
}

TEST(MoveTo, turns_the_shorter_way)
{
    for (const auto& [from, to] : {std::pair{3.0f, -3.0f}, {-3.0f, 3.0f}, {0.0f, 1.5f}, {0.0f, 3.1f}, {0.5f, 0.5f}})
    {
        World world;
        const BodyId id = world.create_body({.type = BodyType::Kinematic, .angle = from}, box(1, 1));
        world.body(id).move_to({{}, rotation(to)}, dt);
        EXPECT_LE(std::abs(world.body(id).angular_velocity()) * dt, pi + 1e-5f);
        EXPECT_NEAR(std::abs(world.body(id).angular_velocity()) * dt, std::abs(angle(relative(rotation(from), rotation(to)))), 1e-5f);
        world.step(dt, 1);
        EXPECT_NEAR(relative(world.body(id).transform().q, rotation(to)).s, 0, 1e-6f) << from << " to " << to;
    }
}

TEST(MoveTo, a_rider_on_a_lift_does_not_sink_and_moves_with_it)
{
    for (const Vec2 way : {Vec2{0, 0.02f}, Vec2{0, -0.02f}, Vec2{0.02f, 0}, Vec2{0.02f, 0.02f}})
    {
        World world;
        const BodyId lift = world.create_body({.type = BodyType::Kinematic}, box(4, 1));
        const BodyId rider = world.create_body({.position = {0, 1}}, box(1, 1));
        for (int i = 0; i < 60; ++i) world.step(dt);
        float deepest = 0;
        for (int i = 1; i <= 300; ++i)
        {
            world.body(lift).move_to({static_cast<float>(i) * way, {}}, dt);
            world.step(dt);
            deepest = std::min(deepest, world.body(rider).position().y - world.body(lift).position().y - 1);
        }
        EXPECT_EQ(world.body(lift).position(), 300.0f * way);
        EXPECT_GT(deepest, -0.005f) << way.x << ", " << way.y;
        EXPECT_NEAR(world.body(rider).position().x, world.body(lift).position().x, 0.2f) << "friction starts it";
    }
}

TEST(MoveTo, a_lift_that_is_led_to_where_it_is_comes_to_rest_with_its_rider)
{
    World world;
    const BodyId lift = world.create_body({.type = BodyType::Kinematic}, box(4, 1));
    const BodyId rider = world.create_body({.position = {0, 1}}, box(1, 1));
    for (int i = 1; i <= 300; ++i)
    {
        world.body(lift).move_to({{0, 0.02f * static_cast<float>(std::min(i, 100))}, rotation(0.1f)}, dt);
        world.step(dt);
    }
    EXPECT_FALSE(world.body(lift).is_awake());
    EXPECT_FALSE(world.body(rider).is_awake());
    world.body(lift).move_to({{0, 2.02f}, rotation(0.1f)}, dt);
    EXPECT_TRUE(world.body(lift).is_awake() && world.body(rider).is_awake());
}

TEST(MoveTo, goes_on_at_its_velocity_until_the_next_call)
{
    World world;
    const BodyId id = world.create_body({.type = BodyType::Kinematic}, box(1, 1));
    world.body(id).move_to({{0.1f, 0}, {}}, dt);
    EXPECT_NEAR(world.body(id).linear_velocity().x, 6, 1e-4f);
    world.step(dt);
    world.step(dt);
    EXPECT_NEAR(world.body(id).position().x, 0.2f, 1e-5f);
}

TEST(MoveTo, a_step_of_another_length_goes_by_the_velocity)
{
    World world;
    const BodyId id = world.create_body({.type = BodyType::Kinematic}, box(1, 1));
    world.body(id).move_to({{0.1f, 0}, {}}, dt);
    world.step(0.5f * dt);
    EXPECT_NEAR(world.body(id).position().x, 0.05f, 1e-5f);
}

TEST(MoveTo, what_is_set_after_it_counts)
{
    World world;
    const BodyId id = world.create_body({.type = BodyType::Kinematic}, box(1, 1));
    world.body(id).move_to({{0.1f, 0}, {}}, dt);
    world.body(id).set_linear_velocity({0, 6});
    world.step(dt);
    EXPECT_NEAR(world.body(id).position().x, 0, 1e-5f);
    EXPECT_NEAR(world.body(id).position().y, 0.1f, 1e-5f);
    world.body(id).move_to({{5, 0}, {}}, dt);
    world.body(id).set_transform({1, 1}, 0);
    world.body(id).set_linear_velocity({});
    world.step(dt);
    EXPECT_EQ(world.body(id).position(), (Vec2{1, 1}));
}

TEST(MoveTo, copies_lead_their_bodies_to_the_same_place)
{
    World world;
    const BodyId id = world.create_body({.type = BodyType::Kinematic}, box(1, 1));
    const std::uint64_t before = world.hash();
    world.body(id).move_to({{0.1f, 0.2f}, rotation(3)}, dt);
    EXPECT_NE(world.hash(), before);
    World copy = world.copy();
    EXPECT_EQ(copy.hash(), world.hash());
    world.step(dt);
    copy.step(dt);
    EXPECT_EQ(copy.hash(), world.hash());
    EXPECT_EQ(copy.body(copy.translated(id)).position(), (Vec2{0.1f, 0.2f}));
}

TEST(MoveTo, pushes_what_is_in_its_way)
{
    World world({.gravity = {}});
    const BodyId door = world.create_body({.type = BodyType::Kinematic}, box(0.2f, 2));
    const BodyId crate = world.create_body({.position = {2, 0}}, box(0.5f, 0.5f));
    for (int i = 1; i <= 120; ++i)
    {
        world.body(door).move_to({{0.05f * static_cast<float>(i), 0}, {}}, dt);
        world.step(dt);
        ASSERT_GT(world.body(crate).position().x - world.body(door).position().x, 0.3f) << i;
    }
    EXPECT_GT(world.body(crate).position().x, 6.3f);
}

TEST(MoveTo, refuses_other_bodies_and_bad_arguments_and_says_why)
{
    World world;
    Body lift = world.body(world.create_body({.type = BodyType::Kinematic}, box(1, 1)));
    Body crate = world.body(world.create_body({.position = {5, 0}}, box(1, 1)));
    Body rock = world.body(world.create_body({.type = BodyType::Static, .position = {9, 0}}, box(1, 1)));
    const auto refused = [](Body body, const Transform& target, float step, const std::string& part)
    {
        try
        {
            body.move_to(target, step);
        }
        catch (const UsageError& error)
        {
            return std::string(error.what()).find(part) != std::string::npos;
        }
        return false;
    };
    EXPECT_TRUE(refused(crate, {}, dt, "move_to: body is dynamic"));
    EXPECT_TRUE(refused(rock, {}, dt, "set_transform"));
    for (const float bad : {0.0f, -dt, nan, inf, 2.0f}) EXPECT_TRUE(refused(lift, {}, bad, "move_to: dt")) << bad;
    for (const float bad : {nan, inf, 2 * max_coordinate}) EXPECT_TRUE(refused(lift, {{0, bad}, {}}, dt, "target.p")) << bad;
    EXPECT_TRUE(refused(lift, {{}, {2, 0}}, dt, "target.q"));
    EXPECT_TRUE(refused(lift, {{}, {nan, 0}}, dt, "target.q"));
    EXPECT_TRUE(refused(lift, {{9e5f, 0}, {}}, dt, "1e6 m/s"));
    EXPECT_EQ(lift.linear_velocity(), Vec2{}) << "nothing has changed";
}

} // namespace carom
