// Joints that say the same twice, contradict each other or are made far from closed used to throw their bodies about, or out of the world.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace carom
{

namespace
{

struct Outcome
{
    float fastest = 0;    ///< [m/s]
    float farthest = 0;   ///< from the origin [m]
    float last_error = 0; ///< [m]
};

Outcome run(World& world, int steps)
{
    Outcome outcome;
    for (int i = 0; i < steps; ++i)
    {
        EXPECT_TRUE(world.step(1 / 60.0f).quarantined.empty());
        for (const BodyId id : world.bodies())
        {
            outcome.fastest = std::max(outcome.fastest, length(world.body(id).linear_velocity()));
            outcome.farthest = std::max(outcome.farthest, length(world.body(id).position()));
        }
    }
    for (const JointId id : world.joints()) outcome.last_error = std::max(outcome.last_error, world.joint(id).error());
    return outcome;
}

} // namespace

TEST(ContradictingJoints, two_rods_that_are_too_short_settle_between_their_ends)
{
    for (const float drop : {0.0f, 0.5f, 2.0f})
    {
        World world;
        const BodyId ball = world.create_body({.position = {0, -drop}}, circle(0.3f));
        for (const float side : {-5.0f, 5.0f})
            world.create_joint(world.joint_between({}, ball, {side, 0}, {0, -drop}), DistanceJoint{.length = 4});
        const Outcome outcome = run(world, 600);
        EXPECT_LT(outcome.fastest, 5) << drop;
        EXPECT_LT(outcome.farthest, drop + 0.1f) << drop;
        EXPECT_NEAR(outcome.last_error, 1, 0.1f) << drop;
    }
}

TEST(ContradictingJoints, two_pins_at_different_places_share_the_error)
{
    World world;
    const BodyId body = world.create_body({}, box(1, 1));
    world.create_joint(world.joint_at({}, body, {0, 0}), RevoluteJoint{});
    JointDef other = world.joint_at({}, body, {0.5f, 0});
    other.frame_a.p.x += 0.3f;
    world.create_joint(other, RevoluteJoint{});
    const Outcome outcome = run(world, 600);
    EXPECT_LT(outcome.fastest, 0.01f);
    EXPECT_LT(outcome.last_error, 0.3f);
}

TEST(ContradictingJoints, a_bridge_that_is_too_short_stays_in_one_place)
{
    World world;
    BodyId before;
    for (int i = 0; i < 20; ++i)
    {
        const float left = 0.5f * static_cast<float>(i);
        const BodyId plank = world.create_body({.position = {left + 0.25f, 0}}, box(0.5f, 0.1f));
        world.create_joint(world.joint_at(before, plank, {left, 0}), RevoluteJoint{});
        before = plank;
    }
    JointDef last = world.joint_at({}, before, {10, 0});
    last.frame_a.p.x += 1;
    world.create_joint(last, RevoluteJoint{});
    const Outcome outcome = run(world, 600);
    EXPECT_LT(outcome.fastest, 10);
    EXPECT_LT(outcome.farthest, 12);
    EXPECT_LT(outcome.last_error, 1);
}

TEST(ContradictingJoints, a_joint_made_far_from_closed_closes_before_its_bodies_sleep)
{
    World world({.gravity = {0, 0}});
    const BodyId body = world.create_body({.position = {10, 0}}, box(1, 1));
    JointDef def = world.joint_at({}, body, {10, 0});
    def.frame_a = {};
    const JointId weld = world.create_joint(def, WeldJoint{});
    run(world, 600);
    EXPECT_LT(world.joint(weld).error(), 1e-3f);
}

/// 30 x 30 discs, each pinned to four others: a third more rows than ways to move, and too wide to be solved together.
/// @param held_every of the discs of the upper row, every so many stands still
void make_net(World& world, int held_every)
{
    constexpr int side = 30;
    std::vector<BodyId> discs;
    for (int i = 0; i < side * side; ++i)
    {
        const bool is_held = i / side == side - 1 && i % side % held_every == 0;
        const Vec2 place{static_cast<float>(i % side), static_cast<float>(i / side)};
        discs.push_back(world.create_body({.type = is_held ? BodyType::Static : BodyType::Dynamic, .position = place}, circle(0.4f)));
    }
    for (int i = 0; i < side * side; ++i)
    {
        const Vec2 place{static_cast<float>(i % side), static_cast<float>(i / side)};
        const auto at = [&](int disc) { return discs[static_cast<std::size_t>(disc)]; };
        if (i % side + 1 < side) world.create_joint(world.joint_at(at(i), at(i + 1), place + Vec2{0.5f, 0}), RevoluteJoint{});
        if (i / side + 1 < side) world.create_joint(world.joint_at(at(i), at(i + side), place + Vec2{0, 0.5f}), RevoluteJoint{});
    }
}

TEST(RedundantJoints, a_net_of_pins_hangs)
{
    World world;
    make_net(world, 6);
    const Outcome outcome = run(world, 300);
    EXPECT_LT(outcome.fastest, 2);
    EXPECT_LT(outcome.last_error, 0.02f);
}

TEST(RedundantJoints, a_net_that_hangs_heavily_from_one_corner_does_not_tear)
{
    World world({.gravity = {0, -40}});
    make_net(world, 30);
    EXPECT_LT(run(world, 300).last_error, 0.5f); // 900 discs at one pin
}

TEST(RedundantJoints, a_ring_of_welds_holds)
{
    World world;
    std::vector<BodyId> ring;
    constexpr int count = 12;
    for (int i = 0; i < count; ++i)
    {
        const Rot q = rotation(2 * pi * static_cast<float>(i) / count);
        ring.push_back(world.create_body({.position = 3.0f * Vec2{q.c, q.s}, .angle = angle(q)}, box(0.3f, 1.5f)));
    }
    for (int i = 0; i < count; ++i)
    {
        const Rot q = rotation(2 * pi * (static_cast<float>(i) + 0.5f) / count);
        world.create_joint(
            world.joint_at(ring[static_cast<std::size_t>(i)], ring[static_cast<std::size_t>((i + 1) % count)], 3.0f * Vec2{q.c, q.s}),
            WeldJoint{});
    }
    world.create_joint(world.joint_at({}, ring[0], {3, 0}), RevoluteJoint{});
    const Outcome outcome = run(world, 600);
    EXPECT_LT(outcome.last_error, 1e-3f);
    EXPECT_LT(outcome.fastest, 12) << "it swings";
}

} // namespace carom
