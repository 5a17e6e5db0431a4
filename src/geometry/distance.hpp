// Distance of convex shapes by the algorithm of Gilbert, Johnson and Keerthi.
#pragma once

#include "geometry/tolerances.hpp"

#include <carom/math.hpp>
#include <carom/shape.hpp>

#include <array>

namespace carom::detail
{

/// A convex shape as GJK sees it: the hull of a few points, grown by a radius. A circle is one point, a capsule two.
struct ConvexPoints
{
    std::array<Vec2, max_polygon_vertices> points; ///< the first `count` are in use [m]
    int count = 0;
    float radius = 0; ///< [m]
};

ConvexPoints convex_points(const Geometry& geometry);

struct DistanceResult
{
    Vec2 point_a;       ///< closest point on A's surface, in A's frame; a common point when the hulls without their radii overlap [m]
    Vec2 point_b;       ///< closest point on B's surface, in A's frame; behind point_a, against the normal, when only the radii overlap [m]
    Vec2 normal;        ///< unit, from A to B, in A's frame; (0, 0) when the hulls without their radii overlap
    float distance = 0; ///< between the surfaces, 0 when they overlap [m]
    int iterations = 0;
};

/// @param a, b   of 1 or more points
/// @param b_in_a the frame of B seen from A's
DistanceResult distance(const ConvexPoints& a, const ConvexPoints& b, const Transform& b_in_a);

/// True when the shapes share at least a point, or are within the world's touch distance.
bool overlap(const Geometry& a, const Geometry& b, const Transform& b_in_a, const Tolerances& tolerances = {});

} // namespace carom::detail
