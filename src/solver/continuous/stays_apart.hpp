// Tests that are much cheaper than an exact time of impact, and spare most pairs that one.
#pragma once

#include "geometry/time_of_impact.hpp"

#include <carom/shape.hpp>

#include <algorithm>
#include <cstddef>

namespace carom::detail
{

/// What counts as apart: well above the rounding of coordinates, and of the time of impact [m].
inline float distance_apart(const Tolerances& tolerances) { return tolerances.impact_distance + tolerances.linear_slop; }

/// Whether some line between the two keeps them apart on their whole ways: along its normal n, from A to B,
///   s(t) >= s(0) + min(0, n . way of B past A) - what both swing by turning
/// and, since the second derivative of a corner's distance along n is at most its arm r times the square of its turn T,
///   s(t) >= min(s(0), s(1)) - (r_a T_a^2 + r_b T_b^2) / 8.
/// Where they stay apart, time_of_impact finds nothing.
/// @param least distance of the surfaces that counts as apart [m]
bool stays_apart(const ConvexPoints& a, const Sweep& way_a, const ConvexPoints& b, const Sweep& way_b, float least);

/// Whether a disc on a straight way stays beyond one face of a polygon that stands still.
/// @param from, to centre of the disc at the start and at the end [m]
/// @param distance of the centre from the face that counts as apart [m]
inline bool stays_beyond_a_face(const Polygon& polygon, const Transform& place, Vec2 from, Vec2 to, float distance)
{
    const Vec2 start = inverse_transform(place, from);
    const Vec2 end = inverse_transform(place, to);
    for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i)
    {
        const Vec2 n = polygon.normals[i];
        if (std::min(dot(n, start), dot(n, end)) - dot(n, polygon.vertices[i]) > distance) return true;
    }
    return false;
}

} // namespace carom::detail
