// Joints at work: what happens when they, or their bodies, change, and when they break.
#include "api/joint_world_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace carom::joint_tests
{

// ---- the joint ----

TEST_F(JointTest, ASpecCanChangeWhileItRuns)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), RevoluteJoint{});
    step(10);
    EXPECT_NEAR(world.joint(id).angle(), 0, 1e-4);
    world.joint(id).set_spec(RevoluteJoint{.motor = Motor{2, 1000}});
    step(60);
    EXPECT_NEAR(world.body(a).angular_velocity(), 2, 1e-3);
    world.joint(id).set_spec(RevoluteJoint{.limit = Range{-0.1f, 0.1f}});
    step(120);
    EXPECT_NEAR(world.joint(id).angle(), 0.1f, 0.01f) << "pushed back into its range";
    world.joint(id).set_spec(RevoluteJoint{.spring = Spring{2, 1, -1}});
    step(240);
    EXPECT_NEAR(world.joint(id).angle(), -1, 0.01f);
}

TEST_F(JointTest, AChangeOfFormStartsCold)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), WeldJoint{});
    step(30);
    EXPECT_NEAR(world.joint(id).force().y, 10, 0.1f);
    world.joint(id).set_spec(WeldJoint{.linear = Spring{3, 1}});
    EXPECT_EQ(world.joint(id).force(), Vec2{});
    step(300);
    EXPECT_NEAR(world.joint(id).force().y, 10, 0.1f);
    EXPECT_LT(world.body(a).position().y, -0.01f) << "the spring gives way";
}

TEST_F(JointTest, FramesCanChangeWhileItRuns)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), WeldJoint{});
    step(10);
    world.joint(id).set_frames({{0, 1}, {}}, {});
    step(120);
    EXPECT_NEAR(world.body(a).position().y, 1, 1e-3);
    EXPECT_EQ(world.joint(id).frame_a().p, (Vec2{0, 1}));
    world.joint(id).set_frames({}, {{0, 1}, {}}); // A's centre comes to lie 1 m below
    step(120);
    EXPECT_NEAR(world.body(a).position().y, -1, 1e-3);
    EXPECT_EQ(world.joint(id).frame_b().p, (Vec2{0, 1}));
}

TEST_F(JointTest, UserDataAndBreakLimitsCanChange)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), WeldJoint{});
    world.joint(id).set_user_data(5);
    world.joint(id).set_break_limits(3, inf);
    EXPECT_EQ(world.joint(id).user_data(), 5u);
    EXPECT_EQ(world.joint(id).break_force(), 3);
    EXPECT_EQ(world.joint(id).break_torque(), inf);
}

TEST_F(JointTest, AnAngleIsCountedOverFullTurns)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), RevoluteJoint{.motor = Motor{10, 1e5f}});
    step(180);
    EXPECT_NEAR(world.joint(id).angle(), 30, 0.2f);
    world.joint(id).set_spec(RevoluteJoint{.motor = Motor{-10, 1e5f}});
    step(360);
    EXPECT_NEAR(world.joint(id).angle(), -30, 0.5f);
}

TEST_F(JointTest, ALimitMayBeWiderThanATurn)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), RevoluteJoint{.limit = Range{-15, 15}, .motor = Motor{6, 100}});
    step(120);
    EXPECT_NEAR(world.joint(id).angle(), 12, 0.1f) << "free within two turns";
    step(120);
    EXPECT_NEAR(world.joint(id).angle(), 15, 0.02f);
    EXPECT_NEAR(world.body(a).angular_velocity(), 0, 0.02f);
    world.joint(id).set_spec(RevoluteJoint{.limit = Range{-15, 15}, .motor = Motor{-6, 100}});
    step(400);
    EXPECT_NEAR(world.joint(id).angle(), -15, 0.02f);
}

