// Joints that are made with their defaults do what their name says, and a motor joint can be told to keep what is there.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

namespace carom
{

TEST(JointDefaults, a_motor_reaches_its_speed)
{
    World world({.gravity = {}});
    const BodyId wheel = world.create_body({}, Circle{.radius = 0.5f}, {.density = 1});
    world.create_joint(world.joint_at({}, wheel, {}), RevoluteJoint{.motor = Motor{.speed = 3}});
    for (int i = 0; i < 60; ++i) world.step(dt);
    EXPECT_NEAR(world.body(wheel).angular_velocity(), 3, 1e-3f);
}

TEST(JointDefaults, a_motor_joint_leads_a_body_to_its_offset)
{
    World world;
    const BodyId body = world.create_body({}, box(1, 1), {.density = 1});
    world.create_joint({.body_b = body}, MotorJoint{.offset = {2, 1}, .angle = 0.5f, .spring = {.hertz = 5, .damping_ratio = 1}});
    for (int i = 0; i < 180; ++i) world.step(dt);
    EXPECT_NEAR(world.body(body).position().x, 2, 0.02f);
    EXPECT_NEAR(world.body(body).position().y, 1, 0.02f); // it hangs 1 cm below, as g / (2 pi hertz)^2 asks
    EXPECT_NEAR(world.body(body).angle(), 0.5f, 0.02f);
}

TEST(JointDefaults, a_mouse_joint_carries_a_body_to_its_target)
{
    World world;
    const BodyId body = world.create_body({}, box(1, 1), {.density = 1});
    world.create_joint({.body_b = body}, MouseJoint{.target = {2, 1}, .spring = {.hertz = 5, .damping_ratio = 1}});
    for (int i = 0; i < 180; ++i) world.step(dt);
    EXPECT_NEAR(world.body(body).position().x, 2, 0.02f);
    EXPECT_NEAR(world.body(body).position().y, 1, 0.02f);
}

TEST(MotorJointAsPlaced, keeps_two_bodies_where_they_stand)
{
    World world({.gravity = {}, .sleep = {.is_enabled = false}});
    const BodyId a = world.create_body({.position = {1, 2}, .angle = 0.3f}, box(1, 1), {.density = 1});
    const BodyId b = world.create_body({.position = {4, 1}, .angle = -1}, box(2, 1), {.density = 1});
    const JointDef def = {.body_a = a, .body_b = b};
    const MotorJoint spec = world.motor_joint_as_placed(def);
    EXPECT_NEAR(length(spec.offset), length(Vec2{3, -1}), 1e-5f);
    EXPECT_NEAR(spec.angle, -1.3f, 1e-5f);
    world.create_joint(def, spec);
    for (int i = 0; i < 60; ++i) world.step(dt);
    EXPECT_NEAR(distance(world.body(b).position(), {4, 1}), 0, 1e-4f);
    EXPECT_NEAR(world.body(b).angle(), -1, 1e-4f);
}

TEST(MotorJointAsPlaced, is_no_offset_where_the_frames_meet)
{
    World world;
    const BodyId a = world.create_body({}, box(1, 1));
    const BodyId b = world.create_body({.position = {3, 0}}, box(1, 1));
    const MotorJoint spec = world.motor_joint_as_placed(world.joint_at(a, b, {1, 1}));
    EXPECT_NEAR(length(spec.offset), 0, 1e-5f);
    EXPECT_NEAR(spec.angle, 0, 1e-5f);
}

TEST(MotorJointAsPlaced, refuses_a_pair_that_is_one_body)
{
    World world;
    const BodyId a = world.create_body({}, box(1, 1));
    EXPECT_THROW(world.motor_joint_as_placed({.body_a = a, .body_b = a}), UsageError);
}

} // namespace carom
