// Casts against the distance of the shapes along the way.
#include "geometry/cast.hpp"
#include "geometry/random_shapes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace carom::detail
{

namespace
{

Transform moved(const Transform& transform, Vec2 by) { return {transform.p + by, transform.q}; }

void expect_hit(const std::optional<CastResult>& hit, float fraction, Vec2 normal, Vec2 point)
{
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->fraction, fraction, 1e-6f);
    EXPECT_NEAR(hit->normal.x, normal.x, 1e-6f);
    EXPECT_NEAR(hit->normal.y, normal.y, 1e-6f);
    EXPECT_NEAR(hit->point.x, point.x, 1e-5f);
    EXPECT_NEAR(hit->point.y, point.y, 1e-5f);
    EXPECT_FALSE(hit->starts_inside);
}

} // namespace

TEST(CastRay, MeetsEachKindOfShape)
{
    expect_hit(cast_ray(Geometry(circle(1)), {-5, 0}, {10, 0}), 0.4f, {-1, 0}, {-1, 0});
    expect_hit(cast_ray(Geometry(capsule({0, -2}, {0, 2}, 0.5f)), {5, 1}, {-10, 0}), 0.45f, {1, 0}, {0.5f, 1});
    expect_hit(cast_ray(Geometry(capsule({0, -2}, {0, 2}, 0.5f)), {0, 5}, {0, -5}), 0.5f, {0, 1}, {0, 2.5f});
    expect_hit(cast_ray(Geometry(segment({-1, 0}, {1, 0})), {0.5f, 3}, {0, -6}), 0.5f, {0, 1}, {0.5f, 0});
    expect_hit(cast_ray(Geometry(segment({-1, 0}, {1, 0})), {0.5f, -3}, {0, 6}), 0.5f, {0, -1}, {0.5f, 0});
    expect_hit(cast_ray(Geometry(box(2, 2)), {-3, 0.5f}, {4, 0}), 0.5f, {-1, 0}, {-1, 0.5f});
    expect_hit(cast_ray(Geometry(rounded_box(2, 2, 0.5f)), {-3, 3}, {4, -4}), (2 + 0.5f - 0.5f * std::sqrt(0.5f)) / 4,
               {-std::sqrt(0.5f), std::sqrt(0.5f)}, {-0.5f - 0.5f * std::sqrt(0.5f), 0.5f + 0.5f * std::sqrt(0.5f)});
}

TEST(CastRay, EndsBeforeOrPassesBy)
{
    EXPECT_FALSE(cast_ray(Geometry(box(2, 2)), {-3, 0}, {1.99f, 0}));
    EXPECT_TRUE(cast_ray(Geometry(box(2, 2)), {-3, 0}, {2, 0})) << "the end of the ray counts";
    EXPECT_FALSE(cast_ray(Geometry(box(2, 2)), {-3, 1.001f}, {6, 0}));
    EXPECT_FALSE(cast_ray(Geometry(circle(1)), {-3, 1.001f}, {6, 0}));
    EXPECT_FALSE(cast_ray(Geometry(box(2, 2)), {-3, 0}, {-6, 0})) << "away";
    EXPECT_FALSE(cast_ray(Geometry(box(2, 2)), {-3, 0}, {0, 0}));
}

TEST(CastRay, StartsInside)
{
    for (const Geometry& shape :
         {Geometry(circle(1)), Geometry(capsule({-1, 0}, {1, 0}, 0.5f)), Geometry(box(2, 2)), Geometry(rounded_box(2, 2, 0.9f))})
    {
        for (const Vec2 sweep : {Vec2{5, 0}, Vec2{0, 0}})
        {
            const auto hit = cast_ray(shape, {0.2f, 0.1f}, sweep);
            ASSERT_TRUE(hit);
            EXPECT_TRUE(hit->starts_inside);
            EXPECT_EQ(hit->fraction, 0);
            EXPECT_EQ(hit->normal, Vec2{});
            EXPECT_EQ(hit->point, (Vec2{0.2f, 0.1f}));
        }
    }
}