TEST_F(JointTest, ATeleportCountsNoTurn)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), RevoluteJoint{});
    world.body(a).set_transform({0, 0}, 3);
    EXPECT_NEAR(world.joint(id).angle(), 3, 1e-5);
    step(1);
    world.body(a).set_transform({0, 0}, -3); // the short way from 3
    EXPECT_NEAR(world.joint(id).angle(), 2 * pi - 3, 1e-5);
}

// ---- bodies ----

TEST_F(JointTest, ADestroyedBodyTakesItsJointsAlong)
{
    const JointId both = world.create_joint(world.joint_at(a, b, {1, 0}), RevoluteJoint{});
    const JointId other = world.create_joint(world.joint_at({}, b, {2, 0}), RevoluteJoint{});
    step(3);
    world.destroy_body(a);
    EXPECT_FALSE(world.find_joint(both));
    EXPECT_TRUE(world.find_joint(other));
    EXPECT_EQ(world.joints_of(b), (std::vector<JointId>{other}));
    step(30);
    EXPECT_TRUE(world.events().joint_break.empty()) << "no break: it was taken away";
    EXPECT_NEAR(world.body(b).position().y, 0, 1e-3);
}

TEST_F(JointTest, ADisabledBodyHoldsNothingAndIsHeldAgain)
{
    world.create_joint(world.joint_at({}, a, {0, 0}), WeldJoint{});
    world.create_joint(world.joint_at(a, b, {1, 0}), WeldJoint{});
    step(30);
    EXPECT_NEAR(world.body(b).position().y, 0, 1e-3);
    world.body(a).set_enabled(false);
    step(6);
    EXPECT_LT(world.body(b).position().y, -0.02f) << "falls";
    world.body(a).set_enabled(true);
    step(120);
    EXPECT_NEAR(world.body(b).position().y, 0, 0.01f);
    EXPECT_NEAR(world.body(b).position().x, 2, 0.01f);
}

TEST_F(JointTest, AStaticBodyIsAsGoodAsTheWorld)
{
    const JointId id = world.create_joint(world.joint_at(a, b, {1, 0}), WeldJoint{});
    world.body(a).set_type(BodyType::Static);
    step(60);
    EXPECT_NEAR(world.body(b).position().y, 0, 1e-3);
    EXPECT_NEAR(world.joint(id).force().y, 10, 0.1f);
    world.body(b).set_type(BodyType::Static);
    const Vec2 there = world.body(b).position();
    step(5);
    EXPECT_EQ(world.body(b).position(), there);
    world.body(b).set_type(BodyType::Dynamic);
    world.body(a).set_type(BodyType::Dynamic);
    step(60);
    EXPECT_LT(world.body(a).position().y, -1) << "both fall";
    EXPECT_LT(world.joint(id).error(), 1e-3f);
}

TEST_F(JointTest, AKinematicBodyLeads)
{
    const BodyId leader = world.create_body({.type = BodyType::Kinematic, .position = {0, 5}, .linear_velocity = {1, 0}});
    const BodyId load = world.create_body({.position = {0, 3}}, circle(0.2f));
    const JointId rod = world.create_joint(world.joint_between(leader, load, {0, 5}, {0, 3}), DistanceJoint{.length = 2});
    step(300);
    EXPECT_NEAR(world.body(leader).position().x, 5, 1e-3);
    EXPECT_LT(std::abs(world.body(load).position().x - 5), 1.5f);
    EXPECT_LT(world.joint(rod).error(), 1e-3f);
}

TEST_F(JointTest, LockedAxesAreHeeded)
{
    world.body(b).set_locks({.x = true, .rotation = true});
    const JointId id = world.create_joint(world.joint_between({}, b, {2, 3}, {2, 0}), DistanceJoint{.length = 3});
    step(120);
    EXPECT_EQ(world.body(b).position().x, 2);
    EXPECT_NEAR(world.body(b).position().y, 0, 1e-3);
    EXPECT_NEAR(world.joint(id).force().y, 10, 0.1f);
    world.body(b).set_locks({true, true, true}); // nothing left to push
    step(10);
    EXPECT_TRUE(is_finite(world.joint(id).force()));
}

