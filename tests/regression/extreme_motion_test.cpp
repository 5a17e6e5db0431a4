// Motion at the edge of what calls accept, and beyond it.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace carom
{

TEST(Regression, the_fastest_spin_that_calls_accept_survives_the_longest_step)
{
    World world({.gravity = {}});
    const BodyId id = world.create_body({.angular_velocity = max_speed}, box(1, 1));
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(world.step(1, 1).quarantined.empty());
    EXPECT_TRUE(world.body(id).is_enabled());
    EXPECT_EQ(world.body(id).angular_velocity(), max_speed);
    const Rot q = world.body(id).transform().q;
    EXPECT_NEAR(q.c * q.c + q.s * q.s, 1, 1e-5);
}

TEST(Regression, a_step_leaves_no_body_faster_than_calls_accept)
{
    World world({.gravity = {}});
    const BodyId id = world.create_body({}, box(1, 1));
    Body body = world.body(id);
    const float mass = body.mass_data().mass;
    body.apply_impulse_to_center(mass * Vec2{-4e6f, 2e6f});
    body.apply_angular_impulse(-3e6f * body.mass_data().inertia);
    ASSERT_LT(body.angular_velocity(), -max_speed);

    ASSERT_TRUE(world.step(1 / 60.0f).quarantined.empty());
    EXPECT_EQ(body.linear_velocity().x, -max_speed);
    EXPECT_NEAR(body.linear_velocity().y, max_speed / 2, 1);
    EXPECT_EQ(body.angular_velocity(), -max_speed);
    World again;
    again.create_body(
        {.position = body.position(), .linear_velocity = body.linear_velocity(), .angular_velocity = body.angular_velocity()});
}

TEST(Regression, a_kinematic_body_keeps_its_velocity_when_a_lost_body_hits_it)
{
    World world;
    const BodyId lift = world.create_body({.type = BodyType::Kinematic, .linear_velocity = {0, 0.5f}}, box(10, 1));
    const BodyId lost = world.create_body({.position = {0, 0.99f}}, circle(0.5f));
    world.step(1 / 60.0f);
    // Twice the largest float is infinite.
    for (int i = 0; i < 2; ++i) world.body(lost).apply_force_to_center({0, -3e38f});

    const StepReport report = world.step(1 / 60.0f);
    ASSERT_EQ(report.quarantined.size(), 1u);
    EXPECT_EQ(report.quarantined[0], lost);
    EXPECT_TRUE(world.body(lift).is_enabled());
    EXPECT_EQ(world.body(lift).linear_velocity(), (Vec2{0, 0.5f}));
    EXPECT_EQ(world.body(lift).angular_velocity(), 0);
}

} // namespace carom
