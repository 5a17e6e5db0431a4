// How bodies move over a substep, written once for every lane width: semi-implicit Euler.
#pragma once

#include "solver/kernels/body_lanes.hpp"

namespace carom::detail
{

/// Inverse masses as BodyMass has them.
template <class F>
struct MassLanes
{
    LaneVec<F> inv_mass;
    F inv_inertia;
};

/// What drives bodies, as BodyDrive has it.
template <class F>
struct DriveLanes
{
    LaneVec<F> force;
    F torque;
    LaneVec<F> gravity_scale;
    F linear_damping;
    F angular_damping;
};

/// @param gravity with what fields add to it
template <class F>
LaneVec<F> acceleration_of(const MassLanes<F>& mass, const DriveLanes<F>& drive, const LaneVec<F>& gravity)
{
    return scale(drive.gravity_scale, gravity) + scale(mass.inv_mass, drive.force);
}

/// v <- (v + h a) / (1 + h c), the implicit form of dv/dt = a - c v: stable at any damping c.
template <class F>
void integrate_velocity(BodyLanes<F>& body, const MassLanes<F>& mass, const DriveLanes<F>& drive, const LaneVec<F>& gravity, const F& h)
{
    const LaneVec<F> a = acceleration_of(mass, drive, gravity);
    body.v = (body.v + a * h) * (F(1) / (F(1) + h * drive.linear_damping));
    body.w = (F(1) / (F(1) + h * drive.angular_damping)) * (body.w + h * mass.inv_inertia * drive.torque);
}

/// The rotation that follows `q` by a small turn: error under 1e-5 rad for turns up to 0.4 rad.
///
/// With t = tan(turn / 2), (1 - t^2, 2 t) / (1 + t^2) is the exact rotation, and t = x + x^3 / 3 + 2 x^5 / 15 + ... at x = turn / 2. The
/// length stays 1 whatever t is, so that a fast spin loses accuracy, never unit length.
template <class F>
LaneRot<F> turned_by(const LaneRot<F>& q, const F& turn)
{
    const F x = F(0.5f) * turn;
    const F x2 = x * x;
    const F half_turn = F(1e9f); // t beyond it is a turn by pi already, and its square must not overflow
    const F t = lane_max(F(0) - half_turn, lane_min(x + x * x2 * (F(1 / 3.0f) + x2 * F(2 / 15.0f)), half_turn));
    const F inv = F(1) / (F(1) + t * t);
    const F c = (F(1) - t * t) * inv;
    const F s = F(2) * t * inv;
    return {c * q.c - s * q.s, s * q.c + c * q.s};
}

/// dp <- dp + h v and dq <- (rotation by h w) dq.
template <class F>
void integrate_position(BodyLanes<F>& body, const F& h)
{
    body.dp = body.dp + body.v * h;
    body.dq = turned_by(body.dq, h * body.w);
}

} // namespace carom::detail
