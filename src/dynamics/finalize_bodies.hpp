// Ends a step: puts bodies and the bounds of their shapes where the solver took them.
#pragma once

#include "broadphase/broad_phase.hpp"
#include "dynamics/body_store.hpp"
#include "dynamics/shape_store.hpp"
#include "geometry/manifold.hpp"
#include "geometry/time_of_impact.hpp"

#include <carom/report.hpp>

#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// A body that moved so far in the step that it may have passed through something.
struct FastBody
{
    std::uint32_t body;
    Sweep sweep;
};

/// By how much a body moved in the step.
struct Displacement
{
    Vec2 center;    ///< of its centre of mass [m]
    float turn = 0; ///< [rad]
};

/// What the motion of a step leaves for continuous collision to look at.
struct FastMotion
{
    explicit FastMotion(std::pmr::memory_resource& memory)
        : bodies(&memory),
          displacements(&memory),
          strayed_shapes(&memory),
          leaving_shapes(&memory)
    {
    }

    std::pmr::vector<FastBody> bodies;
    std::pmr::vector<Displacement> displacements; ///< by motion index
    /// Shapes, of fast bodies or not, that have left the fat bounds of the last search for pairs. All others are near only those that they
    /// have contacts with.
    std::pmr::vector<std::uint32_t> strayed_shapes;
    /// Shapes that are still within their fat bounds and are about to leave them in the next step.
    std::pmr::vector<std::uint32_t> leaving_shapes;
};

/// Fat bounds reach ahead along the velocity for this many steps: fewer searches for pairs, against more false pairs. Those of fast bodies are made
/// anew in each step, and so reach ahead for one.
inline constexpr float steps_ahead = 2;

/// A body whose state the step has lost.
struct LostBody
{
    std::uint32_t body;
    QuarantineReason reason;
};

/// How far the farthest point of a body may drift while the body counts as at rest [m]: a tenth of its size, so that no body falls
/// asleep while one sees it move, however small it is. A body without shapes has no size. Tests: sleep_drift_test.
inline float rest_drift(float outer_radius)
{
    constexpr float share_of_size = 0.1f;
    return outer_radius > 0 ? share_of_size * outer_radius : max_coordinate;
}

/// Whether calls accept the place.
inline bool is_in_world(Vec2 place) { return std::abs(place.x) <= max_coordinate && std::abs(place.y) <= max_coordinate; }

/// What moved by more than this may have passed through something [m]: half the radius of its thinnest part; a little is always allowed.
inline float fast_way(float inner_radius, const Tolerances& tolerances) { return std::max(0.5f * inner_radius, tolerances.linear_slop); }

/// Moves poses by the displacement since the start of the step, and clears it and the forces. Shapes that leave their fat bounds
/// get new ones and are marked as moved. A body whose state is not finite, is beyond 1e15, or that leaves the world stays where it
/// was, at rest.
/// @param sleep_speed bodies that are slower, and drift no farther than rest_drift, are at rest; BodyWatch keeps for how long [m/s]
/// @param lost such bodies, to be disabled; appended to
/// @param fast bodies that moved by more than half their size, and bullets; appended to, and the fat bounds of their shapes hold the whole
///             displacement. The broad phase keeps the older ones where these hold it too. Null: not asked
void finalize_bodies(BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float dt, float sleep_speed,
                     std::pmr::vector<LostBody>& lost, FastMotion* fast);

/// New bounds of all shapes of a body that has moved; they are marked as moved when they leave the fat ones.
/// @param way see fattened()
void refresh_bounds(std::uint32_t body, const BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, Vec2 way);

/// New fat bounds of shapes that are about to leave theirs, so that the next search for pairs comes before they stray.
void renew_bounds(std::span<const std::uint32_t> leaving, const BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float dt);

} // namespace carom::detail