TEST(CastRay, StartsOnTheSurface)
{
    for (const Geometry& shape :
         {Geometry(box(2, 2)), Geometry(circle(1)), Geometry(rounded_box(2, 2, 0.5f)), Geometry(capsule({0, 0}, {-3, 0}, 1))})
    {
        expect_hit(cast_ray(shape, {1, 0}, {-1, 0.5f}), 0, {1, 0}, {1, 0});
        EXPECT_FALSE(cast_ray(shape, {1, 0}, {1, 0.5f})) << "away";
        EXPECT_FALSE(cast_ray(shape, {1, 0}, {0, 1})) << "along";
    }
    EXPECT_FALSE(cast_ray(Geometry(box(2, 2)), {1, 1}, {-1, 1})) << "away from one of two faces at a corner";
    EXPECT_TRUE(cast_ray(Geometry(box(2, 2)), {1, 1}, {-1, -2}));
    EXPECT_FALSE(cast_ray(Geometry(segment({-1, 0}, {1, 0})), {0, 0}, {0, 1})) << "a segment has no inside";
}

TEST(CastRay, RayAlongASegmentMeetsItsEnd)
{
    expect_hit(cast_ray(Geometry(segment({-1, 0}, {1, 0})), {-3, 0}, {4, 0}), 0.5f, {-1, 0}, {-1, 0});
    EXPECT_FALSE(cast_ray(Geometry(segment({-1, 0}, {1, 0})), {-3, 0}, {1, 0}));
}

TEST(CastRay, NoRaySlipsThroughACorner)
{
    RandomShapes random(31);
    for (int i = 0; i < 20000; ++i)
    {
        const Polygon shape = random.polygon_of(1);
        const Vec2 corner = shape.vertices[static_cast<std::size_t>(random.integer(0, shape.count - 1))];
        const Vec2 out = corner - shape.centroid;
        const Vec2 start = corner + 3 * out;
        ASSERT_TRUE(cast_ray(Geometry(shape), start, shape.centroid - start)) << i;
    }
}

TEST(CastRay, LongRaysAreExact)
{
    const auto hit = cast_ray(Geometry(circle(0.5f)), {-1e6f, 0.25f}, {2e6f, 0});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->point.x, -std::sqrt(0.25f - 0.0625f), 1e-6f);
    EXPECT_NEAR(hit->normal.y, 0.5f, 1e-5f);
}

/// The nearer of two far points, seen along the ray: just before the hit there is a gap, at the hit there is none.
TEST(CastRay, RandomRaysMeetTheSurface)
{
    RandomShapes random(32);
    int hits = 0;
    for (int i = 0; i < 40000; ++i)
    {
        const Geometry shape = random.geometry_of(random.integer(0, 3), 1);
        const Vec2 start = random.point(4);
        const Vec2 sweep = random.uniform(0, 2) * (random.point(1.5f) - start);
        ConvexPoints point;
        point.count = 1;
        const ConvexPoints points = convex_points(shape);
        const auto distance_at = [&](float fraction) { return distance(points, point, {start + fraction * sweep, {}}).distance; };

        const auto hit = cast_ray(shape, start, sweep);
        const float end = hit ? hit->fraction : 1;
        if (hit && hit->starts_inside)
        {
            ASSERT_EQ(distance_at(0), 0) << i;
            continue;
        }
        for (int k = 0; k < 40; ++k) ASSERT_GT(distance_at(end * static_cast<float>(k) / 40), 0) << i;
        if (!hit) continue;
        ++hits;
        ASSERT_NEAR(distance_at(end), 0, 1e-5f) << i;
        ASSERT_LE(dot(hit->normal, sweep), 0) << i;
        ASSERT_NEAR(length(hit->normal), 1, 1e-5f);
        ASSERT_NEAR(distance(hit->point, start + end * sweep), 0, 1e-5f);
    }
    EXPECT_GT(hits, 8000);
}

TEST(CastShape, BoxOntoBox)
{
    const auto hit = cast_shape(convex_points(box(2, 2)), convex_points(box(1, 1)), {{-5, 0.5f}, {}}, {10, 0});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->fraction, 0.35f, 1e-6f);
    EXPECT_EQ(hit->normal, (Vec2{-1, 0}));
    EXPECT_NEAR(hit->point.x, -1, 1e-6f);
    EXPECT_TRUE(hit->point.y >= 0 && hit->point.y <= 1) << hit->point.y;
}

