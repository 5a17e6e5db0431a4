// How large a shape is, in two numbers: for judging whether a body is fast, and whether it is at rest.
#pragma once

#include <carom/shape.hpp>

namespace carom::detail
{

/// Radius of a disc around the shape's middle that lies inside it [m]; 0 for a segment.
float inner_radius(const Geometry& geometry);

/// Distance from a point to the farthest point of the shape [m].
float outer_radius(const Geometry& geometry, Vec2 point);

} // namespace carom::detail
