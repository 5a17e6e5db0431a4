// From a cloud of points to a clean convex polygon.
#include "geometry/mass.hpp"
#include "geometry/polygon.hpp"
#include "geometry/validate.hpp"
#include "geometry/vec2d.hpp"
#include "math/usage_error.hpp"

#include <carom/shape.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace carom
{

namespace detail
{

namespace
{

constexpr std::size_t max_points = 64;

/// A short list of points that stays on the stack.
struct PointList
{
    std::array<Vec2, max_points + 1> items;
    std::size_t count = 0;

    void push(Vec2 p) { items[count++] = p; }
    void erase(std::size_t i)
    {
        std::copy(items.begin() + static_cast<std::ptrdiff_t>(i) + 1, items.begin() + static_cast<std::ptrdiff_t>(count),
                  items.begin() + static_cast<std::ptrdiff_t>(i));
        --count;
    }
};

/// Twice the signed area of the triangle; positive when c is left of the line from a to b.
double orientation(Vec2 a, Vec2 b, Vec2 c) { return cross(Vec2d(b) - Vec2d(a), Vec2d(c) - Vec2d(a)); }

/// Keeps the first of points that are nearer to each other than `least`.
PointList welded(std::span<const Vec2> points, double least)
{
    PointList kept;
    for (const Vec2 p : points)
    {
        const auto is_near = [p, least](Vec2 q) { return length(Vec2d(p) - Vec2d(q)) < least; };
        const auto end = kept.items.begin() + static_cast<std::ptrdiff_t>(kept.count);
        if (std::none_of(kept.items.begin(), end, is_near)) kept.push(p);
    }
    return kept;
}

/// Andrew's monotone chain: the lower hull from left to right, then the upper one back.
/// @source A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979
PointList hull_of(PointList points)
{
    const auto end = points.items.begin() + static_cast<std::ptrdiff_t>(points.count);
    std::sort(points.items.begin(), end, [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });

    PointList hull;
    const auto add = [&hull](Vec2 p, std::size_t floor)
    {
        while (hull.count >= floor + 2 && orientation(hull.items[hull.count - 2], hull.items[hull.count - 1], p) <= 0) --hull.count;
        hull.push(p);
    };
    for (std::size_t i = 0; i < points.count; ++i) add(points.items[i], 0);
    const std::size_t turning_point = hull.count - 1;
    for (std::size_t i = points.count - 1; i-- > 0;) add(points.items[i], turning_point);
    if (hull.count > 1) --hull.count; // the first point closes the loop
    return hull;
}

/// Drops the bluntest corner again and again until none is too blunt: dropping one sharpens or blunts its neighbours.
void drop_blunt_corners(PointList& hull, double collinear_distance)
{
    while (hull.count >= 3)
    {
        std::size_t bluntest = 0;
        double least = collinear_distance;
        for (std::size_t i = 0; i < hull.count; ++i)
        {
            const Vec2 before = hull.items[(i + hull.count - 1) % hull.count];
            const Vec2 after = hull.items[(i + 1) % hull.count];
            const double height = orientation(before, hull.items[i], after) / length(Vec2d(after) - Vec2d(before));
            if (height < least)
            {
                least = height;
                bluntest = i;
            }
        }
        if (least >= collinear_distance) return;
        hull.erase(bluntest);
    }
}

void check_arguments(std::span<const Vec2> points, float radius)
{
    require_range("convex_hull", "points.size()", points.size(), 3, max_points);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const Vec2 p = points[i];
        if (std::abs(p.x) <= max_coordinate && std::abs(p.y) <= max_coordinate) continue;
        require_within("convex_hull", "points[" + std::to_string(i) + "]", p, max_coordinate);
    }
    require_range("convex_hull", "radius", radius, 0.0f, max_coordinate);
}

} // namespace

Polygon polygon_from_corners(std::span<const Vec2> corners, float radius, std::string_view function, const Tolerances& tolerances)
{
    Polygon polygon;
    polygon.count = static_cast<int>(corners.size());
    polygon.radius = radius;
    polygon.centroid = corners[0];
    std::copy(corners.begin(), corners.end(), polygon.vertices.begin());
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const Vec2d edge = Vec2d(corners[(i + 1) % corners.size()]) - Vec2d(corners[i]);
        const double edge_length = length(edge);
        if (edge_length > 0) polygon.normals[i] = to_float((1 / edge_length) * right_perp(edge)); // else validate() refuses the edge
    }
    validate(polygon, function, "", tolerances);
    polygon.centroid = to_float(moments_of(polygon).center);
    return polygon;
}

} // namespace detail

Polygon convex_hull(std::span<const Vec2> points, float radius, float length_unit)
{
    detail::check_arguments(points, radius);
    const detail::Tolerances tolerances = detail::tolerances_for(length_unit, "convex_hull");
    detail::PointList hull = detail::hull_of(detail::welded(points, double{tolerances.min_edge_length}));
    detail::drop_blunt_corners(hull, tolerances.collinear_distance);
    if (hull.count < 3)
    {
        detail::usage_error("convex_hull", "points", "a line or a single point", "give points that enclose an area");
    }
    if (hull.count > static_cast<std::size_t>(max_polygon_vertices))
    {
        detail::usage_error("convex_hull", "corner count", hull.count, "give points whose hull has at most 8 corners");
    }
    return detail::polygon_from_corners({hull.items.data(), hull.count}, radius, "convex_hull", tolerances);
}

} // namespace carom
