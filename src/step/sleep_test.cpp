// Who sleeps, who wakes, and what sleepers cost.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace carom
{

namespace
{

class SleepTest : public testing::Test
{
protected:
    SleepTest() { ground = world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2)); }

    void steps(int count)
    {
        for (int i = 0; i < count; ++i) world.step(dt);
    }

    BodyId tower(float x, int height)
    {
        BodyId last;
        for (int i = 0; i < height; ++i) last = world.create_body({.position = {x, 0.5f + static_cast<float>(i)}}, box(1, 1));
        return last;
    }

    World world;
    BodyId ground;
};

} // namespace

TEST_F(SleepTest, APileComesToRestAndIsToldOnce)
{
    const BodyId top = tower(0, 3);
    std::vector<BodyId> told;
    for (int i = 0; i < 600; ++i)
    {
        world.step(dt);
        told.insert(told.end(), world.events().fell_asleep.begin(), world.events().fell_asleep.end());
        EXPECT_TRUE(world.events().woke.empty());
    }
    EXPECT_EQ(told.size(), 3u);
    EXPECT_EQ(world.awake_body_count(), 0);
    EXPECT_FALSE(world.body(top).is_awake());
    EXPECT_EQ(world.body(top).linear_velocity(), Vec2{});
    const StepReport report = world.step(dt);
    EXPECT_EQ(report.awake_bodies, 0);
    EXPECT_EQ(report.islands, 0);
    EXPECT_EQ(report.rows, 0);
    EXPECT_EQ(report.contacts, 3) << "sleepers still touch";
    EXPECT_EQ(report.pairs, 3);
}

TEST_F(SleepTest, AnIslandSleepsAndWakesAsAWhole)
{
    const BodyId left = tower(-5, 2);
    const BodyId right = tower(5, 2);
    steps(600);
    ASSERT_EQ(world.awake_body_count(), 0);
    world.body(left).apply_impulse_to_center({0.1f, 0});
    EXPECT_EQ(world.awake_body_count(), 2);
    EXPECT_FALSE(world.body(right).is_awake());
    world.step(dt);
    EXPECT_EQ(world.events().woke.size(), 2u);
    EXPECT_TRUE(std::is_sorted(world.events().woke.begin(), world.events().woke.end()));
    steps(600);
    EXPECT_EQ(world.awake_body_count(), 0);
}

TEST_F(SleepTest, WhatTouchesASleeperWakesIt)
{
    const BodyId top = tower(0, 2);
    steps(600);
    ASSERT_FALSE(world.body(top).is_awake());
    world.create_body({.position = {0, 4}}, circle(0.3f));
    int woken_at = -1;
    for (int i = 0; i < 60 && woken_at < 0; ++i)
    {
        world.step(dt);
        if (world.body(top).is_awake()) woken_at = i;
    }
    // It falls 1.7 m: 0.59 s.
    EXPECT_GE(woken_at, 33) << "not before it comes";
    EXPECT_LE(woken_at, 37);
}

TEST_F(SleepTest, SleepersFallWhenTheirGroundGoes)
{
    for (const int way : {0, 1, 2, 3, 4})
    {
        World own;
        const BodyId floor = own.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2));
        const BodyId crate = own.create_body({.position = {0, 0.5f}}, box(1, 1));
        for (int i = 0; i < 300; ++i) own.step(dt);
        ASSERT_FALSE(own.body(crate).is_awake());
        if (way == 0) own.destroy_body(floor);
        if (way == 1) own.body(floor).set_transform({0, -50}, 0);
        if (way == 2) own.body(floor).set_enabled(false);
        if (way == 3) own.shape(own.body(floor).shapes()[0]).set_filter({.mask = 0});
        if (way == 4) own.shape(own.body(floor).shapes()[0]).set_geometry(box(0.1f, 0.1f));
        for (int i = 0; i < 30; ++i) own.step(dt);
        EXPECT_LT(own.body(crate).position().y, -0.3f) << way;
    }
}

