// What each kernel must keep: momentum, angular momentum, the friction cone, unilateral pushing.
#include "solver/kernels/contact_row.hpp"

#include "solver/kernels/bounce.hpp"

#include <carom/math.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace carom::detail
{
namespace
{

using Row = ContactRow<float, 2>;
using Lanes = BodyLanes<float>;

constexpr PassConstants<float> pass = {240, 3, 1, 1 / 48.0f};

float effective_mass(const Row& row, const PointRow<float>& point, LaneVec<float> u)
{
    const float arm_a = cross(point.r_a, u);
    const float arm_b = cross(point.r_b, u);
    return 1 / (dot(scale(row.inv_mass_a + row.inv_mass_b, u), u) + row.inv_inertia_a * arm_a * arm_a + row.inv_inertia_b * arm_b * arm_b);
}

/// Two bodies that meet at two points, with random everything.
struct RandomContact
{
    explicit RandomContact(unsigned seed) : engine(seed)
    {
        row.inv_mass_a = {0.5f, 0.5f};
        row.inv_mass_b = {2, 2};
        row.inv_inertia_a = from(0.1f, 3);
        row.inv_inertia_b = from(0.1f, 3);
        const Rot q = rotation(from(-3, 3));
        row.n = {q.c, q.s};
        row.friction = from(0, 1);
        row.restitution = from(0.1f, 1);
        row.tangent_speed = from(-1, 1);
        row.rolling_resistance = from(0, 0.2f);
        row.rolling_mass = 1 / (row.inv_inertia_a + row.inv_inertia_b);
        row.rolling_lambda = from(-0.1f, 0.1f);
        row.bias_rate = 20;
        row.mass_scale = 0.8f;
        row.impulse_scale = 0.2f;
        row.carried = from(0, 0.1f);
        for (PointRow<float>& point : row.points) fill(point);
        a = {{from(-2, 2), from(-2, 2)}, from(-2, 2), {}, {1, 0}};
        b = {{from(-2, 2), from(-2, 2)}, from(-2, 2), {}, {1, 0}};
    }

    float from(float min, float max) { return std::uniform_real_distribution<float>(min, max)(engine); }

    void fill(PointRow<float>& point)
    {
        const LaneVec<float> p = {from(-1, 1), from(-1, 1)}; // centres of mass at (0, 0) and at (1, 1)
        point = {};
        point.r_a = p;
        point.r_b = p - LaneVec<float>{1, 1};
        const float separation = from(-0.05f, 0.05f);
        point.adjusted_separation = separation - dot(point.r_b - point.r_a, row.n);
        point.normal_velocity = from(-5, 1);
        point.normal_mass = effective_mass(row, point, row.n);
        point.tangent_mass = effective_mass(row, point, right_perp(row.n));
        point.lambda_n = from(0, 1);
        point.lambda_t = from(-0.1f, 0.1f);
        point.total_n = from(0, 1);
    }

    struct Momentum
    {
        double x, y, angular;
    };

    /// About the centre of A.
    Momentum momentum() const
    {
        const double m_a = 1 / double{row.inv_mass_a.x};
        const double m_b = 1 / double{row.inv_mass_b.x};
        return {m_a * a.v.x + m_b * b.v.x, m_a * a.v.y + m_b * b.v.y,
                a.w / double{row.inv_inertia_a} + b.w / double{row.inv_inertia_b} + m_b * (double{b.v.y} - double{b.v.x})};
    }

    std::mt19937 engine;
    Row row = {};
    Lanes a = {};
    Lanes b = {};
};

template <class Kernel>
void expect_kept_momentum(Kernel&& kernel)
{
    bool has_changed = false;
    for (unsigned seed = 0; seed < 300; ++seed)
    {
        RandomContact c(seed);
        const auto before = c.momentum();
        const Lanes a = c.a;
        kernel(c.row, c.a, c.b);
        const auto after = c.momentum();
        ASSERT_NEAR(after.x, before.x, 2e-5) << seed;
        ASSERT_NEAR(after.y, before.y, 2e-5) << seed;
        ASSERT_NEAR(after.angular, before.angular, 1e-4) << seed;
        ASSERT_TRUE(std::isfinite(c.a.w + c.b.w));
        has_changed = has_changed || c.a.v.x != a.v.x;
    }
    EXPECT_TRUE(has_changed);
}

TEST(ContactRow, WarmStartKeepsMomentum)
{
    expect_kept_momentum([](Row& row, Lanes& a, Lanes& b) { warm_start(row, a, b); });
}

TEST(ContactRow, SolveKeepsMomentum)
{
    expect_kept_momentum([](Row& row, Lanes& a, Lanes& b) { solve(row, pass, a, b); });
}

TEST(ContactRow, RelaxKeepsMomentum)
{
    expect_kept_momentum([](Row& row, Lanes& a, Lanes& b) { relax(row, pass, a, b); });
}

TEST(ContactRow, BounceKeepsMomentum)
{
    expect_kept_momentum([](Row& row, Lanes& a, Lanes& b) { bounce(row, pass, a, b); });
}

TEST(ContactRow, PushesAndNeverPullsAndStaysInTheFrictionCone)
{
    for (unsigned seed = 0; seed < 300; ++seed)
    {
        RandomContact c(seed);
        solve(c.row, pass, c.a, c.b);
        relax(c.row, pass, c.a, c.b);
        float pressure = 0;
        for (const PointRow<float>& point : c.row.points)
        {
            EXPECT_GE(point.lambda_n, 0);
            EXPECT_LE(std::abs(point.lambda_t), c.row.friction * point.lambda_n);
            pressure += point.lambda_n;
        }
        EXPECT_LE(std::abs(c.row.rolling_lambda), c.row.rolling_resistance * pressure);
    }
}

TEST(ContactRow, TheRigidPassStopsTheApproachOfASinglePoint)
{
    for (unsigned seed = 0; seed < 100; ++seed)
    {
        RandomContact c(seed);
        PointRow<float>& point = c.row.points[0];
        point.adjusted_separation = -dot(point.r_b - point.r_a, c.row.n) - 0.01f; // overlapping
        point.lambda_n = 100;                                                     // far from the bound
        solve_normal<false>(c.row, point, pass, c.a, c.b);
        EXPECT_NEAR(dot(relative_velocity(point, c.a, c.b), c.row.n), 0, 2e-4) << seed;
    }
}

TEST(ContactRow, AnApproachEndsAtTheSurfaceAndNotBefore)
{
    RandomContact c(1);
    PointRow<float>& point = c.row.points[0];
    point.adjusted_separation = 0.01f - dot(point.r_b - point.r_a, c.row.n);
    point.lambda_n = 100;
    solve_normal<true>(c.row, point, pass, c.a, c.b);
    EXPECT_NEAR(dot(relative_velocity(point, c.a, c.b), c.row.n), -0.01f * pass.inv_h, 1e-3);
}

/// A ball whose core is its centre, and a corner that is its own core, both turned by 1 rad about where they are.
TEST(ContactRow, ABallThatTurnsStaysOnTheGroundAndACornerRises)
{
    const float gap = 0.01f;
    Row row = {};
    row.n = {0, 1};
    PointRow<float>& point = row.points[0];
    point.r_b = {0, -(0.5f + 0.5f * gap)}; // halfway between the surfaces
    point.adjusted_separation = gap - dot(point.r_b, row.n);
    const Lanes ground = {{}, 0, {}, {1, 0}};
    const Lanes turned = {{}, 0, {}, {std::cos(1.0f), std::sin(1.0f)}};

    row.core_a = 0.5f * gap;
    row.core_b = 0.5f + 0.5f * gap;
    EXPECT_NEAR(separation(row, point, ground, turned), gap, 1e-6);
    row.core_b = 0.5f * gap;
    EXPECT_NEAR(separation(row, point, ground, turned), gap + 0.5f * (1 - std::cos(1.0f)), 1e-6);
}

/// A square of 1 kg at 4 m/s, flat above the ground at the origin.
struct Landing
{
    explicit Landing(float gap)
    {
        row.inv_mass_b = {1, 1};
        row.inv_inertia_b = 6;
        row.n = {0, 1};
        row.restitution = 0.5f;
        for (std::size_t i = 0; i < 2; ++i)
        {
            PointRow<float>& point = row.points[i];
            point.r_a = {i == 0 ? -0.5f : 0.5f, 0};
            point.r_b = {i == 0 ? -0.5f : 0.5f, -0.5f};
            point.adjusted_separation = gap + 0.5f;
            point.normal_mass = effective_mass(row, point, row.n);
            point.tangent_mass = effective_mass(row, point, right_perp(row.n));
        }
    }

    Row row = {};
    Lanes ground = {{}, 0, {}, {1, 0}};
    Lanes box = {{0, -4}, 0, {}, {1, 0}};
};

TEST(ContactRow, ABounceReturnsTheApproachSpeedOfBothPointsOfAFace)
{
    Landing c(0.01f);
    EXPECT_GT(bounce(c.row, pass, c.ground, c.box), 0);
    EXPECT_NEAR(c.box.v.y, 2, 0.01);
    EXPECT_NEAR(c.box.w, 0, 0.01);
    EXPECT_EQ(c.ground.v.y, 0);
    EXPECT_NEAR(c.row.points[0].total_n + c.row.points[1].total_n, 6, 0.02);
    EXPECT_EQ(c.row.points[0].lambda_n, 0) << "no guess for the next step";
    EXPECT_EQ(bounce(c.row, pass, c.ground, c.box), 0) << "once";
}

TEST(ContactRow, ABounceRubsAsHardAsCoulombSays)
{
    Landing c(0);
    c.row.friction = 0.25f;
    c.box.v.x = 10;
    bounce(c.row, pass, c.ground, c.box);
    EXPECT_NEAR(c.box.v.x, 10 - 0.25f * 6, 0.02);
    EXPECT_GT(-c.box.w, 1) << "it tumbles forwards";
}

TEST(ContactRow, ABounceNeedsSpeedAMeetingAndRestitution)
{
    Landing slow(0);
    slow.box.v.y = -0.99f;
    Landing far(4 * pass.reach + 0.001f);
    Landing dull(0);
    dull.row.restitution = 0;
    for (Landing* c : {&slow, &far, &dull})
    {
        const Lanes before = c->box;
        EXPECT_EQ(bounce(c->row, pass, c->ground, c->box), 0);
        EXPECT_EQ(c->box.v.x, before.v.x);
        EXPECT_EQ(c->box.v.y, before.v.y);
        EXPECT_EQ(c->box.w, before.w);
    }
}

} // namespace
} // namespace carom::detail
