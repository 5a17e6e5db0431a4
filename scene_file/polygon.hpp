// Polygons as scene files write them: what follows from the vertices is computed.
#pragma once

#include "scene_file/fields.hpp"

namespace carom::scene_file
{

/// The polygon of these corners in this order, to the last bit as the engine's own makers would give it.
/// @param length_unit of the world, of which the least size of a polygon is a share [m]
/// @throws UsageError when the corners are not those of a convex polygon, counter-clockwise, that such a world accepts
Polygon polygon_from(const PolygonFields& fields, float length_unit);

/// What has to be written so that polygon_from() gives the same polygon to the last bit.
PolygonFields fields_of(const Polygon& polygon);

} // namespace carom::scene_file
