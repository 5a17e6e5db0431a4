// The joint solver gives the same bits in lanes of every width.
#include "math/same_bits_test.hpp"
#include "solver/isa/dispatch.hpp"
#include "solver/joints/joint_solver.hpp"
#include "solver/rows/integrate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory_resource>
#include <random>
#include <vector>

namespace carom::detail
{

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

    bool is_on_rail(std::uint32_t body) const
    {
        const Vec2 inv_mass = bodies.masses[bodies.motion_index[body]].inv_mass;
        return (inv_mass.x == 0) != (inv_mass.y == 0);
    }

    void connect(std::uint32_t a, std::uint32_t b)
    {
        Joint joint;
        joint.spec = spec();
        if (std::holds_alternative<MouseJoint>(joint.spec)) a = null_index;
        const bool needs_a = std::holds_alternative<GearJoint>(joint.spec) || std::holds_alternative<PulleyJoint>(joint.spec);
        if (a == b || (needs_a && a == null_index)) return;
        const bool can_move_a = a != null_index && bodies.is_dynamic(a);
        const bool can_move_b = bodies.is_dynamic(b);
        if (!can_move_a && !can_move_b) return;
        // A body on a rail that is pinned to the ground: where its arm lies along the rail no impulse is large enough.
        if ((!can_move_a && is_on_rail(b)) || (!can_move_b && is_on_rail(a))) return;
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
        joints.activate(slot);
    }

    static constexpr std::uint32_t body_count = 60;
    std::mt19937 engine;
    BodyStore bodies{*std::pmr::new_delete_resource()};
    JointStore joints{*std::pmr::new_delete_resource()};
};

/// Chains of pins with limits that hang from the world, each a little different.
struct Chains
{
    static constexpr std::uint32_t links = 6;

    /// @param only the one to make of them, or -1 for all
    explicit Chains(int count, int only = -1)
    {
        for (int i = 0; i < count; ++i)
            if (only < 0 || only == i) add(i);
    }

    void add(int chain)
    {
        const auto k = static_cast<float>(chain);
        std::uint32_t before = null_index;
        for (std::uint32_t i = 0; i < links; ++i)
        {
            const Vec2 place{3 * k + static_cast<float>(i), chain == 1 ? 2.0f : 0.0f};
            const std::uint32_t body = bodies.create({.position = place, .linear_velocity = {0.1f * k, -1}, .angular_velocity = 0.3f * k});
            const bool is_heavy = chain == 2 && i + 1 == links;
            bodies.masses[bodies.motion_index[body]] = {Vec2{1, 1} * (is_heavy ? 0.001f : 1.0f), is_heavy ? 0.01f : 12.0f};
            Joint joint;
            joint.spec = RevoluteJoint{.limit = Range{-0.1f, 0.1f}};
            joint.body_a = before;
            joint.body_b = body;
            joint.frame_a = {before == null_index ? Vec2{3 * k - 0.5f, 0} : Vec2{0.5f, 0}, {}};
            joint.frame_b = {{-0.5f, 0}, {}};
            joints.activate(joints.create(joint, bodies));
            before = body;
        }
    }

    const BodyMotion& motion(int chain, std::uint32_t link) const
    {
        return bodies.motions[bodies.motion_index[static_cast<std::uint32_t>(chain) * links + link]];
    }

    BodyStore bodies{*std::pmr::new_delete_resource()};
    JointStore joints{*std::pmr::new_delete_resource()};
};

template <class Net>
void run(Net& net, Simd simd)
{
    constexpr float h = 1 / 240.0f;
    JointSolver solver(*std::pmr::new_delete_resource());
    std::span<BodyMotion> motions = net.bodies.motions;
    for (int step = 0; step < 2; ++step)
    {
        solver.build(passes_of(simd), net.bodies, net.joints, make_joint_constants({}, h, step == 0 ? h / 2 : h));
        for (int substep = 0; substep < 3; ++substep)
        {
            solver.warm_start(motions);
            solver.solve(motions);
            integrate_positions(scalar_passes().bodies, motions, h);
            solver.relax(motions);
        }
        solver.conclude(motions);
        solver.store_impulses(net.joints, 1 / (3 * h));
        for (BodyMotion& motion : motions) motion.dp = {}, motion.dq = {};
    }
}

/// Now and then random joints contradict each other so that they drive their bodies up without end: a comparison of NaNs would show nothing.
bool is_sane(const RandomNet& net)
{
    const auto& motions = net.bodies.motions;
    return std::all_of(motions.begin(), motions.end(), [](const BodyMotion& motion) { return length(motion.v) < 1e12f; });
}

template <class Net>
void expect_same_bits(const Net& one, const Net& four)
{
    for (std::size_t i = 0; i < one.bodies.motions.size(); ++i)
    {
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

TEST(JointLanes, EveryWidthGivesTheBitsOfOneLane)
{
    for (const Simd simd : all_simd)
    {
        if (!is_available(simd)) continue;
        int compared = 0;
        for (unsigned seed = 0; seed < 30; ++seed)
        {
            RandomNet one(seed);
            RandomNet wide(seed);
            run(one, Simd::Scalar);
            run(wide, simd);
            if (!is_sane(one)) continue;
            ++compared;
            expect_same_bits(one, wide);
            if (HasFatalFailure()) return;
        }
        EXPECT_GE(compared, 25);
    }
}

TEST(JointLanes, MechanismsSideBySideGiveTheBitsOfEachAlone)
{
    // Chains of one kind, one of which is far from closed, and one with a heavy end.
    for (const Simd simd : all_simd)
    {
        if (!is_available(simd)) continue;
        for (const int count : {1, 2, 5, 16, 21})
        {
            Chains together(count);
            run(together, simd);
            for (int i = 0; i < count; ++i)
            {
                Chains one(count, i);
                run(one, simd);
                for (std::uint32_t link = 0; link < Chains::links; ++link)
                    ASSERT_EQ(std::memcmp(&one.motion(0, link), &together.motion(i, link), offsetof(BodyMotion, slot)), 0)
                        << count << ", " << i;
            }
        }
    }
}

TEST(JointLanes, WhatNothingPushesIsNotWritten)
{
    RandomNet net(1);
    const RandomNet before(1);
    run(net, Simd::Four);
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
