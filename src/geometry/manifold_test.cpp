// Contact points in places where they are known by hand.
#include "geometry/manifold.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace carom::detail
{

namespace
{

constexpr float tolerance = 1e-5f;

Transform at(float x, float y, float angle = 0) { return {{x, y}, rotation(angle)}; }

void expect_vec(Vec2 actual, Vec2 expected, float within = tolerance)
{
    EXPECT_NEAR(actual.x, expected.x, within);
    EXPECT_NEAR(actual.y, expected.y, within);
}

/// Both points, from left to right.
std::array<LocalPoint, 2> sorted_points(const LocalManifold& manifold)
{
    std::array<LocalPoint, 2> points = manifold.points;
    if (points[1].position.x < points[0].position.x) std::swap(points[0], points[1]);
    return points;
}

} // namespace

TEST(Manifold, CircleCircle)
{
    const LocalManifold m = collide(circle(1), circle(2), at(2.4f, 0));
    ASSERT_EQ(m.count, 1);
    expect_vec(m.normal, {1, 0});
    EXPECT_NEAR(m.points[0].separation, -0.6f, tolerance);
    expect_vec(m.points[0].position, {0.7f, 0}); // halfway between 1 and 2.4 - 2
    EXPECT_EQ(collide(circle(1), circle(2), at(3.01f, 0)).count, 1);
    EXPECT_EQ(collide(circle(1), circle(2), at(3.03f, 0)).count, 0);
}

TEST(Manifold, CirclesAtTheSamePlaceHaveANormal)
{
    const LocalManifold m = collide(circle(1), circle(2), {});
    ASSERT_EQ(m.count, 1);
    EXPECT_NEAR(length(m.normal), 1, tolerance);
    EXPECT_NEAR(m.points[0].separation, -3, tolerance);
}

TEST(Manifold, CircleOnBoxFaceCornerAndInside)
{
    const LocalManifold face = collide(box(2, 2), circle(0.5f), at(0.3f, 1.4f));
    ASSERT_EQ(face.count, 1);
    expect_vec(face.normal, {0, 1});
    EXPECT_NEAR(face.points[0].separation, -0.1f, tolerance);
    expect_vec(face.points[0].position, {0.3f, 0.95f});

    const LocalManifold corner = collide(box(2, 2), circle(0.5f), at(1.3f, 1.4f));
    ASSERT_EQ(corner.count, 1);
    expect_vec(corner.normal, {0.6f, 0.8f});
    EXPECT_NEAR(corner.points[0].separation, 0, tolerance);
    expect_vec(corner.points[0].position, {1, 1});

    const LocalManifold inside = collide(box(2, 2), circle(0.5f), at(0.9f, 0));
    ASSERT_EQ(inside.count, 1);
    expect_vec(inside.normal, {1, 0});
    EXPECT_NEAR(inside.points[0].separation, -0.6f, tolerance);
}

TEST(Manifold, CircleAgainstCapsuleAndSegment)
{
    const LocalManifold side = collide(capsule({-1, 0}, {1, 0}, 0.5f), circle(0.25f), at(0.5f, -0.7f));
    ASSERT_EQ(side.count, 1);
    expect_vec(side.normal, {0, -1});
    EXPECT_NEAR(side.points[0].separation, -0.05f, tolerance);

    const LocalManifold end = collide(circle(0.25f), segment({1, 0}, {5, 0}), at(-0.8f, 0));
    ASSERT_EQ(end.count, 1);
    expect_vec(end.normal, {1, 0});
    EXPECT_NEAR(end.points[0].separation, -0.05f, tolerance);
    EXPECT_EQ(collide(circle(0.25f), segment({1, 0}, {5, 0}), at(-0.7f, 0)).count, 0);
}

TEST(Manifold, SegmentsCollideFromBothSides)
{
    const Segment ground = segment({-5, 0}, {5, 0});
    expect_vec(collide(ground, circle(0.5f), at(0, 0.49f)).normal, {0, 1});
    expect_vec(collide(ground, circle(0.5f), at(0, -0.49f)).normal, {0, -1});
    expect_vec(collide(ground, box(1, 1), at(0, 0.49f)).normal, {0, 1});
    expect_vec(collide(ground, box(1, 1), at(0, -0.49f)).normal, {0, -1});
}

TEST(Manifold, BoxOnBoxHasTwoPointsUnderItsCorners)
{
    const LocalManifold m = collide(box(10, 2), box(1, 1), at(2, 1.49f));
    ASSERT_EQ(m.count, 2);
    expect_vec(m.normal, {0, 1});
    const auto points = sorted_points(m);
    EXPECT_NEAR(points[0].separation, -0.01f, tolerance);
    EXPECT_NEAR(points[1].separation, -0.01f, tolerance);
    expect_vec(points[0].position, {1.5f, 0.995f});
    expect_vec(points[1].position, {2.5f, 0.995f});
}

TEST(Manifold, OverhangingBoxIsClipped)
{
    const auto points = sorted_points(collide(box(2, 2), box(1, 1), at(1, 1.49f)));
    expect_vec(points[0].position, {0.5f, 0.995f});
    expect_vec(points[1].position, {1, 0.995f});
}

TEST(Manifold, TiltedBoxHasDifferentSeparations)
{
    const float tilt = 0.01f;
    const LocalManifold m = collide(box(10, 2), box(1, 1), at(0, 1.5f, tilt));
    ASSERT_EQ(m.count, 2);
    const auto points = sorted_points(m);
    EXPECT_NEAR(points[1].separation - points[0].separation, std::sin(tilt), tolerance);
}

TEST(Manifold, BoxStandingOnItsCornerHasOnePoint)
{
    const LocalManifold m = collide(box(10, 2), box(1, 1), at(0, 1 + 0.7f, 0.25f * pi));
    ASSERT_EQ(m.count, 1);
    expect_vec(m.normal, {0, 1});
    EXPECT_NEAR(m.points[0].separation, 0.7f - std::sqrt(0.5f), tolerance);
}

/// Widths that are equal leave the upper box's corners exactly over the ends of the lower one's face.
TEST(Manifold, StackOfEqualBoxesHasTwoPoints)
{
    for (float gap : {-0.01f, -0.001f, 0.0f, 0.00001f, 0.0001f, 0.001f, 0.01f, 0.019f})
    {
        const LocalManifold m = collide(box(1, 1), box(1, 1), at(0, 1 + gap));
        ASSERT_EQ(m.count, 2) << gap;
        expect_vec(m.normal, {0, 1});
        EXPECT_NEAR(m.points[0].separation, gap, tolerance);
        EXPECT_NEAR(m.points[1].separation, gap, tolerance);
        EXPECT_EQ(collide(rounded_box(1, 1, 0.1f), rounded_box(1, 1, 0.1f), at(0, 1 + gap)).count, 2) << gap;
        EXPECT_EQ(collide(capsule({0, 0}, {1, 0}, 0.5f), capsule({0, 0}, {1, 0}, 0.5f), at(0, 1 + gap)).count, 2) << gap;
    }
}

TEST(Manifold, PrefersTheFaceOfA)
{
    // Tilted by less than the preference, B's face separates a little better in turn: the normal stays A's.
    for (float tilt : {-1e-4f, -1e-5f, 1e-5f, 1e-4f})
    {
        EXPECT_EQ(collide(box(10, 2), box(1, 1), at(3, 1.495f, tilt)).normal, (Vec2{0, 1}));
        EXPECT_EQ(collide(box(1, 1), box(10, 2), at(0, 1.495f, tilt)).normal, (Vec2{0, 1}));
    }
}

TEST(Manifold, BoxesAtTheSamePlace)
{
    const LocalManifold m = collide(box(2, 2), box(2, 2), {});
    ASSERT_EQ(m.count, 2);
    EXPECT_NEAR(length(m.normal), 1, tolerance);
    EXPECT_NEAR(m.points[0].separation, -2, tolerance);
    EXPECT_NEAR(m.points[1].separation, -2, tolerance);
}

TEST(Manifold, CapsuleLyingOnBoxHasTwoPoints)
{
    const LocalManifold m = collide(box(10, 2), capsule({-0.5f, 0}, {0.5f, 0}, 0.25f), at(0, 1.24f));
    ASSERT_EQ(m.count, 2);
    expect_vec(m.normal, {0, 1});
    const auto points = sorted_points(m);
    EXPECT_NEAR(points[0].separation, -0.01f, tolerance);
    expect_vec(points[0].position, {-0.5f, 0.995f});
    expect_vec(points[1].position, {0.5f, 0.995f});
}

TEST(Manifold, CapsuleStandingOnBoxHasOnePoint)
{
    const LocalManifold m = collide(box(10, 2), capsule({-0.5f, 0}, {0.5f, 0}, 0.25f), at(0, 1.74f, 0.5f * pi));
    ASSERT_EQ(m.count, 1);
    expect_vec(m.normal, {0, 1});
    EXPECT_NEAR(m.points[0].separation, -0.01f, tolerance);
}

TEST(Manifold, CapsulesInLine)
{
    const Capsule c = capsule({-1, 0}, {1, 0}, 0.5f);
    const LocalManifold apart = collide(c, c, at(3.01f, 0));
    ASSERT_EQ(apart.count, 1);
    expect_vec(apart.normal, {1, 0});
    EXPECT_NEAR(apart.points[0].separation, 0.01f, tolerance);

    const LocalManifold overlapping = collide(c, c, at(1, 0));
    ASSERT_EQ(overlapping.count, 2);
    EXPECT_NEAR(std::abs(overlapping.normal.y), 1, tolerance);
    EXPECT_NEAR(overlapping.points[0].separation, -1, tolerance);
    EXPECT_NEAR(length(collide(c, c, {}).normal), 1, tolerance);
}

TEST(Manifold, CrossingSegmentsArePushedApartTheShortWay)
{
    const LocalManifold m = collide(segment({-5, 0}, {5, 0}), segment({0, -0.1f}, {0, 3}), at(1, 0));
    ASSERT_EQ(m.count, 1);
    expect_vec(m.normal, {0, 1});
    EXPECT_NEAR(m.points[0].separation, -0.1f, tolerance);
}

TEST(Manifold, RoundedCornersRollSmoothly)
{
    const float radius = 0.25f;
    const float corner = std::sqrt(2.0f) * (0.5f - radius) + radius; // from a rounded box's centre to its rounded corner
    const LocalManifold on_corner = collide(box(10, 2), rounded_box(1, 1, radius), at(0, 1 + corner, 0.25f * pi));
    ASSERT_EQ(on_corner.count, 1);
    EXPECT_NEAR(on_corner.points[0].separation, 0, tolerance);

    const LocalManifold corners = collide(rounded_box(1, 1, radius), rounded_box(1, 1, radius), at(0.8f, 0.8f));
    ASSERT_EQ(corners.count, 1);
    expect_vec(corners.normal, {std::sqrt(0.5f), std::sqrt(0.5f)});
    EXPECT_NEAR(corners.points[0].separation, 0.3f * std::sqrt(2.0f) - 2 * radius, tolerance);

    // Around the corner the normal turns without a jump.
    Vec2 before = {0, 1};
    for (int i = 0; i <= 200; ++i)
    {
        const float turn = 0.5f * pi * static_cast<float>(i) / 200;
        const SinCos v = sin_cos(turn);
        const LocalManifold m = collide(rounded_box(1, 1, radius), circle(0.5f), at(0.25f + 0.75f * v.sin, 0.25f + 0.75f * v.cos));
        ASSERT_EQ(m.count, 1);
        EXPECT_LT(distance(m.normal, before), 0.01f);
        EXPECT_NEAR(m.points[0].separation, 0, tolerance);
        before = m.normal;
    }
}

TEST(Manifold, FarFromTheBodysOriginItKeepsItsDigits)
{
    // A short edge of a long terrain, 4 km from the terrain body's origin.
    const Segment edge = segment({4096, 0}, {4100, 0});
    const LocalManifold m = collide(edge, box(1, 1), at(4098.25f, 0.5f));
    ASSERT_EQ(m.count, 2);
    expect_vec(m.normal, {0, 1}, 0);
    EXPECT_EQ(m.points[0].separation, 0);
    const auto points = sorted_points(m);
    expect_vec(points[0].position, {4097.75f, 0}, 1e-3f);
}

TEST(Manifold, FeaturesAreSharedByNeighbouringWaysToTouch)
{
    const auto features = [](const LocalManifold& m)
    {
        std::array<std::uint32_t, 2> f = {m.points[0].feature, m.points[1].feature};
        std::sort(f.begin(), f.end());
        return f;
    };
    // Sliding over the ledge's end changes which corner is clipped, and not the names.
    const auto inside = features(collide(box(2, 2), box(1, 1), at(0.45f, 1.495f)));
    const auto overhanging = features(collide(box(2, 2), box(1, 1), at(0.55f, 1.495f)));
    EXPECT_EQ(inside, overhanging);
    // Neither does taking B's face for the reference instead of A's.
    const auto tilted_left = features(collide(box(2, 2), box(1, 1), at(0.45f, 1.49f, 0.02f)));
    const auto tilted_right = features(collide(box(2, 2), box(1, 1), at(0.45f, 1.49f, -0.02f)));
    EXPECT_EQ(tilted_left, tilted_right);
    EXPECT_EQ(tilted_left, inside);
}

} // namespace carom::detail
