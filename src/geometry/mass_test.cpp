// Mass, centre and inertia against closed forms, and against counting the cells of a grid.
#include "geometry/mass.hpp"
#include "geometry/random_shapes.hpp"

#include <carom/error.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace carom
{

namespace
{

/// Sums over the cells of a grid whose centres the shape contains. The boundary is missed by half a cell to either side, which for
/// 1000 x 1000 cells leaves errors of about 1e-3.
MassData counted_on_a_grid(const Geometry& geometry)
{
    constexpr int cells = 1000;
    const Aabb bounds = aabb_of(geometry, {});
    const Vec2 cell = (bounds.max - bounds.min) / static_cast<float>(cells);
    double count = 0, x = 0, y = 0, second = 0;
    for (int i = 0; i < cells; ++i)
    {
        for (int j = 0; j < cells; ++j)
        {
            const Vec2 p = bounds.min + Vec2{cell.x * (static_cast<float>(i) + 0.5f), cell.y * (static_cast<float>(j) + 0.5f)};
            if (!contains(geometry, p)) continue;
            count += 1;
            x += p.x;
            y += p.y;
            second += double{p.x} * p.x + double{p.y} * p.y;
        }
    }
    const double area = double{cell.x} * cell.y;
    x /= count;
    y /= count;
    return {static_cast<float>(count * area),
            {static_cast<float>(x), static_cast<float>(y)},
            static_cast<float>((second - count * (x * x + y * y)) * area)};
}

void expect_near(const MassData& a, const MassData& b, float relative)
{
    const float size = std::sqrt(b.mass);
    EXPECT_NEAR(a.mass, b.mass, relative * b.mass);
    EXPECT_NEAR(a.center.x, b.center.x, relative * size);
    EXPECT_NEAR(a.center.y, b.center.y, relative * size);
    EXPECT_NEAR(a.inertia, b.inertia, relative * b.inertia);
}

} // namespace

TEST(Mass, Circle)
{
    const MassData data = mass_of(circle(2, {3, -1}), 5);
    expect_near(data, {5 * pi * 4, {3, -1}, 5 * pi * 4 * 4 / 2}, 1e-6f);
}

TEST(Mass, Box)
{
    const MassData data = mass_of(offset_box(3, 2, {10, 20}, 0.7f), 4);
    expect_near(data, {24, {10, 20}, 24 * (9 + 4) / 12.0f}, 1e-5f);
}

TEST(Mass, Triangle)
{
    // Right-angled with legs b and h: inertia about the centroid is m (b^2 + h^2) / 18.
    const std::array<Vec2, 3> corners = {{{0, 0}, {3, 0}, {0, 6}}};
    expect_near(mass_of(convex_hull(corners), 2), {18, {1, 2}, 18 * (9 + 36) / 18.0f}, 1e-6f);
}

TEST(Mass, SegmentHasNone)
{
    const MassData data = mass_of(segment({-1, 0}, {3, 0}), 1);
    EXPECT_EQ(data.mass, 0);
    EXPECT_EQ(data.inertia, 0);
    EXPECT_EQ(data.center, (Vec2{1, 0}));
}

TEST(Mass, CapsuleIsTheLimitOfACircle)
{
    const MassData data = mass_of(capsule({-0.0005f, 0}, {0.0005f, 0}, 1), 1);
    EXPECT_NEAR(data.mass, pi, 3e-3f);
    EXPECT_NEAR(data.inertia, pi / 2, 5e-3f);
}

/// A box of size zero with a radius would be a disc; the smallest allowed core comes within a millimetre of it.
TEST(Mass, RoundedBoxIsTheLimitOfACircle)
{
    const MassData data = mass_of(rounded_box(2.001f, 2.001f, 1), 1);
    EXPECT_NEAR(data.mass, pi, 5e-3f);
    EXPECT_NEAR(data.inertia, pi / 2, 5e-3f);
}

TEST(Mass, RoundedBoxHasSteinersArea)
{
    const float width = 4, height = 3, r = 0.5f;
    const MassData data = mass_of(rounded_box(width, height, r), 1);
    EXPECT_NEAR(data.mass, width * height - (4 - pi) * r * r, 1e-5f);
    EXPECT_NEAR(length(data.center), 0, 1e-6f);
}

TEST(Mass, RoundedShapesMatchAGrid)
{
    const std::array<Vec2, 3> triangle = {{{-1, 0}, {2, 0.5f}, {0, 1.5f}}};
    const std::array<Vec2, 5> pentagon = {{{1, 1}, {3, 0.5f}, {4, 2}, {2.5f, 3.5f}, {1, 2.5f}}};
    for (const Geometry& geometry :
         {Geometry(convex_hull(triangle, 0.4f)), Geometry(convex_hull(pentagon, 0.25f)), Geometry(convex_hull(triangle)),
          Geometry(rounded_box(2, 1, 0.3f)), Geometry(capsule({-1, 0}, {0.5f, 1}, 0.4f)), Geometry(circle(0.7f, {1, 2}))})
    {
        expect_near(mass_of(geometry, 1), counted_on_a_grid(geometry), 2e-3f);
    }
}

TEST(Mass, StaysExactFarFromTheOrigin)
{
    const std::array<Vec2, 3> near_corners = {{{0, 0}, {3, 0}, {0, 6}}};
    const MassData near = mass_of(convex_hull(near_corners, 0.5f), 1);
    const Vec2 far_away = {524288, -524288};
    std::array<Vec2, 3> far_corners = near_corners;
    for (Vec2& corner : far_corners) corner += far_away;
    const MassData far = mass_of(convex_hull(far_corners, 0.5f), 1);
    EXPECT_EQ(far.mass, near.mass);
    EXPECT_EQ(far.inertia, near.inertia);
    EXPECT_NEAR(far.center.x - far_away.x, near.center.x, 0.04f); // half the spacing of floats there
    EXPECT_NEAR(far.center.y - far_away.y, near.center.y, 0.04f);
}

TEST(Mass, DoesNotChangeWhenTheShapeMoves)
{
    detail::RandomShapes random(11);
    for (int i = 0; i < 500; ++i)
    {
        const Geometry geometry = random.geometry_of(i % 4, 2);
        const Transform transform = random.transform(5);
        const MassData here = mass_of(geometry, 3);
        const MassData there = mass_of(transformed(geometry, transform), 3);
        ASSERT_NEAR(there.mass, here.mass, 1e-4f * here.mass);
        ASSERT_NEAR(there.inertia, here.inertia, 1e-4f * here.inertia);
        ASSERT_NEAR(distance(there.center, transform * here.center), 0, 1e-5f);
    }
}

TEST(Mass, RefusesBadDensities)
{
    EXPECT_EQ(mass_of(circle(1), 0).mass, 0);
    for (float density : {-1.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 3.4e38f})
    {
        EXPECT_THROW(mass_of(circle(1), density), UsageError) << density;
    }
}

} // namespace carom
