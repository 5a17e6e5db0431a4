#include "solver/rows/integrate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace carom::detail
{
namespace
{

TEST(Turned, IsAsExactAsItSays)
{
    for (float turn = -0.4f; turn <= 0.4f; turn += 0.01f) EXPECT_NEAR(angle(turned(rotation(0.3f), turn)), 0.3f + turn, 1e-5) << turn;
}

TEST(Turned, HasUnitLengthWhateverTheTurn)
{
    for (const float size :
         {0.0f, 1e-30f, 0.1f, 1.0f, 10.0f, 1e3f, 2e4f, 3e4f, 1e6f, 1e9f, 1e15f, 1e30f, std::numeric_limits<float>::max()})
        for (const float turn : {size, -size})
        {
            const Rot q = turned(rotation(1), turn);
            EXPECT_NEAR(q.c * q.c + q.s * q.s, 1, 1e-5) << turn;
        }
}

TEST(Turned, NeverTurnsTheWrongWayUpToHalfATurn)
{
    for (float turn = 0; turn < 3; turn += 0.1f) EXPECT_GE(angle(turned({}, turn)), 0) << turn;
    EXPECT_EQ(turned({}, 0), Rot{});
}

TEST(IntegrateVelocities, NeverWritesWhatStandsForTheGround)
{
    std::array<BodyMotion, 2> motions;
    std::array<BodyMass, 2> masses;
    std::array<BodyDrive, 2> drives;
    drives[1].gravity_scale = {1, 1};
    const std::array<Vec2, 2> fields = {Vec2{9, 9}, Vec2{0, 3}};
    integrate_velocities(motions, masses, drives, {0, -10}, fields, 0.5f);
    EXPECT_EQ(motions[0].v, Vec2{});
    EXPECT_EQ(motions[1].v, (Vec2{0, -3.5f})) << "gravity and field";
}

TEST(IntegrateVelocities, ForcesAndDampingByTheImplicitFormula)
{
    std::array<BodyMotion, 2> motions;
    motions[1].v = {4, 0};
    motions[1].w = 2;
    const std::array<BodyMass, 2> masses = {BodyMass{}, BodyMass{.inv_mass = {0.5f, 0.5f}, .inv_inertia = 0.25f}};
    const std::array<BodyDrive, 2> drives = {
        BodyDrive{}, BodyDrive{.force = {2, 0}, .torque = 4, .gravity_scale = {}, .linear_damping = 1, .angular_damping = 3}};
    integrate_velocities(motions, masses, drives, {0, -10}, {}, 1);
    EXPECT_EQ(motions[1].v, (Vec2{2.5f, 0})) << "(4 + 1) / (1 + 1), and no gravity at scale 0";
    EXPECT_FLOAT_EQ(motions[1].w, 0.75f) << "(2 + 1) / (1 + 3)";
}

TEST(IntegratePositions, AddsUpTheWay)
{
    std::array<BodyMotion, 2> motions;
    motions[1].v = {1, -2};
    motions[1].w = 1;
    for (int i = 0; i < 10; ++i) integrate_positions(motions, 0.1f);
    EXPECT_NEAR(motions[1].dp.x, 1, 1e-6);
    EXPECT_NEAR(motions[1].dp.y, -2, 1e-6);
    EXPECT_NEAR(angle(motions[1].dq), 1, 1e-5);
    EXPECT_EQ(motions[0].dq, Rot{});
}

} // namespace
} // namespace carom::detail
