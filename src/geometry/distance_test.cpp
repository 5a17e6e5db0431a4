// GJK against the distance found by trying every corner against every edge.
#include "geometry/distance.hpp"
#include "geometry/random_shapes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace carom::detail
{

namespace
{

float distance_to_segment(Vec2 p, Vec2 a, Vec2 b)
{
    const Vec2 e = b - a;
    const float t = length_squared(e) > 0 ? std::clamp(dot(p - a, e) / length_squared(e), 0.0f, 1.0f) : 0.0f;
    return carom::distance(p, a + t * e);
}

/// True when the point is inside the hull of three or more corners in order.
bool is_inside(const ConvexPoints& shape, Vec2 p)
{
    if (shape.count < 3) return false;
    for (int i = 0; i < shape.count; ++i)
    {
        const Vec2 a = shape.points[static_cast<std::size_t>(i)];
        const Vec2 b = shape.points[static_cast<std::size_t>((i + 1) % shape.count)];
        if (cross(b - a, p - a) < 0) return false;
    }
    return true;
}

bool edges_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d)
{
    return cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

/// Of the hulls without their radii; 0 when they overlap.
float brute_force_distance(const ConvexPoints& a, const ConvexPoints& b)
{
    float least = std::numeric_limits<float>::max();
    for (int i = 0; i < a.count; ++i)
    {
        const Vec2 a1 = a.points[static_cast<std::size_t>(i)];
        const Vec2 a2 = a.points[static_cast<std::size_t>((i + 1) % a.count)];
        if (is_inside(b, a1)) return 0;
        for (int j = 0; j < b.count; ++j)
        {
            const Vec2 b1 = b.points[static_cast<std::size_t>(j)];
            const Vec2 b2 = b.points[static_cast<std::size_t>((j + 1) % b.count)];
            if (is_inside(a, b1) || edges_cross(a1, a2, b1, b2)) return 0;
            least = std::min({least, distance_to_segment(a1, b1, b2), distance_to_segment(b1, a1, a2)});
        }
    }
    return least;
}

ConvexPoints moved(const ConvexPoints& shape, const Transform& transform)
{
    ConvexPoints result = shape;
    for (Vec2& p : result.points) p = transform * p;
    return result;
}

} // namespace

TEST(Distance, BoxesSideBySide)
{
    const DistanceResult result = distance(convex_points(box(2, 2)), convex_points(box(2, 2)), {{5, 0.5f}, {}});
    EXPECT_NEAR(result.distance, 3, 1e-6f);
    EXPECT_EQ(result.normal, (Vec2{1, 0}));
    EXPECT_NEAR(result.point_a.x, 1, 1e-6f);
    EXPECT_NEAR(result.point_b.x, 4, 1e-6f);
    EXPECT_NEAR(result.point_a.y, result.point_b.y, 1e-6f);
}

TEST(Distance, CornerToCorner)
{
    const DistanceResult result = distance(convex_points(box(2, 2)), convex_points(box(2, 2)), {{5, 6}, {}});
    EXPECT_NEAR(result.distance, 5, 1e-6f);
    EXPECT_NEAR(result.normal.x, 0.6f, 1e-6f);
    EXPECT_NEAR(result.normal.y, 0.8f, 1e-6f);
    EXPECT_EQ(result.point_a, (Vec2{1, 1}));
    EXPECT_EQ(result.point_b, (Vec2{4, 5}));
}

TEST(Distance, RadiiShortenIt)
{
    const DistanceResult result = distance(convex_points(circle(1)), convex_points(capsule({0, -1}, {0, 1}, 0.5f)), {{4, 0}, {}});
    EXPECT_NEAR(result.distance, 2.5f, 1e-6f);
    EXPECT_NEAR(result.point_a.x, 1, 1e-6f);
    EXPECT_NEAR(result.point_b.x, 3.5f, 1e-6f);
}

TEST(Distance, OverlapOfCores)
{
    const DistanceResult result = distance(convex_points(box(2, 2)), convex_points(box(2, 2)), {{0.5f, 0.5f}, {}});
    EXPECT_EQ(result.distance, 0);
    EXPECT_EQ(result.normal, (Vec2{0, 0}));
    EXPECT_NEAR(carom::distance(result.point_a, result.point_b), 0, 1e-6f);
    EXPECT_EQ(distance(convex_points(circle(1)), convex_points(circle(1)), {}).distance, 0);
    EXPECT_EQ(distance(convex_points(box(2, 2)), convex_points(box(2, 2)), {}).distance, 0);
}

TEST(Distance, MatchesBruteForce)
{
    RandomShapes random(51);
    for (int i = 0; i < 40000; ++i)
    {
        const float size = i % 5 == 0 ? 0.01f : i % 5 == 1 ? 500.0f : 1.0f;
        const float size_b = i % 7 == 0 ? 100 * size : size;
        const ConvexPoints a = convex_points(random.geometry_of(random.integer(0, 3), size));
        const ConvexPoints b = convex_points(random.geometry_of(random.integer(0, 3), size_b));
        const Transform b_in_a = random.transform((i % 2 == 0 ? 2 : 20) * size_b);
        const float reach = 22 * size_b;

        const DistanceResult result = distance(a, b, b_in_a);
        const float cores = brute_force_distance(a, moved(b, b_in_a));
        ASSERT_NEAR(result.distance, std::max(0.0f, cores - a.radius - b.radius), 2e-6f * reach) << i;
        ASSERT_LT(result.iterations, 20) << i;
        if (cores > 1e-3f * reach)
        {
            ASSERT_NEAR(length(result.normal), 1, 1e-5f);
            const Vec2 across = result.point_b - result.point_a;
            ASSERT_NEAR(dot(across, result.normal), cores - a.radius - b.radius, 1e-5f * reach) << i;
            ASSERT_NEAR(cross(across, result.normal), 0, 1e-4f * reach) << i;
        }
    }
}

TEST(Distance, IsTheSameFromTheOtherSide)
{
    RandomShapes random(52);
    for (int i = 0; i < 5000; ++i)
    {
        const ConvexPoints a = convex_points(random.geometry_of(random.integer(0, 3), 1));
        const ConvexPoints b = convex_points(random.geometry_of(random.integer(0, 3), 1));
        const Transform b_in_a = random.transform(4);
        const Transform a_in_b = relative(b_in_a, Transform{});
        const DistanceResult ab = distance(a, b, b_in_a);
        const DistanceResult ba = distance(b, a, a_in_b);
        ASSERT_NEAR(ab.distance, ba.distance, 1e-5f);
    }
}

TEST(Distance, DoubledAndCollinearPointsEnd)
{
    ConvexPoints many;
    many.count = 8;
    many.points.fill({1, 1});
    ConvexPoints line;
    line.count = 8;
    for (std::size_t i = 0; i < 8; ++i) line.points[i] = {static_cast<float>(i % 3), 0};
    EXPECT_NEAR(distance(many, line, {}).distance, 1, 1e-6f);
    EXPECT_NEAR(distance(line, many, {}).distance, 1, 1e-6f);
    EXPECT_NEAR(distance(line, line, {{0, 2}, {}}).distance, 2, 1e-6f);
    EXPECT_NEAR(distance(line, line, {{5, 0}, {}}).distance, 3, 1e-6f);
    EXPECT_EQ(distance(line, line, {{1, 0}, {}}).distance, 0);
    EXPECT_EQ(distance(many, many, {}).distance, 0);
}

/// Far from the origin of A's body the answer is as good as near it, up to the rounding of the coordinates.
TEST(Distance, HugeCoordinates)
{
    RandomShapes random(53);
    for (int i = 0; i < 20000; ++i)
    {
        const ConvexPoints a = convex_points(random.geometry_of(random.integer(0, 3), i % 2 == 0 ? 1 : 9e4f));
        const ConvexPoints b = convex_points(random.geometry_of(random.integer(0, 3), 1));
        const Transform b_in_a = random.transform(1e6f);
        const DistanceResult result = distance(a, b, b_in_a);
        ASSERT_TRUE(std::isfinite(result.distance) && is_finite(result.point_a) && is_finite(result.point_b) && is_finite(result.normal));
        const float expected = std::max(0.0f, brute_force_distance(a, moved(b, b_in_a)) - a.radius - b.radius);
        ASSERT_NEAR(result.distance, expected, 1) << i; // a float has steps of 0.06 m there, and a product of two such has larger ones
    }
}

TEST(Distance, OverlapCountsTouching)
{
    EXPECT_TRUE(overlap(box(2, 2), box(2, 2), {{2, 0}, {}}));
    EXPECT_TRUE(overlap(box(2, 2), box(2, 2), {{2, 2}, {}}));
    EXPECT_FALSE(overlap(box(2, 2), box(2, 2), {{2.001f, 0}, {}}));
    EXPECT_TRUE(overlap(circle(1), circle(1), {{2, 0}, {}}));
    EXPECT_FALSE(overlap(circle(1), circle(1), {{1.5f, 1.5f}, {}}));
    EXPECT_TRUE(overlap(segment({-1, 0}, {1, 0}), segment({0, -1}, {0, 1}), {}));
    EXPECT_TRUE(overlap(box(10, 10), circle(0.1f), {{1, 1}, {}})) << "one inside the other";
}

} // namespace carom::detail
