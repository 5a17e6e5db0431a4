// Bodies that touch nothing, against the closed forms of their motion.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace carom
{

namespace
{

/// Velocity and place after n substeps h of semi-implicit Euler at constant acceleration a: v = a n h, x = a h^2 n (n + 1) / 2.
double stepped_distance(double a, double h, int n) { return a * h * h * n * (n + 1) / 2; }

} // namespace

TEST(Motion, free_fall_follows_the_integrators_closed_form)
{
    for (const int substeps : {1, 2, 4, 8})
    {
        World world({.gravity = {0, -10}});
        const BodyId id = world.create_body({.position = {3, 100}}, circle(0.5f));
        for (int i = 0; i < 120; ++i) world.step(dt, substeps);
        const int n = 120 * substeps;
        EXPECT_NEAR(world.body(id).position().y, 100 + stepped_distance(-10, 1.0 / 60 / substeps, n), 1e-3);
        EXPECT_NEAR(world.body(id).linear_velocity().y, -20, 1e-4);
        EXPECT_EQ(world.body(id).position().x, 3);
        EXPECT_EQ(world.body(id).angle(), 0);
    }
}

TEST(Motion, free_fall_converges_to_the_parabola)
{
    World world({.gravity = {0, -10}});
    const BodyId id = world.create_body({.position = {0, 0}, .linear_velocity = {4, 12}}, box(1, 1));
    for (int i = 0; i < 60; ++i) world.step(dt, 64);
    EXPECT_NEAR(world.body(id).position().x, 4, 1e-3);
    EXPECT_NEAR(world.body(id).position().y, 12 - 5, 3e-3);
}

TEST(Motion, a_constant_force_accelerates_by_force_over_mass)
{
    World world({.gravity = {0, 0}});
    const BodyId id = world.create_body({}, box(2, 1), {.density = 3});
    ASSERT_NEAR(world.body(id).mass_data().mass, 6, 1e-5);
    for (int i = 0; i < 60; ++i)
    {
        world.body(id).apply_force_to_center({12, -6});
        world.step(dt);
    }
    EXPECT_NEAR(world.body(id).linear_velocity().x, 2, 1e-4);
    EXPECT_NEAR(world.body(id).linear_velocity().y, -1, 1e-4);
    EXPECT_NEAR(world.body(id).position().x, stepped_distance(2, 1.0 / 240, 240), 1e-4);
    world.step(dt); // the force is gone
    EXPECT_NEAR(world.body(id).linear_velocity().x, 2, 1e-4);
}

TEST(Motion, a_torque_accelerates_by_torque_over_inertia)
{
    World world({.gravity = {0, 0}});
    const BodyId id = world.create_body({}, circle(1), {.density = 2 / pi});
    ASSERT_NEAR(world.body(id).mass_data().inertia, 1, 1e-5); // m r^2 / 2
    for (int i = 0; i < 30; ++i)
    {
        world.body(id).apply_torque(4);
        world.step(dt);
    }
    EXPECT_NEAR(world.body(id).angular_velocity(), 2, 1e-4);
    EXPECT_NEAR(world.body(id).angle(), stepped_distance(4, 1.0 / 240, 120), 1e-3);
}

TEST(Motion, a_force_beside_the_centre_turns_as_well)
{
    World world({.gravity = {0, 0}});
    const BodyId id = world.create_body({.position = {5, 5}}, box(1, 1));
    world.body(id).apply_impulse({0, 2}, {5.5f, 5});
    EXPECT_NEAR(world.body(id).linear_velocity().y, 2, 1e-5);
    EXPECT_NEAR(world.body(id).angular_velocity(), 1 / (1 / 6.0), 1e-4); // r x P / I
}

TEST(Motion, a_spin_turns_by_its_angle_even_when_fast)
{
    World world({.gravity = {0, 0}});
    const BodyId id = world.create_body({.angular_velocity = 100}, box(1, 0.2f));
    double turned = 0;
    float last = 0;
    for (int i = 0; i < 60; ++i)
    {
        world.step(dt);
        const float now = world.body(id).angle();
        turned += std::remainder(double{now} - last, 2 * double{pi}); // 100 / 60 rad a step is under half a turn
        last = now;
    }
    EXPECT_NEAR(turned, 100, 0.01);
    EXPECT_EQ(world.body(id).angular_velocity(), 100);
}

TEST(Motion, damping_decays_velocity_exponentially)
{
    World world({.gravity = {0, 0}});
    const BodyId id =
        world.create_body({.linear_velocity = {8, 0}, .angular_velocity = 6, .linear_damping = 0.5f, .angular_damping = 1}, circle(1));
    for (int i = 0; i < 120; ++i) world.step(dt);
    EXPECT_NEAR(world.body(id).linear_velocity().x, 8 * std::exp(-1.0), 0.01);
    EXPECT_NEAR(world.body(id).angular_velocity(), 6 * std::exp(-2.0), 0.01);
}

TEST(Motion, gravity_scale_multiplies_gravity)
{
    World world({.gravity = {0, -10}});
    const BodyId floats = world.create_body({.gravity_scale = 0}, circle(0.1f));
    const BodyId rises = world.create_body({.position = {10, 0}, .gravity_scale = -0.5f}, circle(0.1f));
    for (int i = 0; i < 60; ++i) world.step(dt);
    EXPECT_EQ(world.body(floats).position().y, 0);
    EXPECT_NEAR(world.body(rises).linear_velocity().y, 5, 1e-4);
}

TEST(Motion, locks_hold_exactly_and_leave_the_rest_free)
{
    World world({.gravity = {3, -10}});
    const BodyId no_x = world.create_body({.linear_velocity = {5, 0}, .locks = {.x = true}}, circle(0.1f));
    const BodyId no_y = world.create_body({.position = {10, 0}, .linear_velocity = {1, 5}, .locks = {.y = true}}, circle(0.1f));
    const BodyId no_spin = world.create_body({.position = {20, 0}, .angular_velocity = 5, .locks = {.rotation = true}}, circle(0.1f));
    world.body(no_spin).apply_torque(100);
    for (int i = 0; i < 60; ++i) world.step(dt);
    EXPECT_EQ(world.body(no_x).position().x, 0);
    EXPECT_NEAR(world.body(no_x).linear_velocity().y, -10, 1e-3);
    EXPECT_EQ(world.body(no_y).position().y, 0);
    EXPECT_NEAR(world.body(no_y).linear_velocity().x, 4, 1e-3);
    EXPECT_EQ(world.body(no_spin).angle(), 0);
}

TEST(Motion, a_kinematic_body_keeps_its_velocity_whatever_it_meets)
{
    World world;
    const BodyId pusher =
        world.create_body({.type = BodyType::Kinematic, .position = {-3, 0}, .linear_velocity = {2, 0}, .angular_velocity = 1}, box(1, 1));
    const BodyId pushed = world.create_body({.gravity_scale = 0}, box(1, 1));
    for (int i = 0; i < 120; ++i) world.step(dt);
    EXPECT_EQ(world.body(pusher).linear_velocity(), (Vec2{2, 0}));
    EXPECT_NEAR(world.body(pusher).position().x, 1, 1e-4);
    EXPECT_NEAR(world.body(pusher).angle(), 2, 1e-3);
    EXPECT_GT(world.body(pushed).position().x, 1);
}

TEST(Motion, time_zero_moves_nothing)
{
    World world;
    const BodyId id = world.create_body({.position = {0, 5}, .linear_velocity = {1, 1}}, circle(1));
    world.step(0);
    EXPECT_EQ(world.body(id).position(), (Vec2{0, 5}));
    EXPECT_EQ(world.body(id).linear_velocity(), (Vec2{1, 1}));
}

TEST(Motion, the_motion_of_an_uneven_body_is_that_of_its_centre_of_mass)
{
    World world({.gravity = {0, 0}});
    const BodyId id = world.create_body({.linear_velocity = {1, 0}, .angular_velocity = 2}, circle(0.5f, {1, 0}));
    for (int i = 0; i < 60; ++i) world.step(dt);
    EXPECT_NEAR(world.body(id).center_of_mass().x, 2, 1e-4);
    EXPECT_NEAR(world.body(id).center_of_mass().y, 0, 1e-4);
    EXPECT_NEAR(world.body(id).angle(), 2, 1e-3);
    EXPECT_NEAR(distance(world.body(id).position(), world.body(id).center_of_mass()), 1, 1e-4);
}

} // namespace carom