TEST(CastShape, SlidesAlongWhatItLiesOn)
{
    const ConvexPoints floor = convex_points(box(20, 2));
    for (const Geometry& shape :
         {Geometry(box(1, 1)), Geometry(circle(0.5f)), Geometry(rounded_box(1, 1, 0.25f)), Geometry(capsule({-1, 0}, {1, 0}, 0.5f))})
    {
        const ConvexPoints points = convex_points(shape);
        EXPECT_FALSE(cast_shape(floor, points, {{-5, 1.5f}, {}}, {10, 0}));
        EXPECT_FALSE(cast_shape(floor, points, {{-5, 1.5f}, {}}, {1, 1}));
        const auto down = cast_shape(floor, points, {{-5, 1.5f}, {}}, {1, -1});
        ASSERT_TRUE(down);
        EXPECT_EQ(down->fraction, 0);
        EXPECT_NEAR(down->normal.y, 1, 1e-6f);
        EXPECT_FALSE(down->starts_inside);
    }
}

TEST(CastShape, StartsInside)
{
    const auto hit = cast_shape(convex_points(box(2, 2)), convex_points(circle(0.5f)), {{1.2f, 0}, {}}, {1, 0});
    ASSERT_TRUE(hit);
    EXPECT_TRUE(hit->starts_inside);
    EXPECT_EQ(hit->fraction, 0);
    EXPECT_EQ(hit->normal, Vec2{});
}

TEST(CastShape, RandomCastsStopAtTouch)
{
    RandomShapes random(33);
    int hits = 0;
    for (int i = 0; i < 40000; ++i)
    {
        const float size_b = i % 4 == 0 ? 0.05f : 1;
        const ConvexPoints a = convex_points(random.geometry_of(random.integer(0, 3), 1));
        const ConvexPoints b = convex_points(random.geometry_of(random.integer(0, 3), size_b));
        const Transform start = random.transform(5);
        const Vec2 sweep = random.uniform(0, 2) * (random.point(1.5f) - start.p);
        const auto distance_at = [&](float fraction) { return distance(a, b, moved(start, fraction * sweep)); };

        const auto hit = cast_shape(a, b, start, sweep);
        if (hit && hit->starts_inside)
        {
            ASSERT_LT(distance_at(0).distance, 1e-5f) << i;
            continue;
        }
        const float end = hit ? hit->fraction : 1;
        for (int k = 0; k < 40; ++k) ASSERT_GT(distance_at(end * static_cast<float>(k) / 40).distance, 0) << i;
        if (!hit) continue;
        ++hits;
        ASSERT_NEAR(distance_at(end).distance, 0, 2e-5f) << i;
        ASSERT_LE(dot(hit->normal, sweep), 0) << i;
        // Where they meet lies on both.
        ConvexPoints point;
        point.count = 1;
        ASSERT_NEAR(distance(a, point, {hit->point, {}}).distance, 0, 2e-5f) << i;
        ASSERT_NEAR(distance(b, point, {inverse_transform(moved(start, end * sweep), hit->point), {}}).distance, 0, 2e-5f) << i;
        // Drawn back along the normal by a little, they are that little apart: it is the normal of the meeting.
        const float gap = distance(a, b, moved(start, end * sweep + 1e-3f * hit->normal)).distance;
        ASSERT_NEAR(gap, 1e-3f, 2e-5f) << i;
    }
    EXPECT_GT(hits, 8000);
}

TEST(CastShape, SegmentsAndPointsAndHugeShapes)
{
    const ConvexPoints a = convex_points(segment({-1, 0}, {1, 0}));
    EXPECT_TRUE(cast_shape(a, a, {{0, 3}, {}}, {0, -5}));
    EXPECT_FALSE(cast_shape(a, a, {{0, 3}, {}}, {5, 0}));
    const auto end_on = cast_shape(a, a, {{-4, 0}, {}}, {5, 0});
    ASSERT_TRUE(end_on) << "both on one line";
    EXPECT_NEAR(end_on->fraction, 0.4f, 1e-6f);
    const auto huge = cast_shape(convex_points(box(1e6f, 1e6f)), convex_points(circle(1)), {{0, 9e5f}, {}}, {0, -9e5f});
    ASSERT_TRUE(huge);
    EXPECT_NEAR(huge->fraction * 9e5f, 4e5f - 1, 0.1f);
}

} // namespace carom::detail
