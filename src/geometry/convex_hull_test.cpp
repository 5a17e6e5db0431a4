// Hulls of random, doubled, collinear and bad points.
#include "geometry/random_shapes.hpp"
#include "geometry/validate.hpp"

#include <carom/error.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace carom
{

TEST(ConvexHull, OrdersCornersCounterClockwise)
{
    const std::array<Vec2, 4> points = {{{1, 1}, {0, 0}, {1, 0}, {0, 1}}};
    const Polygon hull = convex_hull(points);
    ASSERT_EQ(hull.count, 4);
    EXPECT_EQ(hull.vertices[0], (Vec2{0, 0}));
    EXPECT_EQ(hull.vertices[1], (Vec2{1, 0}));
    EXPECT_EQ(hull.vertices[2], (Vec2{1, 1}));
    EXPECT_EQ(hull.vertices[3], (Vec2{0, 1}));
    EXPECT_EQ(hull.normals[0], (Vec2{0, -1}));
    EXPECT_EQ(hull.centroid, (Vec2{0.5f, 0.5f}));
}

TEST(ConvexHull, WeldsPointsWithinAMillimetre)
{
    const std::array<Vec2, 6> points = {{{0, 0}, {1, 0}, {1, 0.0005f}, {0, 1}, {0.0005f, 0}, {0, 0.9996f}}};
    EXPECT_EQ(convex_hull(points).count, 3);
}

TEST(ConvexHull, DropsPointsOnAnEdge)
{
    const std::array<Vec2, 8> points = {{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2.00005f}, {0, 2}, {0, 1}}};
    EXPECT_EQ(convex_hull(points).count, 4);
}

TEST(ConvexHull, RandomPointsGiveAValidHull)
{
    detail::RandomShapes random(31);
    int made = 0;
    for (int i = 0; i < 20000; ++i)
    {
        std::vector<Vec2> points(static_cast<std::size_t>(random.integer(3, 14)));
        const float size = i % 3 == 0 ? 0.01f : i % 3 == 1 ? 1.0f : 1000.0f;
        for (Vec2& p : points)
            p = i % 2 == 0 ? random.point(size) : Vec2{random.uniform(-size, size), random.uniform(-0.01f, 0.01f) * size};
        Polygon hull;
        try
        {
            hull = convex_hull(points);
        }
        catch (const UsageError& error)
        {
            ASSERT_TRUE(error.field() == "points" || error.field() == "corner count") << error.what();
            continue;
        }
        ++made;
        EXPECT_NO_THROW(detail::validate(hull, "test"));
        for (const Vec2 p : points)
        {
            for (std::size_t k = 0; k < static_cast<std::size_t>(hull.count); ++k)
            {
                // Welding moves the outline by up to 1 mm, dropping corners by some tenths.
                ASSERT_LT(dot(hull.normals[k], p - hull.vertices[k]), 2e-3f + 1e-6f * size);
            }
        }
    }
    EXPECT_GT(made, 10000);
}

TEST(ConvexHull, TheCentroidIsTheCentreOfMassRoundingIncluded)
{
    const std::array<Vec2, 3> corners = {{{0, 0}, {4, 0}, {0, 1}}};
    for (float radius : {0.0f, 0.5f})
    {
        const Polygon hull = convex_hull(corners, radius);
        EXPECT_EQ(hull.centroid, mass_of(hull, 1).center);
    }
}

TEST(ConvexHull, RefusesWhatHasNoArea)
{
    const std::array<Vec2, 4> line = {{{0, 0}, {1, 1}, {2, 2}, {3, 3}}};
    const std::array<Vec2, 3> point = {{{5, 5}, {5, 5}, {5, 5}}};
    const std::array<Vec2, 3> sliver = {{{0, 0}, {10, 0}, {5, 0.00005f}}};
    EXPECT_THROW(convex_hull(line), UsageError);
    EXPECT_THROW(convex_hull(point), UsageError);
    EXPECT_THROW(convex_hull(sliver), UsageError);
}

TEST(ConvexHull, RefusesTooFewTooManyAndTooManyCorners)
{
    std::vector<Vec2> circle_points;
    for (int i = 0; i < 65; ++i)
    {
        const SinCos v = sin_cos(static_cast<float>(i));
        circle_points.push_back({v.cos, v.sin});
    }
    const auto first = [&](std::size_t n) { return std::span<const Vec2>(circle_points.data(), n); };
    EXPECT_THROW(convex_hull(first(0)), UsageError);
    EXPECT_THROW(convex_hull(first(2)), UsageError);
    EXPECT_NO_THROW(convex_hull(first(3)));
    EXPECT_NO_THROW(convex_hull(first(8)));
    EXPECT_THROW(convex_hull(first(9)), UsageError);
    EXPECT_THROW(convex_hull(first(64)), UsageError);
    EXPECT_THROW(convex_hull(first(65)), UsageError);
}

TEST(ConvexHull, ManyInnerPointsAreFine)
{
    detail::RandomShapes random(32);
    std::vector<Vec2> points = {{-10, -10}, {10, -10}, {10, 10}, {-10, 10}};
    while (points.size() < 64) points.push_back(random.point(9));
    EXPECT_EQ(convex_hull(points).count, 4);
}

TEST(ConvexHull, RefusesBadNumbersAndNamesThem)
{
    for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 3e38f, -2e6f})
    {
        const std::array<Vec2, 3> points = {{{0, 0}, {1, 0}, {0, bad}}};
        try
        {
            convex_hull(points);
            ADD_FAILURE() << bad;
        }
        catch (const UsageError& error)
        {
            EXPECT_EQ(error.field(), "points[2].y");
        }
        const std::array<Vec2, 3> good = {{{0, 0}, {1, 0}, {0, 1}}};
        EXPECT_THROW(convex_hull(good, bad), UsageError);
    }
}

} // namespace carom
