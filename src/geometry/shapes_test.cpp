// What the makers make, bounds, and containment.
#include "geometry/random_shapes.hpp"

#include <carom/error.hpp>
#include <carom/shape.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace carom
{

namespace
{

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// Within the shape's own bounds, so that many are inside.
Vec2 point_near(detail::RandomShapes& random, const Geometry& geometry)
{
    const Aabb bounds = aabb_of(geometry, {});
    const float x = random.uniform(bounds.min.x, bounds.max.x); // a line each: the order of arguments is the compiler's
    return {x, random.uniform(bounds.min.y, bounds.max.y)};
}

template <class Call>
std::string message_of(Call call)
{
    try
    {
        call();
    }
    catch (const UsageError& error)
    {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST(Shapes, BoxIsCenteredAndCounterClockwise)
{
    const Polygon b = box(4, 2);
    ASSERT_EQ(b.count, 4);
    EXPECT_EQ(b.vertices[0], (Vec2{-2, -1}));
    EXPECT_EQ(b.vertices[1], (Vec2{2, -1}));
    EXPECT_EQ(b.vertices[2], (Vec2{2, 1}));
    EXPECT_EQ(b.vertices[3], (Vec2{-2, 1}));
    EXPECT_EQ(b.normals[0], (Vec2{0, -1}));
    EXPECT_EQ(b.normals[1], (Vec2{1, 0}));
    EXPECT_EQ(b.centroid, (Vec2{0, 0}));
    EXPECT_EQ(b.radius, 0);
}

TEST(Shapes, RoundedBoxKeepsItsOuterSize)
{
    const Aabb bounds = aabb_of(rounded_box(4, 2, 0.25f), {});
    EXPECT_EQ(bounds, (Aabb{{-2, -1}, {2, 1}}));
    EXPECT_NO_THROW(rounded_box(1, 1, 0.4995f));
    EXPECT_NO_THROW(rounded_box(0.001f, 0.001f, 0));
    EXPECT_THROW(rounded_box(1, 1, 0.4998f), UsageError);
    EXPECT_THROW(rounded_box(1, 1, -0.1f), UsageError);
}

TEST(Shapes, OffsetBoxIsMovedAndTurned)
{
    const Polygon b = offset_box(4, 2, {10, 20}, 0.5f * pi);
    const Aabb bounds = aabb_of(b, {});
    EXPECT_NEAR(bounds.min.x, 9, 1e-5f);
    EXPECT_NEAR(bounds.min.y, 18, 1e-5f);
    EXPECT_NEAR(bounds.max.x, 11, 1e-5f);
    EXPECT_NEAR(bounds.max.y, 22, 1e-5f);
    EXPECT_NEAR(b.centroid.x, 10, 1e-5f);
    EXPECT_NEAR(b.centroid.y, 20, 1e-5f);
}

TEST(Shapes, ErrorsNameTheArgument)
{
    EXPECT_EQ(message_of([] { circle(-0.5f); }), "circle: radius is -0.5; give a value greater than 0 and not above 1e+06");
    EXPECT_EQ(message_of([] { circle(1, {0, not_a_number}); }), "circle: center.y is nan; give a finite center");
    EXPECT_EQ(message_of([] { circle(2e6f); }), "circle: radius is 2e+06; give a value greater than 0 and not above 1e+06");
    EXPECT_EQ(message_of([] { circle(not_a_number); }), "circle: radius is nan; give a finite radius");
    EXPECT_EQ(message_of([] { convex_hull(std::array{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}, 2e6f); }),
              "convex_hull: radius is 2e+06; give a value from 0 to 1e+06");
    EXPECT_EQ(message_of([] { capsule({1, 1}, {1, 1}, 1); }), "capsule: p2 is (1, 1); give ends that are at least 1 mm apart");
    EXPECT_EQ(message_of([] { segment({0, 0}, {infinity, 0}); }), "segment: p2.x is inf; give a finite p2");
    EXPECT_EQ(message_of([] { box(0, 1); }), "box: width is 0; give a value from 0.001 to 1e+06");
    EXPECT_EQ(message_of([] { offset_box(1, 1, {}, infinity); }), "offset_box: angle is inf; give a finite angle");
}

TEST(Shapes, MakersRefuseEveryBadNumber)
{
    for (float bad : {not_a_number, infinity, -infinity, -1.0f, 0.0f, 1e-45f, 3e38f, 1.1e6f})
    {
        EXPECT_THROW(circle(bad), UsageError) << bad;
        EXPECT_THROW(capsule({0, 0}, {1, 0}, bad), UsageError) << bad;
        EXPECT_THROW(box(bad, 1), UsageError) << bad;
        EXPECT_THROW(box(1, bad), UsageError) << bad;
        EXPECT_THROW(rounded_box(bad, 1, 0.1f), UsageError) << bad;
        EXPECT_THROW(offset_box(1, bad, {}), UsageError) << bad;
    }
    for (float bad : {not_a_number, infinity, -infinity, 3e38f, -1.1e6f})
    {
        EXPECT_THROW(circle(1, {bad, 0}), UsageError) << bad;
        EXPECT_THROW(capsule({0, bad}, {1, 0}, 1), UsageError) << bad;
        EXPECT_THROW(segment({0, 0}, {bad, 0}), UsageError) << bad;
        EXPECT_THROW(rounded_box(1, 1, bad), UsageError) << bad;
        EXPECT_THROW(offset_box(1, 1, {bad, 0}), UsageError) << bad;
        EXPECT_THROW(transformed(circle(1), {{bad, 0}, {}}), UsageError) << bad;
        EXPECT_THROW(transformed(circle(1), {{}, {bad, 0}}), UsageError) << bad;
    }
    EXPECT_THROW(segment({0, 0}, {0.0005f, 0}), UsageError);
    EXPECT_NO_THROW(segment({0, 0}, {0.001f, 0}));
    EXPECT_THROW(circle(1e-12f), UsageError) << "its inertia is zero in float";
    EXPECT_NO_THROW(circle(1e-6f));
}

/// A small box so far out that float can't tell its corners apart is refused, not made degenerate.
TEST(Shapes, RefusesWhatRoundingWouldCrush)
{
    EXPECT_NO_THROW(offset_box(1, 1, {9e5f, 9e5f}));
    EXPECT_THROW(offset_box(0.01f, 0.01f, {9e5f, 9e5f}, 0.3f), UsageError);
    EXPECT_THROW(transformed(box(0.01f, 0.01f), {{9e5f, 9e5f}, rotation(0.3f)}), UsageError);
}

TEST(Shapes, BoundsHoldTheShape)
{
    detail::RandomShapes random(21);
    int inside = 0;
    for (int i = 0; i < 400; ++i)
    {
        const Geometry geometry = random.geometry_of(i % 4, 1);
        const Transform transform = random.transform(3);
        const Aabb bounds = expanded(aabb_of(geometry, transform), 1e-5f);
        for (int k = 0; k < 100; ++k)
        {
            const Vec2 point = point_near(random, geometry);
            if (!contains(geometry, point)) continue;
            ++inside;
            ASSERT_TRUE(contains(bounds, transform * point));
        }
    }
    EXPECT_GT(inside, 10000);
}

TEST(Shapes, BoundsAreTight)
{
    const Transform quarter_turn = {{5, 5}, rotation(0.5f * pi)};
    const Aabb capsule_bounds = aabb_of(capsule({0, 0}, {2, 0}, 0.5f), quarter_turn);
    EXPECT_NEAR(capsule_bounds.min.x, 4.5f, 1e-6f);
    EXPECT_NEAR(capsule_bounds.max.y, 7.5f, 1e-6f);
    EXPECT_EQ(aabb_of(circle(2, {1, 0}), {{1, 1}, {}}), (Aabb{{0, -1}, {4, 3}}));
    EXPECT_EQ(aabb_of(segment({1, 0}, {-1, 2}), {}), (Aabb{{-1, 0}, {1, 2}}));
}

TEST(Shapes, ContainsItsEdge)
{
    EXPECT_TRUE(contains(circle(1), {1, 0}));
    EXPECT_FALSE(contains(circle(1), {1.0001f, 0}));
    EXPECT_TRUE(contains(box(2, 2), {1, 1}));
    EXPECT_FALSE(contains(box(2, 2), {1.0001f, 0}));
    EXPECT_TRUE(contains(capsule({0, 0}, {1, 0}, 0.5f), {1.5f, 0}));
    EXPECT_TRUE(contains(capsule({0, 0}, {1, 0}, 0.5f), {0.5f, -0.5f}));
    EXPECT_FALSE(contains(capsule({0, 0}, {1, 0}, 0.5f), {1.4f, 0.4f}));
    EXPECT_TRUE(contains(segment({0, 0}, {1, 1}), {0.5f, 0.5f}));
    EXPECT_FALSE(contains(segment({0, 0}, {1, 1}), {0.5f, 0.501f}));
    EXPECT_TRUE(contains(rounded_box(2, 2, 0.5f), {1, 0}));
    EXPECT_TRUE(contains(rounded_box(2, 2, 0.5f), {0.85f, 0.85f}));
    EXPECT_FALSE(contains(rounded_box(2, 2, 0.5f), {0.86f, 0.86f})) << "the corner is round";
}

TEST(Shapes, TransformedContainsTransformedPoints)
{
    detail::RandomShapes random(22);
    int inside = 0;
    for (int i = 0; i < 400; ++i)
    {
        const Geometry geometry = random.geometry_of(i % 4, 1);
        const Transform transform = random.transform(3);
        const Geometry there = transformed(geometry, transform);
        for (int k = 0; k < 50; ++k)
        {
            const Vec2 point = point_near(random, geometry);
            const bool is_surely_inside = contains(geometry, point) && contains(geometry, point + Vec2{1e-4f, 1e-4f}) &&
                                          contains(geometry, point - Vec2{1e-4f, 1e-4f}) && i % 4 != 2;
            if (!is_surely_inside) continue;
            ++inside;
            ASSERT_TRUE(contains(there, transform * point));
        }
    }
    EXPECT_GT(inside, 5000);
}

TEST(Shapes, CallsOnAHandFilledPolygonCheckItsCount)
{
    Polygon polygon = box(1, 1);
    for (int count : {-1, 0, 2, 9, 1000000})
    {
        polygon.count = count;
        EXPECT_THROW(aabb_of(polygon, {}), UsageError);
        EXPECT_THROW(contains(polygon, {}), UsageError);
        EXPECT_THROW(mass_of(polygon, 1), UsageError);
        EXPECT_THROW(transformed(polygon, {}), UsageError);
    }
}

} // namespace carom
