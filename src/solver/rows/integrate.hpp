// Moves bodies: velocities by acceleration, positions by velocity.
#pragma once

#include "dynamics/body_store.hpp"

#include <carom/math.hpp>

#include <span>

namespace carom::detail
{

/// v <- (v + h a) / (1 + h c), the implicit form of dv/dt = a - c v: stable at any damping c.
/// @param gravity [m/s^2]
/// @param fields  acceleration of each body by fields [m/s^2], by motion index; empty when there are none
/// @param h       substep [s]
void integrate_velocities(std::span<BodyMotion> motions, std::span<const BodyMass> masses, std::span<const BodyDrive> drives, Vec2 gravity,
                          std::span<const Vec2> fields, float h);

/// The acceleration of each body by gravity, fields and forces, as integrate_velocities applies it, without damping [m/s^2].
/// @param accelerations by motion index, as many as bodies
void free_accelerations(std::span<const BodyMass> masses, std::span<const BodyDrive> drives, Vec2 gravity, std::span<const Vec2> fields,
                        std::span<Vec2> accelerations);

/// dp <- dp + h v and dq <- (rotation by h w) dq.
void integrate_positions(std::span<BodyMotion> motions, float h);

/// The rotation that follows `q` by a small turn: error under 1e-5 rad for turns up to 0.4 rad, and the result is of unit length.
Rot turned(Rot q, float turn);

} // namespace carom::detail
