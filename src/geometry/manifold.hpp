// Narrow phase: where two shapes touch, as at most two points with the features that made them.
#pragma once

#include "geometry/tolerances.hpp"

#include <carom/math.hpp>
#include <carom/shape.hpp>

#include <array>
#include <cstdint>

namespace carom::detail
{

/// One point of a local manifold.
struct LocalPoint
{
    Vec2 position;             ///< in A's frame, halfway between the surfaces [m]
    float separation = 0;      ///< negative when the shapes overlap [m]
    std::uint32_t feature = 0; ///< which corners or edges made the point
};

/// Where B touches A, in the frame of A's body.
struct LocalManifold
{
    Vec2 normal; ///< unit, from A to B, in A's frame
    std::array<LocalPoint, 2> points;
    int count = 0;
};

/// The contact of two shapes; no points when they are farther apart than `margin`.
/// @param b_in_a     the frame of B's body seen from A's
/// @param margin     [m], >= 0
/// @param tolerances of the world that they are in
LocalManifold collide(const Geometry& a, const Geometry& b, const Transform& b_in_a, float margin, const Tolerances& tolerances = {});

/// No points when they are farther apart than the world's speculative distance.
inline LocalManifold collide(const Geometry& a, const Geometry& b, const Transform& b_in_a, const Tolerances& tolerances = {})
{
    return collide(a, b, b_in_a, tolerances.speculative_distance, tolerances);
}

} // namespace carom::detail
