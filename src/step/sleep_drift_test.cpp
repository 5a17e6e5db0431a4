// How far a body may have moved when it falls asleep, and that drives keep awake what they move.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace carom
{

namespace
{

void run_steps(World& world, int count)
{
    for (int i = 0; i < count; ++i) world.step(dt);
}

Polygon triangle(float size) { return convex_hull(std::vector<Vec2>{{0, 0}, {size, 0}, {0, size}}); }

} // namespace

TEST(SleepDrift, a_small_body_that_spins_stays_awake)
{
    for (const float size : {0.01f, 0.02f, 0.1f, 1.0f})
    {
        World world({.gravity = {}});
        const BodyId id = world.create_body({.angular_velocity = 1}, triangle(size));
        run_steps(world, 600);
        EXPECT_TRUE(world.body(id).is_awake()) << size;
        EXPECT_NEAR(world.body(id).angular_velocity(), 1, 1e-3f) << size;
    }
}

/// What SleepTuning promises, for bodies that move steadily and so slowly that they do fall asleep.
TEST(SleepDrift, a_body_that_falls_asleep_has_drifted_by_less_than_is_documented)
{
    for (const float size : {0.02f, 0.1f, 1.0f, 5.0f})
        for (const float speed : {0.1f, 0.04f, 0.01f, 0.002f, 0.0005f})
            for (const bool spins : {false, true})
            {
                World world({.gravity = {}});
                const float radius = size / std::sqrt(2.0f);
                const BodyId id = world.create_body(
                    {.linear_velocity = {spins ? 0 : speed, 0}, .angular_velocity = spins ? speed / radius : 0}, box(size, size));
                for (int i = 0; i < 300 && world.body(id).is_awake(); ++i) world.step(dt);
                if (world.body(id).is_awake()) continue;
                const float drift = spins ? radius * std::abs(world.body(id).angle()) : world.body(id).position().x;
                EXPECT_LE(drift, 1.05f * std::min(0.05f * 0.5f, 0.1f * radius)) << size << " m at " << speed;
            }
}

TEST(SleepDrift, what_trembles_in_one_place_still_falls_asleep)
{
    World world({.gravity = {}});
    const BodyId id = world.create_body({}, box(0.02f, 0.02f));
    for (int i = 0; i < 60; ++i)
    {
        world.body(id).set_linear_velocity({i % 2 == 0 ? 0.02f : -0.02f, 0}); // 0.3 mm to and fro
        world.step(dt);
    }
    world.body(id).set_linear_velocity({0.02f, 0});
    EXPECT_TRUE(world.body(id).is_awake()) << "each change wakes it";

    // A spring keeps it trembling without an edit: a quarter of a millimetre, which is faster than a tenth of its size a second.
    World swing({.gravity = {}});
    const BodyId bob = swing.create_body({.linear_velocity = {0.02f, 0}}, box(0.02f, 0.02f));
    swing.create_joint(swing.joint_at({}, bob, {0, 0}), PrismaticJoint{.spring = Spring{.hertz = 8, .damping_ratio = 0}});
    run_steps(swing, 120);
    EXPECT_FALSE(swing.body(bob).is_awake());
}

TEST(SleepDrift, piles_of_every_size_come_to_rest)
{
    for (const float size : {0.05f, 0.1f, 0.3f, 1.0f, 5.0f})
        for (const bool round : {false, true})
        {
            World world;
            world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2));
            for (const float side : {-1.0f, 1.0f})
                world.create_body({.type = BodyType::Static, .position = {6 * side * size, 2 * size}}, box(0.5f * size + 0.02f, 20 * size));
            for (int i = 0; i < 64; ++i)
            {
                const Vec2 at = {1.1f * size * (static_cast<float>(i % 8) - 3.6f + 0.13f * static_cast<float>(i / 8 % 3)),
                                 size * (0.6f + 1.2f * static_cast<float>(i / 8))};
                world.create_body({.position = at}, round ? Geometry{circle(0.5f * size)} : Geometry{box(size, size)});
            }
            int step = 0;
            while (world.awake_body_count() > 0 && step < 1200) world.step(dt), ++step;
            EXPECT_LT(step, 1200) << size << " m";
        }
}

TEST(SleepDrift, a_slow_belt_carries_what_lies_on_it)
{
    for (const bool round : {false, true})
        for (const float speed : {0.03f, 0.004f})
        {
            World world;
            world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2), {.material = {.tangent_speed = speed}});
            const BodyId id = world.create_body({.position = {0, 0.5f}, .locks = {.rotation = round}},
                                                round ? Geometry{circle(0.5f)} : Geometry{box(1, 1)});
            run_steps(world, 600);
            EXPECT_TRUE(world.body(id).is_awake());
            EXPECT_NEAR(world.body(id).position().x, 10 * speed, 0.03f * 10 * speed) << speed;
        }
}

