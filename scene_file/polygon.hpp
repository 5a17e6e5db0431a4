// Polygons as scene files write them: what follows from the vertices is computed.
#pragma once

#include "scene_file/fields.hpp"

namespace carom::scene_file
{

/// The polygon of these corners in this order, to the last bit as the engine's own makers would give it.
/// @throws UsageError when the corners are not those of a convex polygon, counter-clockwise
Polygon polygon_from(const PolygonFields& fields);

/// What has to be written so that polygon_from() gives the same polygon to the last bit.
PolygonFields fields_of(const Polygon& polygon);

} // namespace carom::scene_file
