// The difference of two convex shapes as a polygon: one shape moves against another exactly as a point moves against it.
#pragma once

#include "geometry/distance.hpp"
#include "geometry/vec2d.hpp"

namespace carom::detail
{

/// A corner of the difference and the corners that it comes from.
struct MinkowskiCorner
{
    Vec2d position;  ///< corner of A - corner of B [m]
    int index_a = 0; ///< in ConvexPoints
    int index_b = 0;
};

/// All points a - b with a in A and b in B, without the radii: a convex polygon, counter-clockwise. Of fewer than three corners, a
/// segment (there and back) or a point. In double precision, so that long casts keep their digits.
struct MinkowskiHull
{
    std::array<MinkowskiCorner, 2 * max_polygon_vertices> corners; ///< the first `count` are in use
    int count = 0;

    const MinkowskiCorner& corner(int i) const { return corners[static_cast<std::size_t>(i)]; }
    const MinkowskiCorner& next(int i) const { return corner(i + 1 < count ? i + 1 : 0); }
};

/// @param a, b   counter-clockwise when they have three or more points
/// @param b_in_a the frame of B seen from A's; the hull is in A's frame
MinkowskiHull minkowski_difference(const ConvexPoints& a, const ConvexPoints& b, const Transform& b_in_a);

/// A seen from a point, which is the origin of the hull.
MinkowskiHull minkowski_difference(const ConvexPoints& a, Vec2 point);

} // namespace carom::detail
