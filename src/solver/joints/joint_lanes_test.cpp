// The joint solver in four lanes gives the bits of the scalar one.
#include "math/same_bits_test.hpp"
#include "solver/joints/four_lanes.hpp"
#include "solver/joints/joint_solver_impl.hpp"
#include "solver/rows/integrate.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory_resource>
#include <random>
#include <vector>

namespace carom::detail
{

template class JointSolver<FourLanes>;

namespace
{

/// Bodies of every type with joints of every type among them; one body has more joints than there are colours.
struct RandomNet
{
    explicit RandomNet(unsigned seed) : engine(seed)
    {
        for (std::uint32_t i = 0; i < body_count; ++i)
        {
            const BodyType type = i % 7 == 5 ? BodyType::Kinematic : i % 7 == 6 ? BodyType::Static : BodyType::Dynamic;
            const bool moves = type == BodyType::Dynamic; // kinematic ones that move would tear at each other through the joints
            bodies.create({.type = type,
                           .position = {from(-3, 3), from(-3, 3)},
                           .angle = from(-3, 3),
                           .linear_velocity = moves ? Vec2{from(-3, 3), i % 2 == 0 ? -0.0f : from(-3, 3)} : Vec2{},
                           .angular_velocity = moves ? from(-3, 3) : 0.0f,
                           .locks = {.x = i % 11 == 3, .y = i % 13 == 4, .rotation = i % 5 == 1}});
        }
        for (BodyMass& mass : bodies.masses)
            if (mass.inv_mass != Vec2{}) mass.inv_inertia = from(0, 3);
        for (std::uint32_t i = 1; i < body_count; ++i) connect(0, i);
        for (int i = 0; i < 25; ++i)
        {
            const std::uint32_t b = below(body_count); // a line each: the order of arguments is the compiler's
            connect(below(body_count), b);
        }
        for (int i = 0; i < 10; ++i) connect(null_index, below(body_count));
    }

    float from(float min, float max) { return std::uniform_real_distribution<float>(min, max)(engine); }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine() % n); }
    bool coin() { return engine() % 2 == 0; }

    Spring spring() { return {coin() ? 0.0f : from(0, 30), from(0, 2), from(-1, 1)}; }
    std::optional<Spring> maybe_spring() { return coin() ? std::optional(spring()) : std::nullopt; }
    std::optional<Motor> motor() { return coin() ? std::optional(Motor{from(-5, 5), from(0, 100)}) : std::nullopt; }
    std::optional<Range> range(float min, float max)
    {
        if (coin()) return std::nullopt;
        const float low = from(min, max);
        return Range{low, from(low, max)};
    }
    GearMotion motion() { return coin() ? GearMotion::Turn : GearMotion::Slide; }

    JointSpec spec()
    {
        switch (below(9))
        {
        case 0: return RevoluteJoint{range(-3, 3), motor(), maybe_spring()};
        case 1: return PrismaticJoint{range(-3, 3), motor(), maybe_spring()};
        case 2: return DistanceJoint{from(0.1f, 3), range(0, 5), maybe_spring()};
        case 3: return WeldJoint{maybe_spring(), maybe_spring()};
        case 4: return WheelJoint{maybe_spring(), range(-3, 3), motor()};
        case 5: return MotorJoint{{from(-1, 1), from(-1, 1)}, from(-3, 3), spring(), from(0, 50), from(0, 50)};
        case 6: return MouseJoint{{from(-3, 3), from(-3, 3)}, spring(), from(0, 50)};
        case 7: return GearJoint{from(0.1f, 3), motion(), motion()};
        default: return PulleyJoint{{from(-3, 3), 9}, {from(-3, 3), 9}, from(0.5f, 2), from(10, 25)};
        }
    }

    void connect(std::uint32_t a, std::uint32_t b)
    {
        Joint joint;
        joint.spec = spec();
        if (std::holds_alternative<MouseJoint>(joint.spec)) a = null_index;
        const bool needs_a = std::holds_alternative<GearJoint>(joint.spec) || std::holds_alternative<PulleyJoint>(joint.spec);
        if (a == b || (needs_a && a == null_index)) return;
        if (!bodies.is_dynamic(b) && (a == null_index || !bodies.is_dynamic(a))) return;
        joint.body_a = a;
        joint.body_b = b;
        // The frames nearly meet.
        const Vec2 place{from(-3, 3), from(-3, 3)};
        const Vec2 beside = place + Vec2{from(-0.05f, 0.05f), from(-0.05f, 0.05f)};
        const Rot q = rotation(from(-3, 3));
        const Transform at_a = a == null_index ? Transform{} : bodies.poses[a].transform;
        const Transform at_b = bodies.poses[b].transform;
        joint.frame_a = {inverse_transform(at_a, place), relative(at_a.q, q)};
        joint.frame_b = {inverse_transform(at_b, beside), relative(at_b.q, q)};
        joint.angle = from(-10, 10);
        joint.gear_slip = from(-0.1f, 0.1f);
        joint.rigid = {from(-1, 1), from(-1, 1), from(-1, 1)};
        for (ControlImpulses& c : joint.controls) c = {from(-1, 1), from(-1, 1), from(0, 1), from(0, 1)};
        joint.drive = {from(-1, 1), from(-1, 1)};
        joint.force = coin() ? Vec2{} : Vec2{from(-5000, 5000), from(-5000, 5000)};
        const std::uint32_t slot = joints.create(joint, bodies);
        give_color(slot, joints, bodies);
        joints.activate(slot);
    }