// ---- what the two bodies may touch ----

TEST_F(JointTest, ConnectedBodiesTouchOnlyWhenTheyMay)
{
    World flat({.gravity = {}});
    const auto touching = [&](BodyId body) { return !flat.shape(flat.body(body).shapes()[0]).touching().empty(); };
    const BodyId first = flat.create_body({.position = {0, 0}}, box(1, 1));
    const BodyId second = flat.create_body({.position = {0.9f, 0}}, box(1, 1));
    flat.step(dt);
    EXPECT_TRUE(touching(first));

    const JointId id = flat.create_joint(flat.joint_at(first, second, {0.45f, 0}), RevoluteJoint{});
    EXPECT_FALSE(touching(first)) << "the contact ends with the joint";
    flat.step(dt);
    EXPECT_FALSE(touching(first));
    EXPECT_EQ(flat.events().contact_end.size(), 1u);

    flat.joint(id).set_collide_connected(true);
    flat.step(dt);
    EXPECT_TRUE(touching(first));
    flat.joint(id).set_collide_connected(false);
    flat.step(dt);
    EXPECT_FALSE(touching(first));

    flat.destroy_joint(id);
    flat.step(dt);
    EXPECT_TRUE(touching(first)) << "and comes back without it";
}

TEST_F(JointTest, OneOfTwoJointsIsEnoughToKeepBodiesApart)
{
    World flat({.gravity = {}});
    const BodyId first = flat.create_body({.position = {0, 0}}, box(1, 1));
    const BodyId second = flat.create_body({.position = {0.9f, 0}}, box(1, 1));
    JointDef def = flat.joint_at(first, second, {0.45f, 0});
    const JointId quiet = flat.create_joint(def, RevoluteJoint{});
    def.collide_connected = true;
    const JointId loud = flat.create_joint(def, RevoluteJoint{});
    const auto touching = [&]
    {
        flat.step(dt);
        return !flat.shape(flat.body(first).shapes()[0]).touching().empty();
    };
    EXPECT_FALSE(touching());
    flat.joint(loud).set_collide_connected(false);
    flat.joint(loud).set_collide_connected(true);
    EXPECT_FALSE(touching());
    flat.destroy_joint(quiet);
    EXPECT_TRUE(touching());
}

// ---- breaking ----

TEST_F(JointTest, BreaksUnderAForceAndTellsOnce)
{
    JointDef def = world.joint_at({}, a, {0, 0});
    def.user_data = 9;
    def.break_force = 20;
    const JointId id = world.create_joint(def, WeldJoint{}); // carries 10 N
    step(60);
    EXPECT_TRUE(world.find_joint(id));
    world.body(a).apply_force_to_center({0, -30});
    step(1);
    ASSERT_EQ(world.events().joint_break.size(), 1u);
    const JointBreak& event = world.events().joint_break[0];
    EXPECT_EQ(event.joint, id);
    EXPECT_EQ(event.body_a, BodyId{});
    EXPECT_EQ(event.body_b, a);
    EXPECT_NEAR(event.force, 40, 1);
    EXPECT_EQ(event.user_data, 9u);
    EXPECT_FALSE(world.find_joint(id));
    step(1);
    EXPECT_TRUE(world.events().joint_break.empty());
    step(60);
    EXPECT_LT(world.body(a).position().y, -3);
}

TEST_F(JointTest, BreaksUnderATorque)
{
    JointDef def = world.joint_at(a, b, {1, 0});
    def.break_torque = 5;
    const JointId id = world.create_joint(def, WeldJoint{});
    world.body(a).set_type(BodyType::Static); // B's weight of 10 N now hangs on a lever of 1 m
    int breaks = 0;
    for (int i = 0; i < 60; ++i)
    {
        step(1);
        for (const JointBreak& event : world.events().joint_break)
        {
            ++breaks;
            EXPECT_EQ(event.joint, id);
            EXPECT_EQ(event.body_a, a);
            EXPECT_GT(event.torque, 5);
        }
    }
    EXPECT_EQ(breaks, 1);
}

