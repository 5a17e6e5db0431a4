// Refuses shapes that the engine can't work with. Shapes are plain aggregates, so a user may have filled one in by hand.
#pragma once

#include "geometry/tolerances.hpp"
#include "math/usage_error.hpp"

#include <carom/shape.hpp>

#include <string>
#include <string_view>

namespace carom::detail
{

/// Those of the smallest world: what asks about a shape without a world takes every shape that some world takes.
inline constexpr Tolerances any_world = {.length_unit = min_length_unit};

/// @throws UsageError in the name of `function` when the unit is out of range
inline Tolerances tolerances_for(float length_unit, std::string_view function)
{
    require_range(function, "length_unit", length_unit, min_length_unit, max_length_unit);
    return {.length_unit = length_unit};
}

/// A least size for a message: "1 mm", in a world of large bodies with the remedy.
std::string least_size_text(float length, const Tolerances& tolerances);

/// Throws UsageError unless every later computation on the shape is sound: all values finite and within max_coordinate, radii
/// positive, ends and corners far enough apart (1 mm in a world of length unit 1), polygons convex, counter-clockwise and with true normals, and the area large enough to
/// have a mass in float.
/// @param function the public function on whose behalf, "create_shape"; the fields are named "polygon.vertices[2].x"
void validate(const Geometry& geometry, std::string_view function, const Tolerances& tolerances = {});

// The same for one type.
// @param prefix of the fields' names: "polygon." or nothing
void validate(const Circle& circle, std::string_view function, std::string_view prefix);
void validate(const Capsule& capsule, std::string_view function, std::string_view prefix, const Tolerances& tolerances = {});
void validate(const Segment& segment, std::string_view function, std::string_view prefix, const Tolerances& tolerances = {});
void validate(const Polygon& polygon, std::string_view function, std::string_view prefix, const Tolerances& tolerances = {});

/// A place within max_coordinate, and a unit rotation.
/// @param field the argument's name
void validate(const Transform& transform, std::string_view function, std::string_view field);

/// A unit rotation, that of a transform.
/// @param field the transform's name
void validate_rotation(Rot q, std::string_view function, std::string_view field);

} // namespace carom::detail
