// The nearest point of a segment or a polygon to a given point: what circles need of the shapes they meet.
#pragma once

#include <carom/shape.hpp>

namespace carom::detail
{

/// A point seen from a shape without its radius.
struct Nearest
{
    Vec2 normal;        ///< unit, from the shape towards the point
    float distance = 0; ///< negative inside a polygon [m]
};

/// Below this, two points have no direction between them that rounding would not have made [m].
inline constexpr float least_direction_length = 1e-9f;

/// From `foot`, on the shape, to `point`; `fallback` when they coincide.
inline Nearest nearest_from_foot(Vec2 foot, Vec2 point, Vec2 fallback)
{
    const Vec2 d = point - foot;
    const float distance = length(d);
    if (distance < least_direction_length) return {fallback, distance};
    return {{d.x / distance, d.y / distance}, distance};
}

/// For a point on the segment the normal is to its left.
inline Nearest nearest_on_segment(Vec2 p1, Vec2 p2, Vec2 point)
{
    const Vec2 edge = p2 - p1;
    const float along = dot(point - p1, edge);
    const float length2 = dot(edge, edge);
    const Vec2 left = normalize(left_perp(edge));
    if (along <= 0) return nearest_from_foot(p1, point, left);
    if (along >= length2) return nearest_from_foot(p2, point, left);
    const float side = dot(point - p1, left);
    return side >= 0 ? Nearest{left, side} : Nearest{-left, -side};
}

/// The face with the largest separation either holds the nearest point or ends in the corner that does: around the polygon, the
/// separation rises and falls only once as long as it is positive.
inline Nearest nearest_on_polygon(const Polygon& polygon, Vec2 point)
{
    const std::size_t count = static_cast<std::size_t>(polygon.count);
    std::size_t face = 0;
    float separation = dot(polygon.normals[0], point - polygon.vertices[0]);
    for (std::size_t i = 1; i < count; ++i)
    {
        const float s = dot(polygon.normals[i], point - polygon.vertices[i]);
        if (s > separation)
        {
            separation = s;
            face = i;
        }
    }
    const Vec2 normal = polygon.normals[face];
    if (separation <= 0) return {normal, separation};

    const Vec2 v1 = polygon.vertices[face];
    const Vec2 v2 = polygon.vertices[face + 1 < count ? face + 1 : 0];
    const Vec2 edge = v2 - v1;
    if (dot(point - v1, edge) < 0) return nearest_from_foot(v1, point, normal);
    if (dot(point - v2, edge) > 0) return nearest_from_foot(v2, point, normal);
    return {normal, separation};
}

} // namespace carom::detail
