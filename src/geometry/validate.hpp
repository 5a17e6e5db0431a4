// Refuses shapes that the engine can't work with. Shapes are plain aggregates, so a user may have filled one in by hand.
#pragma once

#include <carom/shape.hpp>

#include <string_view>

namespace carom::detail
{

/// Least distance between the corners of a shape [m].
inline constexpr float min_edge_length = 0.001f;

/// Throws UsageError unless every later computation on the shape is sound: all values finite and within max_coordinate, radii
/// positive, ends and corners at least 1 mm apart, polygons convex, counter-clockwise and with true normals, and the area large enough to
/// have a mass in float.
/// @param function the public function on whose behalf, "create_shape"; the fields are named "polygon.vertices[2].x"
void validate(const Geometry& geometry, std::string_view function);

// The same for one type.
// @param prefix of the fields' names: "polygon." or nothing
void validate(const Circle& circle, std::string_view function, std::string_view prefix);
void validate(const Capsule& capsule, std::string_view function, std::string_view prefix);
void validate(const Segment& segment, std::string_view function, std::string_view prefix);
void validate(const Polygon& polygon, std::string_view function, std::string_view prefix);

/// A place within max_coordinate, and a unit rotation.
/// @param field the argument's name
void validate(const Transform& transform, std::string_view function, std::string_view field);

/// A unit rotation, that of a transform.
/// @param field the transform's name
void validate_rotation(Rot q, std::string_view function, std::string_view field);

} // namespace carom::detail
