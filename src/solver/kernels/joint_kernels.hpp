// What a joint of each type holds: its Jacobians, errors and coordinates, and how they bend over a substep. Once for every lane width.
//
//      A  .---r_a---o . . . d . . . o---r_b---.  B        r_a, r_b: from the centres of mass to the origins of the frames
//                   frame A      frame B                  d: from the one origin to the other
//
// The rate of d at fixed positions is  d' = v_b + w_b x r_b - v_a - w_a x r_a. Seen from frame A, along a unit vector u that turns with A:
//   q = u . d,   q' = u . (v_b - v_a) + (r_b x u) w_b - ((d + r_a) x u) w_a
#pragma once

#include "solver/kernels/joint_solve.hpp"
#include "solver/kernels/lane_trig.hpp"

namespace carom::detail
{

/// Where a joint's bodies have come to since the start of the step.
template <class F>
struct JointPlace
{
    LaneVec<F> r_a;
    LaneVec<F> r_b;
    LaneVec<F> d;
};

template <class F>
JointPlace<F> place_of(const JointRow<F>& row, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    JointPlace<F> p;
    p.r_a = rotate(a.dq, row.arm_a);
    p.r_b = rotate(b.dq, row.arm_b);
    p.d = row.apart + (b.dp - a.dp) + (p.r_b - row.arm_b) - (p.r_a - row.arm_a);
    return p;
}

/// Rate of d along a direction that does not turn.
template <class F>
Jacobian<F> along_fixed(const LaneVec<F>& u, const JointPlace<F>& p)
{
    return {u, u, cross(p.r_a, u), cross(p.r_b, u)};
}

/// Rate of d along a direction that turns with A.
template <class F>
Jacobian<F> along_turning(const LaneVec<F>& u, const JointPlace<F>& p)
{
    return {u, u, cross(p.d + p.r_a, u), cross(p.r_b, u)};
}

/// Rate of the angle of B seen from A.
template <class F>
Jacobian<F> turning()
{
    return {{F(0), F(0)}, {F(0), F(0)}, F(1), F(1)};
}

/// The angle that equals `angle` but for full turns and is nearest to `near` [rad].
template <class F>
F unwrapped_near(const F& angle, const F& near)
{
    constexpr float full_turn = 6.28318531f;
    constexpr float to_integer = 12582912; // 1.5 2^23: what is added to it is rounded
    const F turns = ((near - angle) * F(1 / full_turn) + F(to_integer)) - F(to_integer);
    return angle + turns * F(full_turn);
}

/// From an angle on the same turn to the angle where the bodies are at the start of the step.
template <class F>
void find_turn(JointRow<F>& row)
{
    row.turn = unwrapped_near(lane_atan2(row.facing.s, row.facing.c), row.turn);
}

/// Whether a joint's angle over full turns is kept from step to step.
template <class F>
bool counts_turns(const JointRow<F>& row)
{
    return row.type == RowType::Revolute || row.type == RowType::Wheel;
}

/// Whether a row's errors or coordinates are angles.
template <class F>
bool measures_angle(const JointRow<F>& row)
{
    switch (row.type)
    {
    case RowType::Revolute: return row.control_count > 0; // nobody asks for the angle of a mere pin
    case RowType::Prismatic:
    case RowType::Weld:
    case RowType::Wheel:
    case RowType::Motor: return true;
    default: return false;
    }
}

/// Angle of frame B in frame A.
template <class F>
F turn_of(const JointRow<F>& row, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    const F c = a.dq.c * b.dq.c + a.dq.s * b.dq.s;
    const F s = a.dq.c * b.dq.s - a.dq.s * b.dq.c;
    return row.turn + lane_atan2(s, c);
}

/// How far a turn in a substep [rad] is trusted to go on: 1 up to `full`, falling to 0 at twice that. A curvature is taken from the velocities
/// before the impulses. Where those turn a body around within a substep, as in a whip that cracks, it would throw in energy.
template <class F>
F trust(F turn, float full)
{
    const F size = lane_max(turn, F(0) - turn);
    return lane_max(F(0), lane_min(F(1), F(2) - size * F(1 / full)));
}

/// Of two bodies against each other, as those of a fold in a chain: 17 rad/s at 240 substeps a second. Chain.energy_of_a_whip breaks.
inline constexpr float full_trust_fold = 0.07f;
/// Of a body by itself.
inline constexpr float full_trust_spin = 0.25f;

/// What an arm's tip moves beyond w x r over a substep, as a rate: (R(h w) r - r) / h - w x r.
template <class F>
LaneVec<F> bend(const LaneVec<F>& r, F w, const JointConstants<F>& k)
{
    const F x = k.h * w;
    const F x2 = x * x;
    const F cos_less_1 = x2 * (F(-1 / 2.0f) + x2 * F(1 / 24.0f));
    const F sin_less_x = x * x2 * (F(-1 / 6.0f) + x2 * F(1 / 120.0f));
    return (r * cos_less_1 + cross(sin_less_x, r)) * (k.inv_h * trust(x, full_trust_spin));
}

/// Rates of d: at fixed positions, and what its arms add by bending.
template <class F>
struct JointRates
{
    LaneVec<F> d;
    LaneVec<F> bend_d;
};

template <class F>
JointRates<F> rates_of(const JointPlace<F>& p, const BodyLanes<F>& a, const BodyLanes<F>& b, const JointConstants<F>& k)
{
    const LaneVec<F> bend_d = bend(p.r_b, b.w, k) - bend(p.r_a, a.w, k);
    return {(b.v + cross(b.w, p.r_b)) - (a.v + cross(a.w, p.r_a)), bend_d * trust(k.h * (b.w - a.w), full_trust_fold)};
}

/// Curvature of u . d where u turns with A.
template <class F>
F bend_along_turning(const LaneVec<F>& u, const JointPlace<F>& p, const JointRates<F>& r, F w_a, const JointConstants<F>& k)
{
    const LaneVec<F> way = (r.d + r.bend_d) * k.h;
    return (dot(bend(u, w_a, k), p.d + way) + dot(cross(w_a, u), way)) * trust(k.h * w_a, full_trust_spin) + dot(u, r.bend_d);
}

/// Curvature of |d|: what moves across d makes it longer. The way is cut at a quarter of the length, where the arc is no longer told by one
/// substep.
template <class F>
F bend_of_length(const LaneVec<F>& d, const JointRates<F>& r, const JointConstants<F>& k)
{
    const F length = lane_sqrt(dot(d, d));
    LaneVec<F> way = (r.d + r.bend_d) * k.h;
    const F size = lane_sqrt(dot(way, way));
    const F cut = lane_min(F(1), F(0.25f) * length / lane_max(size, F(1e-20f)));
    way = way * cut;
    const LaneVec<F> end = d + way;
    const F gain = (F(2) * dot(d, way) + dot(way, way)) * inverse_or_zero(lane_sqrt(dot(end, end)) + length);
    return (gain - dot(d, r.d) * k.h * cut * inverse_or_zero(length)) * k.inv_h;
}

template <class F>
void set_control(const JointRow<F>& row, ControlRow<F>& c, const Jacobian<F>& j, F q)
{
    c.j = j;
    c.q = q;
    c.mass = inverse_or_zero(coupling(row, j, j));
}

/// Unit vector along d, or along the axis when d has no direction.
template <class F>
LaneVec<F> direction_of(const LaneVec<F>& d, F length, const LaneVec<F>& otherwise)
{
    const auto is_long = length > F(1e-9f);
    const F inv = F(1) / lane_max(length, F(1e-9f));
    return {select(is_long, d.x * inv, otherwise.x), select(is_long, d.y * inv, otherwise.y)};
}

/// Revolute: C = d. Its coordinate is the angle, where it has one.
template <class F>
void linearise_revolute(JointRow<F>& row, const JointPlace<F>& p, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    row.rigid[0] = along_fixed<F>({F(1), F(0)}, p);
    row.rigid[1] = along_fixed<F>({F(0), F(1)}, p);
    row.error[0] = p.d.x;
    row.error[1] = p.d.y;
    if (row.control_count > 0) set_control(row, row.controls[0], turning<F>(), turn_of(row, a, b));
}

/// Prismatic: C = (n . d, angle) with n across the axis t of A. Its coordinate is t . d.
template <class F>
void linearise_prismatic(JointRow<F>& row, const JointPlace<F>& p, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    const LaneVec<F> t = rotate(a.dq, row.axis);
    const LaneVec<F> n = left_perp(t);
    row.rigid[0] = along_turning(n, p);
    row.rigid[1] = turning<F>();
    row.error[0] = dot(n, p.d);
    row.error[1] = turn_of(row, a, b);
    set_control(row, row.controls[0], along_turning(t, p), dot(t, p.d));
}

/// Wheel: C = n . d. Its coordinates are t . d and the angle.
template <class F>
void linearise_wheel(JointRow<F>& row, const JointPlace<F>& p, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    const LaneVec<F> t = rotate(a.dq, row.axis);
    const LaneVec<F> n = left_perp(t);
    row.rigid[0] = along_turning(n, p);
    row.error[0] = dot(n, p.d);
    set_control(row, row.controls[0], along_turning(t, p), dot(t, p.d));
    set_control(row, row.controls[1], turning<F>(), turn_of(row, a, b));
}

/// Distance: q = |d|, held at the length when it is a rod.
template <class F>
void linearise_distance(JointRow<F>& row, const JointPlace<F>& p)
{
    const F length = lane_sqrt(dot(p.d, p.d));
    const Jacobian<F> j = along_fixed(direction_of(p.d, length, row.axis), p);
    row.rigid[0] = j;
    row.error[0] = length - row.length;
    if (row.control_count > 0) set_control(row, row.controls[0], j, length);
}

/// Weld: C = (d, angle), each part rigid or soft.
template <class F>
void linearise_weld(JointRow<F>& row, const JointPlace<F>& p, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    std::size_t next = 0;
    if (!row.has_drive)
    {
        row.rigid[0] = along_fixed<F>({F(1), F(0)}, p);
        row.rigid[1] = along_fixed<F>({F(0), F(1)}, p);
        row.error[0] = p.d.x;
        row.error[1] = p.d.y;
        next = 2;
    }
    if (row.has_drive) row.drive.error = p.d;
    const F angle = turn_of(row, a, b);
    if (row.control_count > 0) return set_control(row, row.controls[0], turning<F>(), angle);
    row.rigid[next] = turning<F>();
    row.error[next] = angle;
}

/// Motor: the drive pulls frame B to its place in frame A, the spring of its angle to the angle there.
template <class F>
void linearise_motor(JointRow<F>& row, const JointPlace<F>& p, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    row.drive.error = p.d - rotate(a.dq, row.place_a);
    set_control(row, row.controls[0], turning<F>(), turn_of(row, a, b));
}

/// Gear: C = q_a + ratio q_b, where q is a turn or a slide along an axis of the body, taken as fixed over a step.
template <class F>
void linearise_gear(JointRow<F>& row, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    row.rigid[0] = {row.place_a * F(-1), row.place_b * row.ratio, F(0) - row.turns_a, row.ratio * row.turns_b};
    const F q_a = row.turns_a * lane_atan2(a.dq.s, a.dq.c) + dot(row.place_a, a.dp);
    const F q_b = row.turns_b * lane_atan2(b.dq.s, b.dq.c) + dot(row.place_b, b.dp);
    row.error[0] = row.slip + q_a + row.ratio * q_b;
}

/// Pulley: q = |a's point to its ground| + ratio |b's|, limited from above. An impulse that shortens pulls both up.
template <class F>
void linearise_pulley(JointRow<F>& row, const JointPlace<F>& p, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    const LaneVec<F> rope_a = row.place_a - a.dp - (p.r_a - row.arm_a);
    const LaneVec<F> rope_b = row.place_b - b.dp - (p.r_b - row.arm_b);
    const F length_a = lane_sqrt(dot(rope_a, rope_a));
    const F length_b = lane_sqrt(dot(rope_b, rope_b));
    const LaneVec<F> u_a = direction_of<F>(rope_a, length_a, {F(0), F(0)});
    const LaneVec<F> u_b = direction_of<F>(rope_b, length_b, {F(0), F(0)}) * (F(0) - row.ratio);
    const Jacobian<F> j = {u_a, u_b, cross(p.r_a, u_a), cross(p.r_b, u_b)};
    set_control(row, row.controls[0], j, length_a + row.ratio * length_b);
}

/// Jacobians, errors and coordinates where the bodies are now, of every type.
template <class F>
void linearise_by_type(JointRow<F>& row, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    const JointPlace<F> p = place_of(row, a, b);
    row.r_b = p.r_b;
    switch (row.type)
    {
    case RowType::Revolute: return linearise_revolute(row, p, a, b);
    case RowType::Prismatic: return linearise_prismatic(row, p, a, b);
    case RowType::Distance: return linearise_distance(row, p);
    case RowType::Weld: return linearise_weld(row, p, a, b);
    case RowType::Wheel: return linearise_wheel(row, p, a, b);
    case RowType::Motor: return linearise_motor(row, p, a, b);
    case RowType::Mouse: row.drive.error = p.d; return;
    case RowType::Gear: return linearise_gear(row, a, b);
    case RowType::Pulley: return linearise_pulley(row, p, a, b);
    }
}

/// Jacobians, errors and coordinates where the bodies are now, and what motors and ends meet there.
template <class F>
[[gnu::noinline, gnu::flatten]] void linearise(JointRow<F>& row, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    linearise_by_type(row, a, b);
    if (!row.has_ends) return;
    for (std::size_t i = 0; i < row.control_count; ++i) find_held_mass(row, row.controls[i]);
}

/// The same for a joint of a net. What an impulse of a motor or an end moves there is for the net to find out: with the answers of the joint's own rows
/// alone, ends that pull at the same bodies would drive each other up.
template <class F>
[[gnu::noinline, gnu::flatten]] void linearise_single(JointRow<F>& row, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    linearise_by_type(row, a, b);
    if (!row.has_ends) return;
    for (std::size_t i = 0; i < row.control_count; ++i)
    {
        row.controls[i].held_mass = row.controls[i].mass;
        for (F& reaction : row.controls[i].reaction) reaction = F(0);
    }
}

/// The angle at the end of the step.
template <class F>
void conclude(JointRow<F>& row, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    if (!counts_turns(row)) return;
    const LaneRot<F> change = {a.dq.c * b.dq.c + a.dq.s * b.dq.s, a.dq.c * b.dq.s - a.dq.s * b.dq.c};
    row.facing = {row.facing.c * change.c - row.facing.s * change.s, row.facing.s * change.c + row.facing.c * change.s};
    find_turn(row);
}

/// Curvatures at the velocities that the bodies have now, of every type.
template <class F>
void find_curvatures(JointRow<F>& row, const BodyLanes<F>& a, const BodyLanes<F>& b, const JointConstants<F>& k)
{
    const JointPlace<F> p = place_of(row, a, b);
    const JointRates<F> r = rates_of(p, a, b, k);
    switch (row.type)
    {
    case RowType::Revolute:
    case RowType::Weld:
        row.curvature = {r.bend_d.x, r.bend_d.y, F(0)};
        if (row.type == RowType::Weld && row.has_drive) row.curvature = {F(0), F(0), F(0)};
        return;
    case RowType::Prismatic:
    case RowType::Wheel:
    {
        const LaneVec<F> t = rotate(a.dq, row.axis);
        row.curvature = {bend_along_turning(left_perp(t), p, r, a.w, k), F(0), F(0)};
        row.controls[0].curvature = bend_along_turning(t, p, r, a.w, k);
        return;
    }
    case RowType::Distance:
        row.curvature[0] = bend_of_length(p.d, r, k);
        if (row.control_count > 0) row.controls[0].curvature = row.curvature[0];
        return;
    case RowType::Pulley:
    {
        const JointRates<F> rates_a = {LaneVec<F>{} - (a.v + cross(a.w, p.r_a)), LaneVec<F>{} - bend(p.r_a, a.w, k)};
        const JointRates<F> rates_b = {LaneVec<F>{} - (b.v + cross(b.w, p.r_b)), LaneVec<F>{} - bend(p.r_b, b.w, k)};
        const LaneVec<F> rope_a = row.place_a - a.dp - (p.r_a - row.arm_a);
        const LaneVec<F> rope_b = row.place_b - b.dp - (p.r_b - row.arm_b);
        row.controls[0].curvature = bend_of_length(rope_a, rates_a, k) + row.ratio * bend_of_length(rope_b, rates_b, k);
        return;
    }
    case RowType::Motor:
    case RowType::Mouse:
    case RowType::Gear: return;
    }
}

/// Curvatures of the joints whose arcs count.
template <class F>
[[gnu::noinline, gnu::flatten]] void bend(JointRow<F>& row, const BodyLanes<F>& a, const BodyLanes<F>& b, const JointConstants<F>& k)
{
    find_curvatures(row, a, b, k);
    for (F& curvature : row.curvature) curvature = curvature * row.arc;
    for (std::size_t i = 0; i < row.control_count; ++i) row.controls[i].curvature = row.controls[i].curvature * row.arc;
}

} // namespace carom::detail
