// Shapes that a user filled in by hand, each wrong in one way.
#include "geometry/random_shapes.hpp"
#include "geometry/validate.hpp"

#include <carom/error.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>
#include <string>

namespace carom::detail
{

namespace
{

std::string refused_field(const Geometry& geometry)
{
    try
    {
        validate(geometry, "create_shape");
    }
    catch (const UsageError& error)
    {
        EXPECT_EQ(error.function(), "create_shape");
        EXPECT_FALSE(error.remedy().empty());
        return error.field();
    }
    return "none";
}

} // namespace

TEST(Validate, AcceptsWhatTheMakersMake)
{
    RandomShapes random(41);
    for (int i = 0; i < 2000; ++i) ASSERT_NO_THROW(validate(random.geometry_of(i % 4, i % 2 == 0 ? 0.05f : 50), "test"));
}

TEST(Validate, NamesTheFieldOfSimpleShapes)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(refused_field(Circle{{0, 0}, 0}), "circle.radius");
    EXPECT_EQ(refused_field(Circle{{nan, 0}, 1}), "circle.center.x");
    EXPECT_EQ(refused_field(Capsule{{0, 0}, {0, 0}, 1}), "capsule.p2");
    EXPECT_EQ(refused_field(Capsule{{0, 0}, {1, 0}, -1}), "capsule.radius");
    EXPECT_EQ(refused_field(Capsule{{0, 0}, {1, 0}, 1e-42f}), "capsule.radius");
    EXPECT_EQ(refused_field(Segment{{0, nan}, {1, 0}}), "segment.p1.y");
    EXPECT_EQ(refused_field(Segment{{0, 0}, {0, 1e-4f}}), "segment.p2");
    EXPECT_EQ(refused_field(Polygon{}), "polygon.count");
}

TEST(Validate, NamesTheFieldOfPolygons)
{
    const auto broken = [](auto change)
    {
        Polygon polygon = box(2, 2);
        change(polygon);
        return refused_field(polygon);
    };
    EXPECT_EQ(broken([](Polygon&) {}), "none");
    EXPECT_EQ(broken([](Polygon& p) { p.count = 9; }), "polygon.count");
    EXPECT_EQ(broken([](Polygon& p) { p.radius = -1; }), "polygon.radius");
    EXPECT_EQ(broken([](Polygon& p) { p.vertices[2].x = std::numeric_limits<float>::quiet_NaN(); }), "polygon.vertices[2].x");
    EXPECT_EQ(broken([](Polygon& p) { p.vertices[1] = p.vertices[0]; }), "polygon.vertices[1]");
    EXPECT_EQ(broken([](Polygon& p) { p.vertices[2] = {-0.5f, -0.5f}; }), "polygon.vertices[3]") << "a dent";
    EXPECT_EQ(broken([](Polygon& p) { std::swap(p.vertices[1], p.vertices[3]); }), "polygon.vertices[2]") << "clockwise";
    EXPECT_EQ(broken([](Polygon& p) { p.normals[3] = {1, 0}; }), "polygon.normals[3]");
    EXPECT_EQ(broken([](Polygon& p) { p.normals[0] = {0, -2}; }), "polygon.normals[0]");
    EXPECT_EQ(broken([](Polygon& p) { p.normals[0].x = std::numeric_limits<float>::quiet_NaN(); }), "polygon.normals[0]");
    EXPECT_EQ(broken([](Polygon& p) { p.centroid = {5, 0}; }), "polygon.centroid");
}

TEST(Validate, RefusesAPolygonThatGoesAroundTwice)
{
    Polygon star;
    star.count = 5;
    for (std::size_t i = 0; i < 5; ++i)
    {
        const SinCos v = sin_cos(static_cast<float>(i) * 4 * pi / 5);
        star.vertices[i] = {v.cos, v.sin};
    }
    EXPECT_NE(refused_field(star), "none");
}

/// Random bytes are shapes too, as far as the compiler knows.
TEST(Validate, NeverBreaksOnRandomBits)
{
    std::mt19937 random(42);
    const auto any = [&random] { return std::bit_cast<float>(static_cast<std::uint32_t>(random())); };
    for (int i = 0; i < 20000; ++i)
    {
        Polygon polygon = box(2, 2);
        polygon.count = i % 3 == 0 ? static_cast<int>(random()) : 3 + i % 6;
        for (Vec2& v : polygon.vertices) v = i % 2 == 0 ? Vec2{any(), any()} : v;
        polygon.radius = any();
        for (const Geometry& geometry :
             {Geometry(polygon), Geometry(Circle{{any(), any()}, any()}), Geometry(Capsule{{any(), any()}, {any(), any()}, any()}),
              Geometry(Segment{{any(), any()}, {any(), any()}})})
        {
            if (refused_field(geometry) != "none") continue;
            const MassData data = mass_of(geometry, 1);
            ASSERT_TRUE(std::isfinite(data.mass) && std::isfinite(data.inertia) && is_finite(data.center));
        }
    }
}

} // namespace carom::detail