    static constexpr std::uint32_t body_count = 60;
    std::mt19937 engine;
    BodyStore bodies{*std::pmr::new_delete_resource()};
    JointStore joints{*std::pmr::new_delete_resource()};
    ColorLists colors() const { return {joints, *std::pmr::new_delete_resource()}; }
};

template <class F>
void run(RandomNet& net)
{
    constexpr float h = 1 / 240.0f;
    JointSolver<F> solver(*std::pmr::new_delete_resource());
    std::span<BodyMotion> motions = net.bodies.motions;
    for (int step = 0; step < 2; ++step)
    {
        solver.build(net.colors(), net.bodies, net.joints, make_joint_constants({}, h, step == 0 ? h / 2 : h));
        for (int substep = 0; substep < 3; ++substep)
        {
            solver.warm_start(motions);
            solver.solve(motions);
            integrate_positions(motions, h);
            solver.relax(motions);
        }
        solver.store_impulses(motions, net.joints, 1 / (3 * h));
        for (BodyMotion& motion : motions) motion.dp = {}, motion.dq = {};
    }
}

void expect_same_bits(const RandomNet& one, const RandomNet& four)
{
    for (std::size_t i = 0; i < one.bodies.motions.size(); ++i)
    {
        ASSERT_TRUE(length(one.bodies.motions[i].v) < 1e12f) << "motion " << i; // a comparison of NaNs would show nothing
        ASSERT_EQ(std::memcmp(&one.bodies.motions[i], &four.bodies.motions[i], sizeof(BodyMotion)), 0) << "motion " << i;
    }
    for (std::uint32_t slot = 0; slot < one.joints.slots.size(); ++slot)
    {
        const Joint& a = one.joints.joints[slot];
        const Joint& b = four.joints.joints[slot];
        for (std::size_t i = 0; i < max_rigid_rows; ++i) ASSERT_TRUE(same_bits(a.rigid[i], b.rigid[i])) << slot;
        for (std::size_t i = 0; i < max_controls; ++i)
        {
            ASSERT_TRUE(same_bits(a.controls[i].spring, b.controls[i].spring)) << slot;
            ASSERT_TRUE(same_bits(a.controls[i].motor, b.controls[i].motor)) << slot;
            ASSERT_TRUE(same_bits(a.controls[i].lower, b.controls[i].lower)) << slot;
            ASSERT_TRUE(same_bits(a.controls[i].upper, b.controls[i].upper)) << slot;
        }
        ASSERT_TRUE(same_bits(a.drive.x, b.drive.x) && same_bits(a.drive.y, b.drive.y)) << slot;
        ASSERT_TRUE(same_bits(a.force.x, b.force.x) && same_bits(a.force.y, b.force.y)) << slot;
        ASSERT_TRUE(same_bits(a.torque, b.torque) && same_bits(a.angle, b.angle) && same_bits(a.gear_slip, b.gear_slip)) << slot;
    }
}

} // namespace

TEST(JointLanes, FourLanesGiveTheBitsOfOne)
{
    for (unsigned seed = 0; seed < 30; ++seed)
    {
        RandomNet one(seed);
        RandomNet four(seed);
        ASSERT_FALSE(one.colors().list(overflow_color).empty());
        run<float>(one);
        run<FourLanes>(four);
        expect_same_bits(one, four);
        if (HasFatalFailure()) return;
    }
}

TEST(JointLanes, WhatNothingPushesIsNotWritten)
{
    RandomNet net(1);
    const RandomNet before(1);
    run<FourLanes>(net);
    for (std::uint32_t body = 0; body < RandomNet::body_count; ++body)
    {
        if (net.bodies.is_dynamic(body)) continue;
        ASSERT_TRUE(same_bits(net.bodies.velocity(body).x, before.bodies.velocity(body).x));
        ASSERT_TRUE(same_bits(net.bodies.velocity(body).y, before.bodies.velocity(body).y));
        ASSERT_TRUE(same_bits(net.bodies.spin(body), before.bodies.spin(body)));
    }
    EXPECT_EQ(net.bodies.motions[0].v, Vec2{});
}

} // namespace carom::detail
