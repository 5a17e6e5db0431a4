// A body that reaches the limit of the world is stopped there and reported; whatever took it there, its place is one that calls accept.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace carom
{

namespace
{

bool is_in_world(Vec2 p) { return std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate; }

/// Steps until a body is put aside, and expects that it was put aside at the limit.
void expect_stopped(World& world, BodyId id, const char* what)
{
    for (int i = 0; i < 600 && world.body(id).is_enabled(); ++i)
    {
        const StepReport report = world.step(dt);
        ASSERT_TRUE(is_in_world(world.body(id).position()) && is_in_world(world.body(id).center_of_mass())) << what << ", step " << i;
        for (std::size_t k = 0; k < report.quarantined.size(); ++k)
            EXPECT_EQ(report.quarantine_reasons[k], QuarantineReason::LeftWorld) << what;
        EXPECT_EQ(report.quarantined.size(), world.body(id).is_enabled() ? 0u : 1u) << what;
    }
    Body body = world.body(id);
    ASSERT_FALSE(body.is_enabled()) << what;
    EXPECT_EQ(body.linear_velocity(), Vec2{}) << what;
    EXPECT_NO_THROW(body.set_transform(body.position(), body.angle())) << what;
    EXPECT_NO_THROW(body.apply_force({}, body.center_of_mass())) << what;
    EXPECT_NO_THROW(world.cast_ray(body.position(), {1, 0})) << what;
}

} // namespace

TEST(LeftWorld, a_body_is_stopped_at_the_limit_on_every_side_at_every_speed)
{
    for (const Vec2 side : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}})
        for (const float speed : {500.0f, 3e4f, 1e6f})
            for (const BodyType type : {BodyType::Dynamic, BodyType::Kinematic})
            {
                World world({.gravity = {}});
                const BodyDef def = {.type = type, .position = 9.99e5f * side, .linear_velocity = speed * side};
                expect_stopped(world, world.create_body(def, circle(0.5f)), speed < 1e6f ? "slow" : "fast");
            }
}

TEST(LeftWorld, the_centre_of_mass_counts_as_well_as_the_origin)
{
    World world({.gravity = {}});
    const BodyId id = world.create_body({.position = {max_coordinate - 100, 0}, .linear_velocity = {20, 0}}, offset_box(1, 1, {90, 0}));
    expect_stopped(world, id, "its centre is first");
}

TEST(LeftWorld, a_bullet_that_is_stopped_by_another_stays_inside)
{
    World world({.gravity = {}});
    const BodyId wall = world.create_body({.position = {max_coordinate - 50, 0}, .linear_velocity = {3000, 0}}, box(1, 10));
    const BodyId bullet =
        world.create_body({.position = {max_coordinate - 200, 0}, .linear_velocity = {2e4f, 0}, .is_bullet = true}, circle(0.1f));
    for (int i = 0; i < 60; ++i)
    {
        world.step(dt);
        for (const BodyId id : {wall, bullet}) ASSERT_TRUE(is_in_world(world.body(id).position())) << i;
    }
}

/// What a kinematic body carries along may leave the world though its own displacement would not.
TEST(LeftWorld, what_is_carried_stays_inside)
{
    World world({.gravity = {}});
    const BodyId bat =
        world.create_body({.type = BodyType::Kinematic, .position = {max_coordinate - 30, 0}, .linear_velocity = {1200, 0}}, box(0.5f, 10));
    const BodyId ball = world.create_body({.position = {max_coordinate - 15, 0}}, circle(0.1f));
    for (int i = 0; i < 60; ++i)
    {
        world.step(dt);
        for (const BodyId id : {bat, ball}) ASSERT_TRUE(is_in_world(world.body(id).position())) << i;
    }
}

/// The frames of joints move with bodies: they are as near to the limit as the bodies allow.
TEST(LeftWorld, a_joint_does_not_drag_a_body_out)
{
    World world({.gravity = {}});
    const BodyId head = world.create_body({.position = {max_coordinate - 20, 0}, .linear_velocity = {2000, 0}}, circle(0.5f));
    const BodyId tail = world.create_body({.position = {max_coordinate - 25, 0}}, circle(0.5f));
    world.create_joint(world.joint_between(head, tail, {max_coordinate - 20, 0}, {max_coordinate - 25, 0}), DistanceJoint{.length = 5});
    for (int i = 0; i < 300; ++i)
    {
        world.step(dt);
        for (const BodyId id : {head, tail}) ASSERT_TRUE(is_in_world(world.body(id).position())) << i;
    }
    EXPECT_FALSE(world.body(head).is_enabled());
    for (const BodyId id : {head, tail}) EXPECT_NO_THROW(world.joint_at({}, id, world.body(id).position()));
}

} // namespace carom