TEST_F(SleepTest, EveryChangeWakes)
{
    const BodyId id = tower(0, 1);
    const auto wakes = [&](const char* what, auto&& change)
    {
        steps(300);
        ASSERT_FALSE(world.body(id).is_awake()) << what;
        change(world.body(id));
        EXPECT_TRUE(world.body(id).is_awake()) << what;
    };
    wakes("force", [](Body b) { b.apply_force_to_center({0, 1}); });
    wakes("torque", [](Body b) { b.apply_torque(0.1f); });
    wakes("impulse", [](Body b) { b.apply_impulse({0.01f, 0}, b.position()); });
    wakes("spin", [](Body b) { b.apply_angular_impulse(0.01f); });
    wakes("velocity", [](Body b) { b.set_linear_velocity({0.1f, 0}); });
    wakes("angular velocity", [](Body b) { b.set_angular_velocity(0.1f); });
    wakes("teleport", [](Body b) { b.set_transform({1, 0.5f}, 0); });
    wakes("damping", [](Body b) { b.set_linear_damping(0.1f); });
    wakes("gravity scale", [](Body b) { b.set_gravity_scale(0.9f); });
    wakes("locks", [](Body b) { b.set_locks({.rotation = true}); });
    wakes("mass", [](Body b) { b.set_mass_data({.mass = 2, .inertia = 1}); });
    wakes("by hand", [](Body b) { b.set_awake(true); });
    wakes("gravity", [&](Body) { world.set_gravity({0, -9}); });
    wakes("field", [&](Body) { world.add_field(UniformField{{0.1f, 0}}); });
    wakes("shape", [&](Body) { world.create_shape(id, circle(0.2f, {0, 1})); });
    wakes("density", [&](Body b) { world.shape(b.shapes()[0]).set_density(2); });
    wakes("material", [&](Body b) { world.shape(b.shapes()[0]).set_material({.friction = 0.1f}); });
    wakes("joint", [&](Body) { world.create_joint(world.joint_at({}, id, {1, 5}), DistanceJoint{.limit = Range{0, 100}}); });
}

TEST_F(SleepTest, WhatChangesNothingThatIsFeltDoesNotWake)
{
    const BodyId id = tower(0, 1);
    steps(300);
    world.body(id).set_name("crate");
    world.body(id).set_user_data(3);
    world.body(id).set_is_bullet(true);
    world.set_gravity(world.gravity());
    world.create_body({.position = {30, 20}}, circle(1));
    EXPECT_FALSE(world.body(id).is_awake());
}

TEST_F(SleepTest, JoinedBodiesSleepTogether)
{
    const BodyId a = world.create_body({.position = {0, 0.5f}}, box(1, 1));
    const BodyId b = world.create_body({.position = {5, 0.5f}}, box(1, 1));
    const JointId joint = world.create_joint(world.joint_between(a, b, {0, 0.5f}, {5, 0.5f}), DistanceJoint{.length = 5});
    steps(300);
    ASSERT_EQ(world.awake_body_count(), 0);
    world.body(a).set_awake(true);
    EXPECT_TRUE(world.body(b).is_awake());
    steps(300);
    world.destroy_joint(joint);
    EXPECT_EQ(world.awake_body_count(), 2);
    steps(300);
    world.body(a).set_awake(true);
    EXPECT_FALSE(world.body(b).is_awake()) << "nothing holds them together any more";
}

TEST_F(SleepTest, AMovingPlatformKeepsItsLoadAwakeAndWakesItWhenItStarts)
{
    const BodyId platform = world.create_body({.type = BodyType::Kinematic, .position = {0, 5}, .linear_velocity = {0.02f, 0}}, box(4, 1));
    const BodyId load = world.create_body({.position = {0, 6}}, box(1, 1));
    steps(300);
    EXPECT_TRUE(world.body(load).is_awake()) << "slow as it is";
    world.body(platform).set_linear_velocity({});
    steps(300);
    EXPECT_EQ(world.awake_body_count(), 0);
    world.body(platform).set_linear_velocity({1, 0});
    steps(2);
    EXPECT_TRUE(world.body(load).is_awake());
    steps(60);
    EXPECT_GT(world.body(load).position().x, 0.5f);
}

