// Every joint has one lane, lanes of a row share nothing that moves, and equal mechanisms lie side by side.
#include "solver/joints/joint_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory_resource>
#include <random>
#include <set>
#include <vector>

namespace carom::detail
{

namespace
{

struct PlanTest : testing::Test
{
    std::uint32_t body(BodyType type = BodyType::Dynamic) { return bodies.create({.type = type}); }

    std::uint32_t join(std::uint32_t a, std::uint32_t b, const JointSpec& spec = RevoluteJoint{})
    {
        Joint joint;
        joint.body_a = a;
        joint.body_b = b;
        joint.spec = spec;
        const std::uint32_t slot = joints.create(joint, bodies);
        joints.activate(slot);
        return slot;
    }

    /// Hangs from the world.
    void add_chain(int links)
    {
        std::uint32_t before = null_index;
        for (int i = 0; i < links; ++i)
        {
            const std::uint32_t link = body();
            join(before, link);
            before = link;
        }
    }

    void add_net(int side)
    {
        std::vector<std::uint32_t> knots;
        for (int i = 0; i < side * side; ++i)
        {
            knots.push_back(body());
            if (i % side > 0) join(knots[knots.size() - 2], knots.back());
            if (i >= side) join(knots[knots.size() - 1 - static_cast<std::size_t>(side)], knots.back());
        }
    }

    void expect_sound()
    {
        std::vector<std::uint32_t> all;
        for (const std::uint32_t slot : plan.slots)
            if (slot != null_index) all.push_back(slot);
        std::sort(all.begin(), all.end());
        std::vector<std::uint32_t> active(joints.active.begin(), joints.active.end());
        std::sort(active.begin(), active.end());
        EXPECT_EQ(all, active);
        for (const PlannedRow& row : plan.rows)
        {
            ASSERT_NE(plan.slots[row.first], null_index) << "a row begins with a joint";
            std::set<std::uint32_t> seen;
            for (std::uint32_t i = 0; i < row.lanes; ++i)
            {
                if (plan.slots[row.first + i] == null_index) continue;
                const Joint& joint = joints.joints[plan.slots[row.first + i]];
                for (const std::uint32_t end : {joint.body_a, joint.body_b})
                {
                    if (end == null_index || !bodies.is_dynamic(end)) continue;
                    EXPECT_TRUE(seen.insert(end).second) << "in two lanes: " << end;
                }
            }
        }
    }

    BodyStore bodies{*std::pmr::new_delete_resource()};
    JointStore joints{*std::pmr::new_delete_resource()};
    JointPlan plan{*std::pmr::new_delete_resource()};
};

} // namespace

TEST_F(PlanTest, equal_mechanisms_fill_lanes_and_one_alone_takes_one)
{
    for (int i = 0; i < 9; ++i) add_chain(3);
    add_chain(4);
    EXPECT_TRUE(plan.update(bodies, joints, 8));
    expect_sound();
    EXPECT_EQ(plan.single_rows, 0u);
    ASSERT_EQ(plan.groups.size(), 3u);
    EXPECT_EQ(plan.groups[0].lanes, 8u);
    EXPECT_EQ(plan.groups[1].lanes, 1u) << "the ninth";
    EXPECT_EQ(plan.groups[2].lanes, 1u) << "of another length";
    EXPECT_EQ(plan.groups[0].kind, plan.groups[1].kind);
    EXPECT_NE(plan.groups[0].kind, plan.groups[2].kind);
    EXPECT_EQ(plan.kind(plan.groups[2]).ends.size(), 4u);
}

TEST_F(PlanTest, nets_and_what_holds_nothing_rigidly_are_solved_one_by_one)
{
    add_net(30);
    add_chain(2);
    join(null_index, body(), MouseJoint{.target = {0, 0}, .max_force = 1});
    join(body(), body(), DistanceJoint{.length = 1, .spring = Spring{}});
    EXPECT_TRUE(plan.update(bodies, joints, 8));
    expect_sound();
    ASSERT_EQ(plan.groups.size(), 1u);
    const std::size_t in_nets = 2 * 30 * 29;
    EXPECT_GE(plan.single_rows, in_nets / 8 + 2);
    EXPECT_LE(plan.single_rows, in_nets / 8 + 10) << "few lanes are free";
}

TEST_F(PlanTest, what_can_not_move_parts_mechanisms)
{
    const std::uint32_t ground = body(BodyType::Static);
    for (int i = 0; i < 4; ++i) join(ground, body());
    EXPECT_TRUE(plan.update(bodies, joints, 4));
    expect_sound();
    ASSERT_EQ(plan.groups.size(), 1u);
    EXPECT_EQ(plan.groups[0].lanes, 4u);
}

TEST_F(PlanTest, is_kept_until_joints_change)
{
    for (int i = 0; i < 5; ++i) add_chain(2);
    EXPECT_TRUE(plan.update(bodies, joints, 4));
    EXPECT_FALSE(plan.update(bodies, joints, 4));
    body();
    EXPECT_FALSE(plan.update(bodies, joints, 4)) << "a body that no joint holds";
    joints.deactivate(3);
    EXPECT_TRUE(plan.update(bodies, joints, 4));
    expect_sound();
    joints.set_spec(0, WeldJoint{});
    EXPECT_TRUE(plan.update(bodies, joints, 4));
    expect_sound();
    EXPECT_TRUE(plan.update(bodies, joints, 8)) << "in other lanes";
    EXPECT_FALSE(plan.update(bodies, joints, 8));
}

TEST_F(PlanTest, does_not_depend_on_the_order_in_which_joints_became_active)
{
    for (int i = 0; i < 6; ++i) add_chain(1 + i % 3);
    plan.update(bodies, joints, 4);
    const std::vector<std::uint32_t> before(plan.slots.begin(), plan.slots.end());
    std::mt19937 engine(1);
    std::vector<std::uint32_t> order(joints.active.begin(), joints.active.end());
    std::shuffle(order.begin(), order.end(), engine);
    for (const std::uint32_t slot : order) joints.deactivate(slot);
    for (const std::uint32_t slot : order) joints.activate(slot);
    plan.update(bodies, joints, 4);
    EXPECT_EQ(std::vector<std::uint32_t>(plan.slots.begin(), plan.slots.end()), before);
}

TEST_F(PlanTest, many_kinds_come_and_go)
{
    for (int length = 1; length <= 120; ++length) add_chain(length);
    plan.update(bodies, joints, 8);
    expect_sound();
    EXPECT_EQ(plan.groups.size(), 120u);
    // Only the shortest stay; later one of a kind that was forgotten is back.
    const std::vector<std::uint32_t> all(joints.active.begin(), joints.active.end());
    for (const std::uint32_t slot : all)
        if (slot >= 3) joints.deactivate(slot);
    plan.update(bodies, joints, 8);
    expect_sound();
    EXPECT_EQ(plan.groups.size(), 2u);
    for (const std::uint32_t slot : all)
        if (slot >= 3 && slot < 500) joints.activate(slot);
    plan.update(bodies, joints, 8);
    expect_sound();
}

} // namespace carom::detail
