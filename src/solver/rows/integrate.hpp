// Moves bodies: velocities by acceleration, positions by velocity.
#pragma once

#include "dynamics/body_store.hpp"
#include "solver/isa/body_passes.hpp"

#include <carom/math.hpp>

#include <span>

namespace carom::detail
{

/// What moves, and what moves it, by motion index.
struct MovingBodies
{
    std::span<BodyMotion> motions;
    std::span<const BodyMass> masses;
    std::span<const BodyDrive> drives;
};

/// See integrate_velocity().
/// @param gravity [m/s^2]
/// @param fields  acceleration of each body by fields [m/s^2], by motion index; empty when there are none
/// @param h       substep [s]
void integrate_velocities(const BodyPasses& passes, const MovingBodies& bodies, Vec2 gravity, std::span<const Vec2> fields, float h);

/// The acceleration of each body by gravity, fields and forces, as integrate_velocities applies it, without damping [m/s^2].
/// @param accelerations by motion index, as many as bodies
void free_accelerations(std::span<const BodyMass> masses, std::span<const BodyDrive> drives, Vec2 gravity, std::span<const Vec2> fields,
                        std::span<Vec2> accelerations);

/// See integrate_position().
void integrate_positions(const BodyPasses& passes, std::span<BodyMotion> motions, float h);

/// The rotation that follows `q` by a small turn. See turned_by().
Rot turned(Rot q, float turn);

} // namespace carom::detail
