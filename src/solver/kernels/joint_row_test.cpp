// What each part of a joint row must keep: momentum, the limits of motors, springs and drives, and one-sided pushing.
#include "solver/kernels/joint_kernels.hpp"
#include "solver/rows/softness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace carom::detail
{
namespace
{

using PlainRow = JointRow<float>;
using PlainBody = BodyLanes<float>;

constexpr JointConstants<float> joint_constants = {1 / 240.0f, 240, 50, 0.9f, 0.1f, 1};

/// Two bodies with random everything, A's centre of mass at the origin, that meet at a point.
struct RandomJointRow
{
    explicit RandomJointRow(unsigned seed, RowType type) : engine(seed)
    {
        row.type = type;
        row.inv_mass_a = {0.5f, 0.5f};
        row.inv_mass_b = {2, 2};
        row.inv_inertia_a = from(0.1f, 3);
        row.inv_inertia_b = from(0.1f, 3);
        row.arm_a = {from(-1, 1), from(-1, 1)};
        row.arm_b = row.arm_a - center_b;
        const Rot q = rotation(from(-3, 3));
        row.axis = {q.c, q.s};
        row.length = 1;
        a = {{from(-2, 2), from(-2, 2)}, from(-2, 2), {}, {1, 0}};
        b = {{from(-2, 2), from(-2, 2)}, from(-2, 2), {}, {1, 0}};
        for (ControlRow<float>& c : row.controls)
        {
            c.lower = -1e12f;
            c.upper = 1e12f;
            c.spring = {0, 0, 1};
            c.max_spring = 1e30f;
        }
        row.drive.spring = {0, 0, 1};
        for (float& lambda : row.lambda) lambda = from(-1, 1);
    }

    float from(float min, float max) { return std::uniform_real_distribution<float>(min, max)(engine); }

    /// Along a row of the joint.
    float speed(const Jacobian<float>& j) const { return velocity(j, a, b); }

    static constexpr LaneVec<float> center_b = {1, 1};
    std::mt19937 engine;
    PlainRow row = {};
    PlainBody a = {};
    PlainBody b = {};
};

struct JointMomentum
{
    double x, y, angular;
};

/// About the centre of A.
JointMomentum momentum(const RandomJointRow& c)
{
    const double m_a = 1 / double{c.row.inv_mass_a.x};
    const double m_b = 1 / double{c.row.inv_mass_b.x};
    return {m_a * double{c.a.v.x} + m_b * double{c.b.v.x}, m_a * double{c.a.v.y} + m_b * double{c.b.v.y},
            double{c.a.w} / double{c.row.inv_inertia_a} + double{c.b.w} / double{c.row.inv_inertia_b} +
                m_b * (double{c.b.v.y} - double{c.b.v.x})};
}

/// A slider on a rail, with its coordinate and what acts on it.
struct Slider : RandomJointRow
{
    explicit Slider(unsigned seed) : RandomJointRow(seed, RowType::Prismatic)
    {
        row.control_count = 1;
        linearise(row, a, b);
        find_held_mass(row, control());
    }
    ControlRow<float>& control() { return row.controls[0]; }
    float rate() { return speed(row.controls[0].j); }
};

/// Two bodies that are pinned together, with their angle and what acts on it.
struct Hinge : RandomJointRow
{
    explicit Hinge(unsigned seed) : RandomJointRow(seed, RowType::Revolute)
    {
        row.rigid_count = 2;
        row.control_count = 1;
        linearise(row, a, b);
        find_held_mass(row, control());
    }
    ControlRow<float>& control() { return row.controls[0]; }
    double energy() const
    {
        const auto of = [](const PlainBody& body, float inv_mass, float inv_inertia)
        { return 0.5 * double{dot(body.v, body.v)} / double{inv_mass} + 0.5 * double{body.w} * double{body.w} / double{inv_inertia}; };
        return of(a, row.inv_mass_a.x, row.inv_inertia_a) + of(b, row.inv_mass_b.x, row.inv_inertia_b);
    }
};

} // namespace

TEST(JointRow, InnerForcesKeepMomentum)
{
    const auto spring = make_spring(5, 0.3f, joint_constants.h);
    for (const RowType type : {RowType::Revolute, RowType::Prismatic, RowType::Wheel, RowType::Weld, RowType::Distance, RowType::Motor})
        for (unsigned seed = 0; seed < 100; ++seed)
        {
            RandomJointRow c(seed, type);
            c.row.rigid_count = type == RowType::Weld                                 ? 3
                                : type == RowType::Motor                              ? 0
                                : type == RowType::Distance || type == RowType::Wheel ? 1
                                                                                      : 2;
            c.row.control_count = type == RowType::Weld ? 0 : type == RowType::Wheel ? 2 : 1;
            c.row.has_drive = type == RowType::Motor;
            // Those that slide may be apart; so may what is pulled.
            const bool may_be_apart = type != RowType::Revolute && type != RowType::Weld;
            if (may_be_apart) c.row.apart = {c.from(-1, 1), c.from(-1, 1)};
            if (may_be_apart) c.row.arm_b = c.row.arm_b + c.row.apart;
            for (ControlRow<float>& control : c.row.controls)
            {
                control.lower = c.from(-1, 0);
                control.upper = c.from(0, 1);
                control.motor_speed = c.from(-2, 2);
                control.max_motor = 0.3f;
                control.spring = spring;
                control.lambda_lower = c.from(0, 1);
            }
            c.row.drive = {{}, spring, 5, {c.from(-1, 1), c.from(-1, 1)}};
            linearise(c.row, c.a, c.b);
            const JointMomentum before = momentum(c);
            const float spin = c.a.w;
            warm_start(c.row, c.a, c.b);
            bend(c.row, c.a, c.b, joint_constants);
            solve<true>(c.row, joint_constants, c.a, c.b);
            solve<false>(c.row, joint_constants, c.a, c.b);
            const JointMomentum after = momentum(c);
            ASSERT_NEAR(after.x, before.x, 1e-4) << static_cast<int>(type) << ", " << seed;
            ASSERT_NEAR(after.y, before.y, 1e-4) << static_cast<int>(type) << ", " << seed;
            ASSERT_NEAR(after.angular, before.angular, 2e-4) << static_cast<int>(type) << ", " << seed;
            ASSERT_NE(c.a.w, spin);
        }
}

TEST(JointRow, TheRigidPassStopsAllRowsAtOnce)
{
    for (unsigned seed = 0; seed < 100; ++seed)
    {
        RandomJointRow c(seed, RowType::Weld);
        c.row.rigid_count = 3;
        linearise(c.row, c.a, c.b);
        solve<false>(c.row, joint_constants, c.a, c.b);
        for (const Jacobian<float>& j : c.row.rigid) ASSERT_NEAR(c.speed(j), 0, 2e-4) << seed;
    }
}

TEST(JointRow, AnErrorIsUndoneNoFasterThanTheLimit)
{
    RandomJointRow c(1, RowType::Revolute);
    c.row.rigid_count = 2;
    for (const float error : {0.0f, 0.01f, 1.0f, -1.0f, 1e6f})
    {
        c.row.error[0] = error;
        EXPECT_EQ(bias_of(c.row, 0, joint_constants), std::min(std::max(50 * error, -max_bias), max_bias));
    }
}

TEST(JointRow, ASoftPinThatIsFarOpenClosesUnderAnyLoad)
{
    RandomJointRow c(1, RowType::Revolute);
    c.row.rigid_count = 2;
    c.row.inv_mass_a = {0, 0};
    c.row.inv_inertia_a = 0;
    c.row.inv_mass_b = {1, 1};
    c.row.inv_inertia_b = 0;
    c.a = {{0, 0}, 0, {}, {1, 0}};
    c.b = {{0, 0}, 0, {}, {1, 0}};
    linearise(c.row, c.a, c.b);
    c.row.error[0] = 10; // B is 10 m to the right of its place
    c.row.lambda = {};
    for (int substep = 0; substep < 200; ++substep)
    {
        c.b.v.x += 1000; // far beyond mass_scale / impulse_scale max_bias = 36 m/s
        warm_start(c.row, c.a, c.b);
        solve<true>(c.row, joint_constants, c.a, c.b);
    }
    EXPECT_NEAR(c.b.v.x, -max_bias, 1);
}

TEST(JointRow, AMotorReachesItsSpeedOrItsLimit)
{
    for (unsigned seed = 0; seed < 100; ++seed)
    {
        Slider strong(seed);
        strong.control().motor_speed = 3;
        strong.control().max_motor = 1e6f;
        solve_motor(strong.row, strong.control(), strong.a, strong.b);
        EXPECT_NEAR(strong.rate(), 3, 1e-4) << seed;

        Slider weak(seed);
        weak.control().motor_speed = 1000;
        weak.control().max_motor = 0.25f;
        for (int i = 0; i < 3; ++i) solve_motor(weak.row, weak.control(), weak.a, weak.b);
        EXPECT_EQ(weak.control().lambda_motor, 0.25f) << seed;
        weak.control().motor_speed = -1000;
        solve_motor(weak.row, weak.control(), weak.a, weak.b);
        EXPECT_EQ(weak.control().lambda_motor, -0.25f) << seed;
    }
}

TEST(JointRow, APinnedMotorReachesItsSpeedOnceThePinHolds)
{
    for (unsigned seed = 0; seed < 100; ++seed)
    {
        Hinge c(seed);
        c.control().motor_speed = 3;
        c.control().max_motor = 1e6f;
        solve_motor(c.row, c.control(), c.a, c.b);
        solve_rigid<false>(c.row, joint_constants, c.a, c.b);
        EXPECT_NEAR(c.speed(c.control().j), 3, 1e-3) << seed;
    }
}

TEST(JointRow, AnEndAddsNoEnergyWhateverABlowDidToThePin)
{
    for (unsigned seed = 0; seed < 100; ++seed)
    {
        Hinge c(seed);
        c.row.inv_mass_b = {50, 50}; // a light limb
        c.row.inv_inertia_b = 5000;
        linearise(c.row, c.a, c.b);
        find_held_mass(c.row, c.control());
        c.control().lower = c.control().upper = c.control().q;
        double energy = c.energy();
        for (int pass = 0; pass < 20; ++pass)
        {
            solve_range<false>(c.row, c.control(), joint_constants, c.a, c.b);
            EXPECT_LE(c.energy(), 1.001 * energy) << seed << ", " << pass;
            energy = c.energy();
        }
    }
}

TEST(JointRow, AnEndOfARangeStopsWhereItIsAndPushesOneWay)
{
    for (unsigned seed = 0; seed < 100; ++seed)
    {
        // 1 cm above the lower end and falling towards it: the rest of the way in this substep, and no more.
        Slider c(seed);
        c.control().lower = c.control().q - 0.01f;
        const Jacobian<float> j = c.control().j;
        apply(c.row, j, -(c.rate() + 10) * c.control().mass, c.a, c.b); // now at -10 m/s
        solve_range<true>(c.row, c.control(), joint_constants, c.a, c.b);
        EXPECT_NEAR(c.rate(), -0.01f * joint_constants.inv_h, 1e-3) << seed;
        EXPECT_GT(c.control().lambda_lower, 0);
        EXPECT_EQ(c.control().lambda_upper, 0);

        // Moving away, nothing holds it.
        Slider away(seed);
        away.control().lower = away.control().q;
        apply(away.row, j, (2 - away.rate()) * away.control().mass, away.a, away.b);
        solve_range<true>(away.row, away.control(), joint_constants, away.a, away.b);
        EXPECT_NEAR(away.rate(), 2, 1e-3);
        EXPECT_EQ(away.control().lambda_lower, 0);

        // Past the upper end it is brought back, at a share of the error a substep.
        Slider past(seed);
        past.control().upper = past.control().q - 0.02f;
        solve_range<true>(past.row, past.control(), joint_constants, past.a, past.b);
        EXPECT_LT(past.rate(), -0.02f * joint_constants.bias_rate + 1e-3f);
        EXPECT_GE(past.control().lambda_upper, 0);
    }
}

TEST(JointRow, ASpringWithALimitPullsNoHarder)
{
    Slider c(4);
    c.control().spring = make_spring(20, 1, joint_constants.h);
    c.control().target = c.control().q + 100;
    c.control().max_spring = 0.125f;
    for (int i = 0; i < 3; ++i) solve_spring(c.row, c.control(), c.a, c.b);
    EXPECT_EQ(c.control().lambda_spring, 0.125f);
}

TEST(JointRow, ADriveWithALimitPullsNoHarder)
{
    for (unsigned seed = 0; seed < 50; ++seed)
    {
        RandomJointRow c(seed, RowType::Motor);
        c.row.has_drive = true;
        c.row.drive = {{3, -4}, make_spring(20, 1, joint_constants.h), 0.5f, {}};
        for (int i = 0; i < 3; ++i) solve_drive(c.row, c.a, c.b);
        EXPECT_NEAR(std::sqrt(dot(c.row.drive.lambda, c.row.drive.lambda)), 0.5f, 1e-5) << seed;
    }
}

TEST(JointRow, WhatIsNotThereDoesNothing)
{
    for (unsigned seed = 0; seed < 20; ++seed)
    {
        Slider c(seed);
        const PlainBody a = c.a;
        const PlainBody b = c.b;
        solve<true>(c.row, joint_constants, c.a, c.b);
        EXPECT_EQ(c.a.v.x, a.v.x);
        EXPECT_EQ(c.b.v.y, b.v.y);
        EXPECT_EQ(c.b.w, b.w);
    }
}

TEST(JointRow, SumsUpTheForceAndTheTorqueAtTheJointsPoint)
{
    // A pin's impulse has no moment about the pin; a motor's has.
    RandomJointRow c(7, RowType::Revolute);
    c.row.rigid_count = 2;
    c.row.control_count = 1;
    linearise(c.row, c.a, c.b);
    c.row.lambda = {3, 4, 0};
    c.row.controls[0].lambda_motor = 5;
    sum_up(c.row);
    sum_up(c.row);
    EXPECT_NEAR(c.row.total_impulse.x, 6, 1e-5);
    EXPECT_NEAR(c.row.total_impulse.y, 8, 1e-5);
    EXPECT_NEAR(c.row.total_twist, 10, 1e-5);
}

TEST(SpringRow, SwingsAndDampsLikeTheSpringThatItStandsFor)
{
    const float h = 1 / 240.0f;
    for (const float hertz : {0.5f, 2.0f, 8.0f})
        for (const float zeta : {0.0f, 0.2f, 0.7f})
        {
            const SpringRow<float> spring = make_spring(hertz, zeta, h);
            const double omega = 2 * double{pi} * double{hertz};
            double x = 1, v = 0, lambda = 0; // of unit mass
            const int steps = static_cast<int>(2 / hertz / h);
            double energy = 0;
            for (int i = 0; i < steps; ++i)
            {
                v += lambda; // warm start
                const double change = -double{spring.damping} * v - double{spring.push} * x - double{spring.impulse_scale} * lambda;
                lambda += change;
                v += change;
                x += double{h} * v;
                energy = 0.5 * v * v + 0.5 * omega * omega * x * x;
            }
            const double t = steps * double{h};
            const double damped = omega * std::sqrt(1 - double{zeta} * double{zeta});
            const double expected =
                std::exp(-double{zeta} * omega * t) * (std::cos(damped * t) + double{zeta} * omega / damped * std::sin(damped * t));
            EXPECT_NEAR(x, expected, 0.13 * double{hertz} / 8 + 0.01) << hertz << " Hz, damping " << zeta;
            const double kept = zeta == 0 ? 1 : 0;
            EXPECT_NEAR(energy / (0.5 * omega * omega), kept, 0.12) << hertz << " Hz, damping " << zeta;
        }
}

TEST(SpringRow, IsStableAtAnyStiffness)
{
    for (const float hertz : {1.0f, 19.0f, 30.0f, 100.0f, 1e4f})
        for (const float zeta : {0.0f, 0.5f, 10.0f, 1e6f})
            for (const float h : {1e-4f, 1 / 240.0f, 0.1f, 1.0f})
            {
                const SpringRow<float> spring = make_spring(hertz, zeta, h);
                double x = 1, v = 0, lambda = 0;
                for (int i = 0; i < 2000; ++i)
                {
                    v += lambda;
                    const double change = -double{spring.damping} * v - double{spring.push} * x - double{spring.impulse_scale} * lambda;
                    lambda += change;
                    v += change;
                    x += double{h} * v;
                    ASSERT_LT(std::abs(x), 1.5) << hertz << " Hz, damping " << zeta << ", substep " << h;
                }
            }
}

} // namespace carom::detail
