#include "dynamics/body_store.hpp"
#include "dynamics/joint_store.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory_resource>
#include <random>
#include <set>

namespace carom::detail
{
namespace
{

/// Walks the list of a body both ways.
std::set<std::uint32_t> joints_of(const JointStore& joints, const BodyStore& bodies, std::uint32_t body)
{
    std::set<std::uint32_t> found;
    std::uint32_t before = null_index;
    for (std::uint32_t edge = bodies.records[body].first_joint; edge != null_index;)
    {
        const Joint& joint = joints.joints[edge / 2];
        EXPECT_TRUE(joints.slots.is_live(edge / 2));
        EXPECT_EQ(edge % 2 == 0 ? joint.body_a : joint.body_b, body);
        EXPECT_EQ(joint.previous[edge % 2], before);
        EXPECT_TRUE(found.insert(edge / 2).second) << "twice in one list";
        before = edge;
        edge = joint.next[edge % 2];
    }
    return found;
}

TEST(JointStore, ListsOfBodiesAgreeWithAMapWhateverComesAndGoes)
{
    std::pmr::memory_resource& memory = *std::pmr::new_delete_resource();
    BodyStore bodies(memory);
    JointStore joints(memory);
    for (int i = 0; i < 6; ++i) bodies.create({});

    std::mt19937 engine(5);
    std::map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>> live;
    for (int i = 0; i < 3000; ++i)
    {
        if (live.size() < 4 || (live.size() < 30 && engine() % 2 == 0))
        {
            Joint joint;
            joint.body_b = static_cast<std::uint32_t>(engine() % 6);
            joint.body_a = engine() % 4 == 0 ? null_index : (joint.body_b + 1 + static_cast<std::uint32_t>(engine() % 5)) % 6;
            const std::uint32_t slot = joints.create(joint, bodies);
            ASSERT_TRUE(live.emplace(slot, std::pair(joint.body_a, joint.body_b)).second);
        }
        else
        {
            const auto victim = std::next(live.begin(), static_cast<std::ptrdiff_t>(engine() % live.size()));
            joints.destroy(victim->first, bodies);
            live.erase(victim);
        }
        EXPECT_EQ(joints.slots.live_count(), static_cast<int>(live.size()));
        for (std::uint32_t body = 0; body < 6; ++body)
        {
            std::set<std::uint32_t> expected;
            for (const auto& [slot, pair] : live)
                if (pair.first == body || pair.second == body) expected.insert(slot);
            ASSERT_EQ(joints_of(joints, bodies, body), expected);
        }
    }
}

TEST(JointStore, AUsedPlaceStartsCold)
{
    std::pmr::memory_resource& memory = *std::pmr::new_delete_resource();
    BodyStore bodies(memory);
    JointStore joints(memory);
    for (int i = 0; i < 2; ++i) bodies.create({});
    Joint fresh;
    fresh.body_a = 0;
    fresh.body_b = 1;
    const std::uint32_t slot = joints.create(fresh, bodies);
    Joint& joint = joints.joints[slot];
    joint.rigid = {1, 2, 3};
    joint.controls[0].spring = 4;
    joint.drive = {5, 6};
    joint.force = {7, 8};
    joint.gear_slip = 9;
    joints.activate(slot);
    joints.deactivate(slot);
    joints.destroy(slot, bodies);
    ASSERT_EQ(joints.create(fresh, bodies), slot);
    const Joint& again = joints.joints[slot];
    EXPECT_EQ(again.rigid, (std::array<float, max_rigid_rows>{}));
    EXPECT_EQ(again.controls[0].spring, 0);
    EXPECT_EQ(again.drive, Vec2{});
    EXPECT_EQ(again.force, Vec2{});
    EXPECT_EQ(again.gear_slip, 0);
    EXPECT_FALSE(again.is_active());
}

TEST(JointStore, ForgettingImpulsesKeepsWhatTheJointIs)
{
    Joint joint;
    joint.rigid = {1, 2, 3};
    joint.controls[1].motor = 4;
    joint.drive = {5, 6};
    joint.torque = 7;
    joint.angle = 8;
    joint.gear_slip = 9;
    forget_impulses(joint);
    EXPECT_EQ(joint.rigid, (std::array<float, max_rigid_rows>{}));
    EXPECT_EQ(joint.controls[1].motor, 0);
    EXPECT_EQ(joint.drive, Vec2{});
    EXPECT_EQ(joint.torque, 0);
    EXPECT_EQ(joint.angle, 8) << "turns are counted, not pushed";
    EXPECT_EQ(joint.gear_slip, 9);
}

TEST(JointStore, UnwrapsToTheNearestTurn)
{
    for (int turn = -20; turn <= 20; ++turn)
        for (const float angle : {-3.1f, -1.0f, 0.0f, 0.5f, 3.1f})
            for (const float off : {-3.0f, 0.0f, 3.0f})
            {
                const float true_angle = angle + static_cast<float>(turn) * 2 * pi;
                EXPECT_NEAR(unwrapped(angle, true_angle + off), true_angle, 2e-5f) << turn << ", " << angle << ", " << off;
            }
}

TEST(JointStore, AFrameOfTheWorldIsWhereItSays)
{
    std::pmr::memory_resource& memory = *std::pmr::new_delete_resource();
    BodyStore bodies(memory);
    bodies.create({.position = {2, 1}, .angle = pi / 2});
    const Transform frame{{1, 0}, {1, 0}};
    EXPECT_EQ(world_frame(bodies, null_index, frame).p, (Vec2{1, 0}));
    EXPECT_NEAR(world_frame(bodies, 0, frame).p.x, 2, 1e-6);
    EXPECT_NEAR(world_frame(bodies, 0, frame).p.y, 2, 1e-6);
    EXPECT_NEAR(angle(world_frame(bodies, 0, frame).q), pi / 2, 1e-6);
}

} // namespace
} // namespace carom::detail
