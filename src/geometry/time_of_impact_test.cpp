// Times of impact against dense sampling of the motion.
#include "geometry/random_shapes.hpp"
#include "geometry/time_of_impact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace carom::detail
{

namespace
{

constexpr float target = 0.005f;

Sweep resting(Vec2 at) { return {.local_center = {}, .center_start = at, .center_end = at, .q_start = {}, .turn = 0}; }

Sweep moving(Vec2 from, Vec2 to, float turn = 0)
{
    return {.local_center = {}, .center_start = from, .center_end = to, .q_start = {}, .turn = turn};
}

float distance_at(const ConvexPoints& a, const Sweep& sweep_a, const ConvexPoints& b, const Sweep& sweep_b, float time)
{
    return distance(a, b, relative(sweep_a.at(time), sweep_b.at(time))).distance;
}

/// @param aim half the width of what the ways lead through in the middle, so that many meet [m]
Sweep random_sweep(RandomShapes& random, float aim, float reach, float way, float most_turn)
{
    Sweep sweep;
    sweep.local_center = random.point(0.5f);
    sweep.center_start = random.point(reach);
    const Vec2 heading = normalize(random.point(aim) - sweep.center_start);
    sweep.center_end = sweep.center_start + random.uniform(0, way) * heading;
    sweep.q_start = rotation(random.uniform(-pi, pi));
    sweep.turn = random.uniform(-most_turn, most_turn);
    return sweep;
}

/// Kinds of motion in a step.
struct Motion
{
    const char* name;
    float size;  ///< of the shapes [m]
    float reach; ///< of the places [m]
    float way;   ///< [m]
    float turn;  ///< [rad]
    float where; ///< of both, in the world [m]
};

const Motion motions[] = {
    {"gentle", 1, 2, 0.5f, 0.2f, 0},           {"fast", 1, 10, 17, pi, 0}, // 1000 m/s and half a turn at 60 steps a second
    {"spinning in place", 1, 2, 0.05f, pi, 0}, {"no turn", 1, 10, 30, 0, 0},
    {"small bullets", 0.05f, 0.5f, 17, pi, 0}, {"large", 30, 100, 200, pi, 0},
    {"far out", 1, 4, 10, pi, 3000},
};

} // namespace

TEST(TimeOfImpact, BulletAtWall)
{
    const ConvexPoints wall = convex_points(box(0.1f, 10));
    const ConvexPoints ball = convex_points(circle(0.05f));
    const auto time = time_of_impact(wall, resting({10, 0}), ball, moving({0, 0}, {20, 0}), target);
    ASSERT_TRUE(time);
    EXPECT_NEAR(*time, (10 - 0.05f - 0.05f - target) / 20, Tolerances{}.impact_tolerance / 20 + 1e-6f);
}

TEST(TimeOfImpact, TwoBoxesThatMeetHeadOn)
{
    const ConvexPoints cube = convex_points(box(0.1f, 0.1f));
    const auto time = time_of_impact(cube, moving({-1, 0}, {1, 0}), cube, moving({1, 0}, {-1, 0}), target);
    ASSERT_TRUE(time);
    EXPECT_NEAR(*time, (2 - 0.1f - target) / 4, 1e-4f);
}

TEST(TimeOfImpact, TipOfAPlankThatTurns)
{
    // The tip of the lower edge comes down to the ball when the plank has turned by the ball's angle from the hub.
    const ConvexPoints plank = convex_points(box(10, 0.1f));
    const ConvexPoints ball = convex_points(circle(0.1f));
    const Vec2 at = 4 * Vec2{rotation(-1).c, rotation(-1).s};
    const auto time = time_of_impact(plank, moving({0, 0}, {0, 0}, -pi), ball, resting(at), target);
    ASSERT_TRUE(time);
    const float contact_angle = 1 - std::asin((0.1f + 0.05f + target) / 4);
    EXPECT_NEAR(*time, contact_angle / pi, 1e-4f);
}

TEST(TimeOfImpact, StartingNearerThanTheTargetIsZero)
{
    const ConvexPoints cube = convex_points(box(1, 1));
    EXPECT_EQ(time_of_impact(cube, resting({0, 0}), cube, moving({1.004f, 0}, {3, 0}), target), 0.0f);
    EXPECT_EQ(time_of_impact(cube, resting({0, 0}), cube, moving({0.5f, 0}, {3, 0}), target), 0.0f);
    EXPECT_EQ(time_of_impact(cube, resting({0, 0}), cube, resting({0, 0}), target), 0.0f);
}

TEST(TimeOfImpact, PartingJustBeyondTheTargetIsNone)
{
    const ConvexPoints cube = convex_points(box(1, 1));
    EXPECT_FALSE(time_of_impact(cube, resting({0, 0}), cube, moving({1.00501f, 0}, {3, 0}), target));
    EXPECT_FALSE(time_of_impact(cube, resting({0, 0}), cube, resting({1.00501f, 0}), target));
    EXPECT_FALSE(time_of_impact(cube, resting({0, 0}), cube, moving({1.0053f, -4}, {1.0053f, 4}), target)) << "passing by";
}

TEST(TimeOfImpact, FullTurnsCount)
{
    const ConvexPoints plank = convex_points(box(2, 0.1f));
    const ConvexPoints ball = convex_points(circle(0.05f));
    EXPECT_TRUE(time_of_impact(plank, moving({0, 0}, {0, 0}, 2 * pi), ball, resting({0, 0.8f}), target));
    EXPECT_TRUE(time_of_impact(plank, moving({0, 0}, {0, 0}, 20 * pi), ball, resting({0, 0.8f}), target));
    EXPECT_FALSE(time_of_impact(plank, moving({0, 0}, {0, 0}, 4 * pi), ball, resting({0, 1.2f}), target));
}

TEST(TimeOfImpact, SweepTurnsAboutItsCentre)
{
    const Sweep sweep = {.local_center = {1, 0}, .center_start = {5, 5}, .center_end = {7, 5}, .q_start = {}, .turn = pi};
    const Transform half = sweep.at(0.5f);
    EXPECT_NEAR((half * sweep.local_center).x, 6, 1e-6f);
    EXPECT_NEAR(half.p.y, 4, 1e-6f);
    EXPECT_NEAR(sweep.at(1).p.x, 8, 1e-6f);
}

class TimeOfImpactOf : public testing::TestWithParam<std::size_t>
{
};

/// Never late: no sample before the time is nearer than the target, less what rounding does to the coordinates. And no earlier than need
/// be: at the time the shapes are at the target.
TEST_P(TimeOfImpactOf, RandomMotionIsNeitherLateNorEarly)
{
    const Motion& motion = motions[GetParam()];
    const float rounding = 1e-6f * (motion.where + motion.reach + motion.way + 2 * motion.size);
    constexpr int samples = 400;
    constexpr int pairs = 1500;
    RandomShapes random(60 + static_cast<std::uint32_t>(GetParam()));
    int hits = 0;
    int early = 0;
    for (int i = 0; i < pairs; ++i)
    {
        const ConvexPoints a = convex_points(random.geometry_of(random.integer(0, 3), motion.size));
        const ConvexPoints b = convex_points(random.geometry_of(random.integer(0, 3), i % 3 == 0 ? 5 * motion.size : motion.size));
        Sweep sweep_a = random_sweep(random, motion.size, motion.reach, motion.way, motion.turn);
        Sweep sweep_b = random_sweep(random, motion.size, motion.reach, motion.way, motion.turn);
        for (Sweep* sweep : {&sweep_a, &sweep_b})
        {
            sweep->center_start += {motion.where, -motion.where};
            sweep->center_end += {motion.where, -motion.where};
        }

        const std::optional<float> time = time_of_impact(a, sweep_a, b, sweep_b, target);
        for (int k = 0; k <= samples; ++k)
        {
            const float at = static_cast<float>(k) / static_cast<float>(samples) * time.value_or(1);
            if (time == 0.0f) break; // they start nearer
            ASSERT_GT(distance_at(a, sweep_a, b, sweep_b, at), target - rounding) << i << " at " << at << " of " << time.value_or(-1);
        }
        if (!time) continue;
        ++hits;
        early += distance_at(a, sweep_a, b, sweep_b, *time) > target + Tolerances{}.impact_tolerance + rounding;
    }
    EXPECT_GT(hits, pairs / 10);
    EXPECT_EQ(early, 0);
}

std::string motion_name(const testing::TestParamInfo<std::size_t>& info)
{
    std::string name = motions[info.param].name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Motions, TimeOfImpactOf, testing::Range<std::size_t>(0, std::size(motions)), motion_name);

/// From either side.
TEST(TimeOfImpact, IsTheSameFromTheOtherSide)
{
    RandomShapes random(71);
    int hits = 0;
    int disagreements = 0; // one passes by within rounding
    for (int i = 0; i < 2000; ++i)
    {
        const ConvexPoints a = convex_points(random.geometry_of(random.integer(0, 3), 1));
        const ConvexPoints b = convex_points(random.geometry_of(random.integer(0, 3), 1));
        const Sweep sweep_a = random_sweep(random, 1, 5, 10, 1);
        const Sweep sweep_b = random_sweep(random, 1, 5, 10, 1);
        const auto ab = time_of_impact(a, sweep_a, b, sweep_b, target);
        const auto ba = time_of_impact(b, sweep_b, a, sweep_a, target);
        disagreements += ab.has_value() != ba.has_value();
        if (!ab || !ba) continue;
        ++hits;
        const float way = 30;
        ASSERT_NEAR(*ab, *ba, 50 * Tolerances{}.impact_tolerance / way + 1e-3f) << i;
    }
    EXPECT_GT(hits, 200);
    EXPECT_LE(disagreements, 5);
}

} // namespace carom::detail
