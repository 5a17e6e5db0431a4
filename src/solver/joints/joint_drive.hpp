// Whether a joint moves its bodies of itself, so that they must not fall asleep.
#pragma once

#include "solver/kernels/joint_kernels.hpp"
#include "solver/rows/softness.hpp"

#include <algorithm>
#include <cmath>

namespace carom::detail
{

/// How near a drive must come to its target to be done [length units], [rad].
inline constexpr float drive_tolerance = 0.005f;

/// Whether the spring of a drive is still on the way to its target. An overdamped spring goes there at omega / (2 zeta) of what is missing; one that
/// hangs in balance with a load does not move.
/// @param missing what is missing to the target [m] or [rad]
/// @param speed   at which that becomes less [m/s] or [rad/s]
/// @param near    what may be missing [m] or [rad]
inline bool is_on_the_way(const SpringRow<float>& spring, float missing, float speed, float near)
{
    return spring.damping > 0 && missing > near && is_at_work(speed, missing * spring.push / spring.damping);
}

/// Whether lane `i` of a row has anything that could.
template <class F>
bool may_drive(const JointRow<F>& row, int i)
{
    if (row.type == RowType::Motor || row.type == RowType::Mouse) return true;
    for (std::size_t c = 0; row.has_ends && c < row.control_count; ++c)
        if (lane(row.controls[c].max_motor, i) > 0 && lane(row.controls[c].motor_speed, i) != 0) return true;
    return false;
}

/// Whether a motor, or the drive of a motor joint or a mouse joint, moves the bodies.
inline bool is_driven(const JointRow<float>& row, const BodyLanes<float>& a, const BodyLanes<float>& b, float length_unit)
{
    const bool pulls = row.type == RowType::Motor || row.type == RowType::Mouse;
    for (std::size_t c = 0; c < row.control_count; ++c)
    {
        const ControlRow<float>& control = row.controls[c];
        const float rate = velocity(control.j, a, b);
        if (control.max_motor > 0 && is_at_work(rate, control.motor_speed)) return true;
        const float past = control.q - control.target;
        if (pulls && control.max_spring > 0 && is_on_the_way(control.spring, std::abs(past), past > 0 ? -rate : rate, drive_tolerance))
            return true;
    }
    if (!pulls || !(row.drive.max_lambda > 0)) return false;
    const LaneVec<float> dv = (b.v + cross(b.w, row.r_b)) - (a.v + cross(a.w, reach_of_a(row, a)));
    const float missing = std::sqrt(dot(row.drive.error, row.drive.error));
    const float near = drive_tolerance * length_unit;
    const float speed = -dot(dv, row.drive.error) / std::max(missing, near);
    return is_on_the_way(row.drive.spring, missing, speed, near);
}

} // namespace carom::detail
