// Ends a step: puts bodies and the bounds of their shapes where the solver took them.
#pragma once

#include "broadphase/broad_phase.hpp"
#include "dynamics/body_store.hpp"
#include "dynamics/shape_store.hpp"
#include "geometry/manifold.hpp"
#include "geometry/time_of_impact.hpp"

#include <algorithm>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

/// A body that moved so far in the step that it may have passed through something.
struct FastBody
{
    std::uint32_t body;
    Sweep sweep;
};

/// Fat bounds reach ahead along the velocity for this many steps: fewer searches for pairs, against more false pairs.
inline constexpr float steps_ahead = 2;

/// What moved by more than this may have passed through something [m]: half the radius of its thinnest part; a little is always allowed.
inline float fast_way(float inner_radius) { return std::max(0.5f * inner_radius, linear_slop); }

/// Moves poses by the way since the start of the step and clears it and the forces. Shapes that leave their fat bounds get new
/// ones and are marked as moved. A body whose state is not finite, or is beyond 1e15, stays where it
/// was, at rest.
/// @param sleep_speed slower bodies are at rest; how long they have been is kept in their BodyWatch [m/s]
/// @param not_finite slots of such bodies, to be disabled; appended to
/// @param fast       bodies that moved by more than half their size, and bullets; appended to, and their fat bounds hold their whole way; null: not asked
void finalize_bodies(BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float dt, float sleep_speed,
                     std::pmr::vector<std::uint32_t>& not_finite, std::pmr::vector<FastBody>* fast);

/// New bounds of all shapes of a body that was moved by hand; they are marked as moved when they leave the fat ones.
void refresh_bounds(std::uint32_t body, const BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, Vec2 way);

} // namespace carom::detail