TEST_F(SleepTest, SensorsSeeSleepersThatAreThereAndThatCome)
{
    const BodyId crate = tower(0, 1);
    steps(300);
    ASSERT_FALSE(world.body(crate).is_awake());
    const BodyId trigger = world.create_body({.type = BodyType::Static}, circle(2), {.is_sensor = true});
    world.step(dt);
    EXPECT_EQ(world.events().sensor_begin.size(), 1u) << "a sensor that is put over a sleeper";
    EXPECT_FALSE(world.body(crate).is_awake());
    steps(10);
    EXPECT_TRUE(world.events().sensor_begin.empty());
    world.body(trigger).set_transform({20, 0}, 0);
    world.step(dt);
    EXPECT_EQ(world.events().sensor_end.size(), 1u);
    EXPECT_FALSE(world.body(crate).is_awake());
}

TEST_F(SleepTest, ABodyCanBeKeptFromSleeping)
{
    const BodyId watcher = world.create_body({.position = {0, 0.5f}, .can_sleep = false}, box(1, 1));
    steps(600);
    EXPECT_TRUE(world.body(watcher).is_awake());
    world.body(watcher).set_can_sleep(true);
    steps(300);
    EXPECT_FALSE(world.body(watcher).is_awake());
    world.set_sleep_tuning({.is_enabled = false});
    EXPECT_TRUE(world.body(watcher).is_awake());
    steps(300);
    EXPECT_TRUE(world.body(watcher).is_awake());
}

TEST_F(SleepTest, AJitteringNeighbourDoesNotKeepTheOtherSideOfABrokenIslandAwake)
{
    const BodyId a = world.create_body({.position = {0, 0.5f}}, box(1, 1));
    const BodyId b = world.create_body({.position = {1.0f, 0.5f}}, box(1, 1));
    steps(10);
    world.body(b).set_transform({10, 0.5f}, 0);
    for (int i = 0; i < 300; ++i)
    {
        world.body(b).set_angular_velocity(0.3f);
        world.step(dt);
    }
    EXPECT_TRUE(world.body(b).is_awake());
    EXPECT_FALSE(world.body(a).is_awake());
}

TEST_F(SleepTest, PuttingToSleepByHand)
{
    const BodyId falling = world.create_body({.position = {0, 20}, .linear_velocity = {3, 0}}, circle(1));
    steps(10);
    world.body(falling).set_awake(false);
    const Vec2 there = world.body(falling).position();
    steps(60);
    EXPECT_EQ(world.body(falling).position(), there);
    EXPECT_EQ(world.body(falling).linear_velocity(), Vec2{});
    world.body(falling).set_awake(true);
    steps(10);
    EXPECT_LT(world.body(falling).position().y, there.y);
}

/// The contacts of an island that is woken within a step hold it together in that step.
TEST_F(SleepTest, AnIslandThatIsHitIsSolvedAtOnce)
{
    World space({.gravity = {}});
    for (int i = 0; i < 8; ++i) space.create_body({.position = {static_cast<float>(i), 0}}, box(1, 1));
    for (int i = 0; i < 120; ++i) space.step(dt);
    ASSERT_EQ(space.awake_body_count(), 0);
    space.create_body({.position = {-2, 0}, .linear_velocity = {30, 0}}, box(1, 1));
    StepReport report;
    for (int i = 0; i < 30 && report.awake_bodies < 2; ++i) report = space.step(dt);
    EXPECT_EQ(report.awake_bodies, 9);
    EXPECT_EQ(report.rows, 8);
}

} // namespace carom