TEST(SleepDrift, a_belt_under_a_blocked_body_lets_it_sleep_until_the_way_is_free)
{
    World world;
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(100, 2), {.material = {.tangent_speed = 0.03f}});
    const BodyId stop = world.create_body({.type = BodyType::Static, .position = {1, 0.5f}}, box(1, 4), {.material = {.friction = 0}});
    const BodyId id = world.create_body({.position = {0, 0.5f}}, box(0.98f, 1));
    run_steps(world, 600);
    EXPECT_FALSE(world.body(id).is_awake());
    world.destroy_body(stop);
    run_steps(world, 600);
    EXPECT_NEAR(world.body(id).position().x, 0.01f + 0.3f, 0.01f);
}

class SleepOfMotor : public testing::TestWithParam<int>
{
protected:
    static JointSpec spec(const Motor& motor, std::optional<Range> limit)
    {
        if (GetParam() == 0) return RevoluteJoint{.limit = limit, .motor = motor};
        if (GetParam() == 1) return PrismaticJoint{.limit = limit, .motor = motor};
        return WheelJoint{.motor = motor};
    }
    float moved() const { return GetParam() == 1 ? world.body(id).position().x : world.body(id).angle(); }

    World world = World({.gravity = {}});
    BodyId id = world.create_body({}, box(1, 0.2f));
};

TEST_P(SleepOfMotor, a_slow_one_keeps_its_bodies_awake)
{
    world.create_joint(world.joint_at({}, id, {0, 0}), spec({.speed = 0.03f, .max_force = 1000}, {}));
    run_steps(world, 600);
    EXPECT_TRUE(world.body(id).is_awake());
    EXPECT_NEAR(moved(), 0.3f, 0.01f);
}

TEST_P(SleepOfMotor, one_without_force_or_speed_does_not)
{
    for (const Motor& motor : {Motor{.speed = 0.03f, .max_force = 0}, Motor{.speed = 0, .max_force = 1000}})
    {
        World other({.gravity = {}});
        const BodyId body = other.create_body({}, box(1, 0.2f));
        other.create_joint(other.joint_at({}, body, {0, 0}), spec(motor, {}));
        run_steps(other, 120);
        EXPECT_FALSE(other.body(body).is_awake());
    }
}

TEST_P(SleepOfMotor, one_that_has_come_to_its_limit_does_not)
{
    if (GetParam() == 2) return; // a wheel turns without end
    world.create_joint(world.joint_at({}, id, {0, 0}), spec({.speed = 0.03f, .max_force = 1000}, Range{0, 0.06f}));
    run_steps(world, 100);
    EXPECT_TRUE(world.body(id).is_awake()) << "on its way";
    run_steps(world, 300);
    EXPECT_FALSE(world.body(id).is_awake());
    EXPECT_NEAR(moved(), 0.06f, 0.002f);
}

INSTANTIATE_TEST_SUITE_P(Types, SleepOfMotor, testing::Values(0, 1, 2));

TEST(SleepDrift, a_drive_on_the_way_to_its_target_stays_awake_and_sleeps_when_it_is_there)
{
    World world({.gravity = {}});
    const BodyId id = world.create_body({}, box(1, 1));
    const MotorJoint drive = {
        .offset = {0.5f, 0}, .angle = 1, .spring = {.hertz = 0.1f, .damping_ratio = 5}, .max_force = 1000, .max_torque = 1000};
    world.create_joint(world.joint_at({}, id, {0, 0}), drive);
    run_steps(world, 600);
    EXPECT_TRUE(world.body(id).is_awake());
    // omega / (2 zeta) = 0.063 a second: e^-0.63 is left after 10 s, but for the start from rest.
    EXPECT_NEAR(world.body(id).position().x, 0.5f * (1 - std::exp(-0.063f * 10)), 0.02f);
    run_steps(world, 6000);
    EXPECT_FALSE(world.body(id).is_awake());
    EXPECT_NEAR(world.body(id).position().x, 0.5f, 0.01f);
    EXPECT_NEAR(world.body(id).angle(), 1, 0.01f);
}

TEST(SleepDrift, a_weight_that_hangs_from_a_mouse_joint_sleeps)
{
    World world;
    const BodyId id = world.create_body({}, box(1, 1));
    const MouseJoint mouse = {.target = {0, 0.5f}, .spring = {.hertz = 1, .damping_ratio = 1}, .max_force = 1000};
    world.create_joint(world.joint_at({}, id, {0, 0.5f}), mouse);
    run_steps(world, 1200);
    EXPECT_FALSE(world.body(id).is_awake());
}

TEST(SleepDrift, a_kinematic_body_stays_awake_while_it_moves_however_slowly)
{
    World world;
    const BodyId platform =
        world.create_body({.type = BodyType::Kinematic, .position = {0, -0.5f}, .linear_velocity = {0.001f, 0}}, box(4, 1));
    const BodyId load = world.create_body({.position = {0, 0.5f}}, box(1, 1));
    run_steps(world, 1200);
    EXPECT_TRUE(world.body(platform).is_awake() && world.body(load).is_awake());
    EXPECT_NEAR(world.body(load).position().x, 0.02f, 0.001f);
}

} // namespace carom
