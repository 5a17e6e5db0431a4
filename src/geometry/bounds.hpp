// Bounds of shapes and whether they hold a point, for shapes and places that were checked before. The public calls check them.
#pragma once

#include <carom/shape.hpp>

namespace carom::detail
{

Aabb bounds_of(const Geometry& geometry, const Transform& transform);
/// @param local_point in the shape's own frame [m]
bool holds(const Geometry& geometry, Vec2 local_point);

} // namespace carom::detail
