// How large a shape is, in two numbers: for judging whether a body is fast, and whether it is at rest.
#pragma once

#include "geometry/distance.hpp"

#include <carom/shape.hpp>

namespace carom::detail
{

/// The middle of the shape [m]: of a polygon its centroid.
Vec2 middle_of(const Geometry& geometry);

/// Radius of a disc around the shape's middle that lies inside it [m]; 0 for a segment.
float inner_radius(const Geometry& geometry);

/// Distance from a point to the farthest point of the shape [m].
float outer_radius(const Geometry& geometry, Vec2 point);

/// Those numbers together, kept beside a shape that is asked for them often.
struct Extent
{
    Vec2 middle;     ///< [m]
    float inner = 0; ///< inner_radius() [m]
    float outer = 0; ///< outer_radius() about the middle [m]
};

Extent extent_of(const Geometry& geometry);

/// The radius by which a shape's corners are round [m]: all of a circle's; 0 for what does not roll.
float rounding(const Geometry& geometry);

/// The shape without its outermost `depth`: what must go into another for the two to pass through each other. Approximate, and never larger than
/// the shape.
/// @param depth [m], from 0 to below the inner radius
ConvexPoints core_of(const Geometry& geometry, float depth);

} // namespace carom::detail
