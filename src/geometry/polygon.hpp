// Completes a polygon from its corners.
#pragma once

#include "geometry/tolerances.hpp"

#include <carom/shape.hpp>

#include <span>
#include <string_view>

namespace carom::detail
{

/// Fills in normals and centroid, and validates.
/// @param corners  3 to 8, convex and counter-clockwise [m]
/// @param function on whose behalf, for errors
/// @throws UsageError
Polygon polygon_from_corners(std::span<const Vec2> corners, float radius, std::string_view function, const Tolerances& tolerances);

} // namespace carom::detail
