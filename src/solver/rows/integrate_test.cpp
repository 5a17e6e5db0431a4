#include "solver/rows/integrate.hpp"

#include "solver/isa/dispatch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

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
    integrate_velocities(scalar_passes().bodies, {motions, masses, drives}, {0, -10}, fields, 0.5f);
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
    integrate_velocities(scalar_passes().bodies, {motions, masses, drives}, {0, -10}, {}, 1);
    EXPECT_EQ(motions[1].v, (Vec2{2.5f, 0})) << "(4 + 1) / (1 + 1), and no gravity at scale 0";
    EXPECT_FLOAT_EQ(motions[1].w, 0.75f) << "(2 + 1) / (1 + 3)";
}

TEST(IntegratePositions, AddsUpTheWay)
{
    std::array<BodyMotion, 2> motions;
    motions[1].v = {1, -2};
    motions[1].w = 1;
    for (int i = 0; i < 10; ++i) integrate_positions(scalar_passes().bodies, motions, 0.1f);
    EXPECT_NEAR(motions[1].dp.x, 1, 1e-6);
    EXPECT_NEAR(motions[1].dp.y, -2, 1e-6);
    EXPECT_NEAR(angle(motions[1].dq), 1, 1e-5);
    EXPECT_EQ(motions[0].dq, Rot{});
}

TEST(IntegrateLanes, GiveTheBitsOfOneLaneForAnyNumberOfBodies)
{
    std::mt19937 engine(3);
    const auto from = [&](float min, float max) { return std::uniform_real_distribution<float>(min, max)(engine); };
    for (std::size_t count = 1; count < 40; ++count)
    {
        std::vector<BodyMotion> motions(count);
        std::vector<BodyMass> masses(count);
        std::vector<BodyDrive> drives(count);
        for (std::size_t i = 0; i < count; ++i)
        {
            motions[i] = {
                .v = {from(-9, 9), from(-9, 9)}, .w = from(-90, 90), .dp = {from(-1, 1), from(-1, 1)}, .dq = rotation(from(-1, 1))};
            motions[i].slot = static_cast<std::uint32_t>(i);
            masses[i] = {{from(0, 2), from(0, 2)}, from(0, 2)};
            drives[i] = {{from(-5, 5), from(-5, 5)}, from(-5, 5), {from(0, 2), from(0, 2)}, from(0, 1), from(0, 1)};
        }
        const auto moved = [&](Simd simd)
        {
            std::vector<BodyMotion> after = motions;
            const BodyPasses& passes = passes_of(simd).bodies;
            integrate_velocities(passes, {after, masses, drives}, {1, -10}, {}, 0.01f);
            integrate_positions(passes, after, 0.01f);
            return after;
        };
        const std::vector<BodyMotion> expected = moved(Simd::Scalar);
        EXPECT_EQ(std::memcmp(&expected[0], &motions[0], sizeof(BodyMotion)), 0) << "the ground stays";
        for (const Simd simd : all_simd)
        {
            if (!is_available(simd)) continue;
            EXPECT_EQ(std::memcmp(moved(simd).data(), expected.data(), count * sizeof(BodyMotion)), 0) << count;
        }
    }
}

} // namespace
} // namespace carom::detail
