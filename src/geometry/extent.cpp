// Inner and outer radii of shapes.
#include "geometry/extent.hpp"

#include <algorithm>

namespace carom::detail
{

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

} // namespace carom::detail
