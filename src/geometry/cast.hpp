// Where a moving point or a moving convex shape first meets a shape at rest. Exact: nothing is iterated.
#pragma once

#include "geometry/distance.hpp"

#include <optional>

namespace carom::detail
{

/// What a cast met. All in the frame of the shape at rest.
struct CastResult
{
    float fraction = 0;         ///< of the sweep, in [0, 1]
    Vec2 normal;                ///< unit, from the shape at rest to the moving one; (0, 0) when the cast starts inside
    Vec2 point;                 ///< where they meet, on the surface of the shape at rest; the start of a ray that starts inside [m]
    bool starts_inside = false; ///< overlapping by more than the touch distance at the start; then the fraction is 0
};

// At the start, what is within the world's touch distance of the surface touches it: it is met at fraction 0 when the sweep goes into the surface,
// and not at all when it goes along it or away. So a thing that lies on another can be cast along it, and a ray can start where one ended.

/// @param start, sweep of the ray [m]; a sweep of (0, 0) meets only what it starts inside of
std::optional<CastResult> cast_ray(const ConvexPoints& shape, Vec2 start, Vec2 sweep, const Tolerances& tolerances = {});
std::optional<CastResult> cast_ray(const Geometry& shape, Vec2 start, Vec2 sweep, const Tolerances& tolerances = {});

/// Moves B against A without turning it.
/// @param a, b   counter-clockwise when they have three or more points, as convex_points() makes them
/// @param b_in_a the frame of B seen from A's, at the start
/// @param sweep  in A's frame [m]
std::optional<CastResult> cast_shape(const ConvexPoints& a, const ConvexPoints& b, const Transform& b_in_a, Vec2 sweep,
                                     const Tolerances& tolerances = {});

} // namespace carom::detail
