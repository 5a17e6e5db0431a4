// Inner and outer radii of shapes.
#include "geometry/extent.hpp"

#include <algorithm>

namespace carom::detail
{

Vec2 middle_of(const Geometry& geometry)
{
    if (const auto* circle = std::get_if<Circle>(&geometry)) return circle->center;
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) return 0.5f * (capsule->p1 + capsule->p2);
    if (const auto* segment = std::get_if<Segment>(&geometry)) return 0.5f * (segment->p1 + segment->p2);
    return std::get_if<Polygon>(&geometry)->centroid;
}

float inner_radius(const Geometry& geometry)
{
    if (const auto* circle = std::get_if<Circle>(&geometry)) return circle->radius;
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) return capsule->radius;
    const auto* polygon = std::get_if<Polygon>(&geometry);
    if (!polygon) return 0;
    float least = dot(polygon->normals[0], polygon->vertices[0] - polygon->centroid);
    for (std::size_t i = 1; i < static_cast<std::size_t>(polygon->count); ++i)
        least = std::min(least, dot(polygon->normals[i], polygon->vertices[i] - polygon->centroid));
    return std::max(0.0f, least) + polygon->radius;
}

float outer_radius(const Geometry& geometry, Vec2 point)
{
    if (const auto* circle = std::get_if<Circle>(&geometry)) return distance(circle->center, point) + circle->radius;
    if (const auto* capsule = std::get_if<Capsule>(&geometry))
        return std::max(distance(capsule->p1, point), distance(capsule->p2, point)) + capsule->radius;
    if (const auto* segment = std::get_if<Segment>(&geometry)) return std::max(distance(segment->p1, point), distance(segment->p2, point));
    const auto& polygon = *std::get_if<Polygon>(&geometry);
    float most = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) most = std::max(most, distance(polygon.vertices[i], point));
    return most + polygon.radius;
}

Extent extent_of(const Geometry& geometry)
{
    const Vec2 middle = middle_of(geometry);
    return {middle, inner_radius(geometry), outer_radius(geometry, middle)};
}

float rounding(const Geometry& geometry)
{
    if (const auto* circle = std::get_if<Circle>(&geometry)) return circle->radius;
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) return capsule->radius;
    if (const auto* polygon = std::get_if<Polygon>(&geometry)) return polygon->radius;
    return 0;
}

ConvexPoints core_of(const Geometry& geometry, float depth)
{
    ConvexPoints core = convex_points(geometry);
    const float from_radius = std::min(core.radius, depth);
    core.radius -= from_radius;
    const float inset = depth - from_radius;
    const auto* polygon = std::get_if<Polygon>(&geometry);
    if (!polygon || inset <= 0) return core;
    // Each corner goes to where the two edges beside it meet when both move inwards; a sharp one no farther than to the middle.
    for (std::size_t i = 0; i < static_cast<std::size_t>(core.count); ++i)
    {
        const Vec2 n1 = polygon->normals[i == 0 ? static_cast<std::size_t>(core.count) - 1 : i - 1];
        const Vec2 n2 = polygon->normals[i];
        const Vec2 step = (inset / std::max(1 + dot(n1, n2), 0.05f)) * (n1 + n2);
        const Vec2 to_middle = core.points[i] - polygon->centroid;
        core.points[i] -= length(step) < length(to_middle) ? step : to_middle;
    }
    return core;
}

} // namespace carom::detail
