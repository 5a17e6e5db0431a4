// The faces of polygons, and of capsules and segments as polygons of two corners.
#pragma once

#include "geometry/manifold_kernels.hpp"

namespace carom::detail
{

/// A face of a shape, seen from where it is placed.
struct Face
{
    Edge edge;
    Vec2 normal;
    float radius;
};

/// @param place has point() and direction()
template <class Place>
Face face_of(const Polygon& polygon, std::uint32_t face, const Place& place)
{
    const std::uint32_t next = face + 1 < static_cast<std::uint32_t>(polygon.count) ? face + 1 : 0;
    return {{place.point(polygon.vertices[face]), place.point(polygon.vertices[next]), face, next},
            place.direction(polygon.normals[face]),
            polygon.radius};
}

/// The normal on the right of the way from p1 to p2. It comes from the shape's own frame: far away, p1 and p2 may be one point after rounding.
inline Vec2 right_normal(const SegmentCore& core) { return normalize(right_perp(core.p2 - core.p1)); }

template <class Place>
Face face_of(const SegmentCore& core, std::uint32_t face, const Place& place)
{
    const Vec2 p1 = place.point(core.p1);
    const Vec2 p2 = place.point(core.p2);
    const Vec2 right = right_normal(core);
    if (face == 0) return {{p1, p2, 0, 1}, place.direction(right), core.radius};
    return {{p2, p1, 1, 0}, place.direction(-right), core.radius};
}

inline SegmentCore core_of(const Capsule& capsule) { return {capsule.p1, capsule.p2, capsule.radius}; }

inline SegmentCore core_of(const Segment& segment) { return {segment.p1, segment.p2, 0}; }

/// What the points of a contact with A are measured from: near A's shape, wherever its body's origin is.
inline Vec2 origin_of(const Polygon& polygon) { return polygon.vertices[0]; }
inline Vec2 origin_of(const SegmentCore& core) { return core.p1; }

} // namespace carom::detail