TEST_F(JointTest, SeveralBreaksComeInOrder)
{
    std::vector<JointId> ids;
    for (const BodyId body : {b, a})
    {
        JointDef def = world.joint_at({}, body, world.body(body).position());
        def.break_force = 1;
        ids.push_back(world.create_joint(def, WeldJoint{}));
    }
    step(1);
    ASSERT_EQ(world.events().joint_break.size(), 2u);
    EXPECT_EQ(world.events().joint_break[0].joint, ids[0]);
    EXPECT_EQ(world.events().joint_break[1].joint, ids[1]);
    EXPECT_EQ(world.joint_count(), 0);
}

// ---- the rest ----

TEST_F(JointTest, AMouseMovesABodyToItsTarget)
{
    const JointId id =
        world.create_joint(world.joint_at({}, a, {0.4f, 0}), MouseJoint{.target = {0.4f, 0}, .spring = {3, 1}, .max_force = 500});
    for (int i = 0; i < 120; ++i)
    {
        world.joint(id).set_spec(MouseJoint{.target = {0.4f, 0.02f * static_cast<float>(i)}, .spring = {3, 1}, .max_force = 500});
        step(1);
    }
    step(300);
    const Vec2 held = world.body(a).transform() * Vec2{0.4f, 0};
    EXPECT_NEAR(held.x, 0.4f, 0.05f);
    EXPECT_NEAR(held.y, 2.38f, 0.05f);
}

TEST_F(JointTest, AMotorJointLeadsWithALimitedForce)
{
    World flat({.gravity = {}});
    const BodyId body = flat.create_body({}, box(1, 1), {.density = 2});
    const JointId id = flat.create_joint(flat.joint_at({}, body, {}),
                                         MotorJoint{.offset = {3, 0}, .angle = 1, .spring = {2, 1}, .max_force = 4, .max_torque = 1});
    flat.step(dt);
    EXPECT_NEAR(length(flat.joint(id).force()), 4, 0.01f) << "all the force that it has";
    for (int i = 0; i < 600; ++i) flat.step(dt);
    EXPECT_NEAR(flat.body(body).position().x, 3, 0.01f);
    EXPECT_NEAR(flat.body(body).angle(), 1, 0.01f);
}

TEST_F(JointTest, EditsAreRefusedDuringAStepAndTheCopyOfAStepIsEqual)
{
    // Two worlds with the same joints go the same way.
    const auto run = [](bool jitters)
    {
        World one;
        const BodyId first = one.create_body({.position = {1, 0}}, box(2, 0.2f));
        const BodyId second = one.create_body({.position = {3, 0}}, box(2, 0.2f));
        one.create_joint(one.joint_at({}, first, {0, 0}), RevoluteJoint{});
        const JointId id = one.create_joint(one.joint_at(first, second, {2, 0}), RevoluteJoint{.limit = Range{-1, 1}});
        for (int i = 0; i < 200; ++i)
        {
            if (jitters && i == 100) one.joint(id).set_break_limits(1e6f, 1e6f);
            one.step(dt);
        }
        return one.hash();
    };
    EXPECT_EQ(run(false), run(false));
    EXPECT_NE(run(false), run(true)) << "break limits are state";
}

TEST_F(JointTest, AWarmStepWithJointsAllocatesNothing)
{
    BodyId before;
    for (int i = 0; i < 30; ++i)
    {
        const float x = 5 + static_cast<float>(i);
        const BodyId body = world.create_body({.position = {x + 0.5f, 0}}, box(1, 0.2f), {.filter = {.group = -1}});
        world.create_joint(world.joint_at(before, body, {x, 0}), RevoluteJoint{});
        before = body;
    }
    step(30);
    for (int i = 0; i < 120; ++i) EXPECT_EQ(world.step(dt).allocations, 0u) << i;
}

} // namespace carom::joint_tests
