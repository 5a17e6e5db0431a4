// When two moving and turning convex shapes come near each other: the kernel of continuous collision.
#pragma once

#include "geometry/distance.hpp"

#include <optional>

namespace carom::detail
{

/// The way of a body over a span of time that runs from 0 to 1: its centre of mass moves evenly along a line, and it turns evenly about it.
struct Sweep
{
    Vec2 local_center; ///< of mass, in the body's frame [m]
    Vec2 center_start; ///< of mass, in the world at time 0 [m]
    Vec2 center_end;   ///< and at time 1
    Rot q_start;       ///< of the body at time 0
    float turn = 0;    ///< from time 0 to 1, counter-clockwise; may be more than a full turn [rad]

    /// Of the body's origin.
    Transform at(float time) const;
};

/// The first time at which the distance of the shapes falls to the target.
///
/// The time is safe: up to it the distance is at no moment less than the target, but for the rounding of the coordinates. At the time itself the
/// shapes are within the world's impact tolerance of the target; when that can't be reached in a bounded number of steps, as for shapes that turn
/// about each other at almost exactly the target, the time is the latest one that was found to be safe.
/// @param a, b            in the frames of their bodies
/// @param target_distance between the surfaces, > 0; well above the rounding of the shapes' coordinates [m]
/// @return in [0, 1]; 0 when they start nearer than the target; empty when they never come that near. Those that come within that tolerance of
///         the target but not to it may be either
std::optional<float> time_of_impact(const ConvexPoints& a, const Sweep& sweep_a, const ConvexPoints& b, const Sweep& sweep_b,
                                    float target_distance, const Tolerances& tolerances = {});

} // namespace carom::detail
