// How the parts of a joint row are solved: springs, motors, ranges and drives one after the other, rigid rows together.
#pragma once

#include "solver/kernels/joint_row.hpp"

namespace carom::detail
{

/// A motor or an end moves the bodies as far as the rigid rows let it: a bar that is pinned at its end is four times as hard to turn. Where the
/// rows leave it less than this share of its freedom, it counts as this share: joints that contradict each other would throw the bodies about.
inline constexpr float least_freedom = 0.01f;

/// Mass and reactions of a coordinate while the rigid rows hold.
template <class F>
void find_held_mass(const JointRow<F>& row, ControlRow<F>& c)
{
    RigidList<F> couplings = {};
    for (std::size_t i = 0; i < row.rigid_count; ++i) couplings[i] = coupling(row, row.rigid[i], c.j);
    c.reaction = impulses_for(row, couplings);
    const F free = coupling(row, c.j, c.j);
    F held = free;
    for (std::size_t i = 0; i < row.rigid_count; ++i) held = held - couplings[i] * c.reaction[i];
    c.held_mass = inverse_or_zero(lane_max(held, F(least_freedom) * free));
}

/// Applies an impulse of a motor or an end, and what the rigid rows answer.
template <class F>
void apply_held(JointRow<F>& row, const ControlRow<F>& c, F lambda, BodyLanes<F>& a, BodyLanes<F>& b)
{
    apply(row, c.j, lambda, a, b);
    for (std::size_t i = 0; i < row.rigid_count; ++i)
    {
        const F answer = F(0) - c.reaction[i] * lambda;
        row.lambda[i] = row.lambda[i] + answer;
        apply(row, row.rigid[i], answer, a, b);
    }
}

template <class F>
void apply_drive(const JointRow<F>& row, const LaneVec<F>& r_a, const LaneVec<F>& impulse, BodyLanes<F>& a, BodyLanes<F>& b)
{
    a.v = a.v - scale(row.inv_mass_a, impulse);
    a.w = a.w - row.inv_inertia_a * cross(r_a, impulse);
    b.v = b.v + scale(row.inv_mass_b, impulse);
    b.w = b.w + row.inv_inertia_b * cross(row.r_b, impulse);
}

/// From A's centre of mass to B's point, which is its place plus the error. A is pushed there as B is, so that the pair keeps its angular momentum.
template <class F>
LaneVec<F> reach_of_a(const JointRow<F>& row, const BodyLanes<F>& a)
{
    return rotate(a.dq, row.arm_a + row.place_a) + row.drive.error;
}

/// Applies the impulses of the substep before.
template <class F>
void warm_start(JointRow<F>& row, BodyLanes<F>& a, BodyLanes<F>& b)
{
    for (std::size_t i = 0; i < row.rigid_count; ++i) apply(row, row.rigid[i], row.lambda[i], a, b);
    for (std::size_t i = 0; i < row.control_count; ++i)
    {
        const ControlRow<F>& c = row.controls[i];
        apply(row, c.j, c.lambda_spring + c.lambda_motor + c.lambda_lower - c.lambda_upper, a, b);
    }
    if (row.has_drive) apply_drive(row, reach_of_a(row, a), row.drive.lambda, a, b);
}

/// A damped spring: see SpringRow. Solved in the biased pass alone: the relaxing pass takes back pushes against errors, and a spring's force is
/// none of those.
template <class F>
void solve_spring(const JointRow<F>& row, ControlRow<F>& c, BodyLanes<F>& a, BodyLanes<F>& b)
{
    const F pull = c.mass * (c.spring.damping * velocity(c.j, a, b) + c.spring.push * (c.q - c.target));
    const F wanted = c.lambda_spring - pull - c.spring.impulse_scale * c.lambda_spring;
    const F next = lane_max(-c.max_spring, lane_min(wanted, c.max_spring));
    apply(row, c.j, next - c.lambda_spring, a, b);
    c.lambda_spring = next;
}

/// Rate of a coordinate once the joint's rigid rows hold. What a blow has just done to these rows is for them to undo: an end that answered it too
/// would drive them on, and they the end, until a light limb under a heavy pile flies apart. Test:
/// JointRow.AnEndAddsNoEnergyWhateverABlowDidToThePin.
template <class F>
F held_velocity(const JointRow<F>& row, const ControlRow<F>& c, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    F rate = velocity(c.j, a, b);
    for (std::size_t i = 0; i < row.rigid_count; ++i) rate = rate - c.reaction[i] * velocity(row.rigid[i], a, b);
    return rate;
}

/// |lambda| <= max, against the velocity that is missing.
template <class F>
void solve_motor(JointRow<F>& row, ControlRow<F>& c, BodyLanes<F>& a, BodyLanes<F>& b)
{
    const F wanted = c.lambda_motor - c.held_mass * (held_velocity(row, c, a, b) - c.motor_speed);
    const F next = lane_max(-c.max_motor, lane_min(wanted, c.max_motor));
    const F change = next - c.lambda_motor;
    c.lambda_motor = next;
    apply_held(row, c, change, a, b);
}

/// Most speed at which an error is undone [length units/s], [rad/s]: joints that are made far from closed come together, they do not snap.
inline constexpr float max_bias = 4;

/// Most speed at which a row undoes its error: max_bias length units of the world a second where it moves B along a line, max_bias rad/s where it
/// only turns it.
template <class F>
F most_bias(const Jacobian<F>& j, const JointConstants<F>& k)
{
    return F(max_bias) * select(dot(j.l_b, j.l_b) > F(0), k.length_unit, F(1));
}

/// What a row that may only push has to undo: C / h while it is apart, so that it stops at its end and not before; beyond, a share of the
/// error at a bounded speed, in the biased pass.
template <bool WithBias, class F>
F limit_bias(F c, F most, const JointConstants<F>& k)
{
    const F beyond = WithBias ? lane_max(k.bias_rate * c, F(0) - most) : F(0);
    return select(c > F(0), c * k.inv_h, beyond);
}

/// How much of its impulse an end lets go in each biased pass while it is exceeded. Without, the ends of a body that lies across others (a ragdoll
/// on its stretched legs) push each other to and fro, and it never falls asleep.
inline constexpr float end_leak = 0.01f;

/// The impulse of an end: lambda >= 0, complementary to c >= 0.
/// @param c    how far the coordinate is from the end [m] or [rad]
/// @param rate at which that becomes more [m/s] or [rad/s]
template <bool WithBias, class F>
F end_impulse(F lambda, F mass, F c, F rate, F most, const JointConstants<F>& k)
{
    const F leak = WithBias ? select(c > F(0), F(0), F(end_leak)) : F(0);
    return lane_max(lambda - mass * (rate + limit_bias<WithBias>(c, most, k)) - leak * lambda, F(0));
}

/// lower <= q <= upper.
template <bool WithBias, class F>
void solve_range(JointRow<F>& row, ControlRow<F>& c, const JointConstants<F>& k, BodyLanes<F>& a, BodyLanes<F>& b)
{
    const F curvature = WithBias ? c.curvature : F(0);
    const F most = most_bias(c.j, k);
    const F lower = end_impulse<WithBias>(c.lambda_lower, c.held_mass, c.q - c.lower, held_velocity(row, c, a, b) + curvature, most, k);
    apply_held(row, c, lower - c.lambda_lower, a, b);
    c.lambda_lower = lower;

    const F upper =
        end_impulse<WithBias>(c.lambda_upper, c.held_mass, c.upper - c.q, F(0) - held_velocity(row, c, a, b) - curvature, most, k);
    apply_held(row, c, c.lambda_upper - upper, a, b);
    c.lambda_upper = upper;
}

/// A spring in the plane, of limited size, at B's point.
template <class F>
void solve_drive(JointRow<F>& row, BodyLanes<F>& a, BodyLanes<F>& b)
{
    DriveRow<F>& d = row.drive;
    const LaneVec<F> r_a = reach_of_a(row, a);
    const LaneVec<F> dv = (b.v + cross(b.w, row.r_b)) - (a.v + cross(a.w, r_a));
    const LaneVec<F> wanted = dv * d.spring.damping + d.error * d.spring.push;
    const F xx = row.inv_mass_a.x + row.inv_mass_b.x + row.inv_inertia_a * r_a.y * r_a.y + row.inv_inertia_b * row.r_b.y * row.r_b.y;
    const F yy = row.inv_mass_a.y + row.inv_mass_b.y + row.inv_inertia_a * r_a.x * r_a.x + row.inv_inertia_b * row.r_b.x * row.r_b.x;
    const F xy = -row.inv_inertia_a * r_a.x * r_a.y - row.inv_inertia_b * row.r_b.x * row.r_b.y;
    const F inv_det = inverse_or_zero(xx * yy - xy * xy);
    const LaneVec<F> push = {(yy * wanted.x - xy * wanted.y) * inv_det, (xx * wanted.y - xy * wanted.x) * inv_det};
    LaneVec<F> next = d.lambda - push - d.lambda * d.spring.impulse_scale;
    const F size = lane_sqrt(dot(next, next));
    next = next * select(size > d.max_lambda, d.max_lambda / lane_max(size, F(1e-30f)), F(1));
    apply_drive(row, r_a, next - d.lambda, a, b);
    d.lambda = next;
}

/// The speed at which a rigid row undoes its error.
template <class F>
F bias_of(const JointRow<F>& row, std::size_t i, const JointConstants<F>& k)
{
    const F most = most_bias(row.rigid[i], k);
    return lane_max(F(0) - most, lane_min(k.bias_rate * row.error[i], most));
}

/// A soft row holds lambda = m (mass_scale / impulse_scale) bias when it is at rest. A bias that is bounded would bound lambda too, and a net that carries
/// more would tear on and on: the scale of the impulse follows the bias, so that lambda is that of the whole error.
/// @return the share of its bias that a row is left by most_bias
template <class F>
F bias_share(const JointRow<F>& row, std::size_t i, const JointConstants<F>& k)
{
    const F wanted = k.bias_rate * row.error[i];
    const F size = lane_max(wanted, F(0) - wanted);
    const F most = most_bias(row.rigid[i], k);
    return most / lane_max(size, most);
}

/// The joint's rigid rows together, apart from those of other joints, in the biased or the relaxing pass.
template <bool WithBias, class F>
[[gnu::noinline, gnu::flatten]] void solve_rigid(JointRow<F>& row, const JointConstants<F>& k, BodyLanes<F>& a, BodyLanes<F>& b)
{
    RigidList<F> missing = {};
    for (std::size_t i = 0; i < row.rigid_count; ++i)
    {
        missing[i] = -velocity(row.rigid[i], a, b);
        if constexpr (WithBias) missing[i] = missing[i] - row.curvature[i] - bias_of(row, i, k);
    }
    const RigidList<F> x = impulses_for(row, missing);
    for (std::size_t i = 0; i < row.rigid_count; ++i)
    {
        F change = x[i];
        if constexpr (WithBias)
        {
            const F share = bias_share(row, i, k);
            const F mass_scale = k.mass_scale + (F(1) - share) * k.impulse_scale;
            change = mass_scale * change - share * k.impulse_scale * row.lambda[i];
        }
        row.lambda[i] = row.lambda[i] + change;
        apply(row, row.rigid[i], change, a, b);
    }
}

/// One pass over what is soft or one-sided.
template <bool WithBias, class F>
[[gnu::noinline, gnu::flatten]] void solve_controls(JointRow<F>& row, const JointConstants<F>& k, BodyLanes<F>& a, BodyLanes<F>& b)
{
    if (WithBias && row.has_drive) solve_drive(row, a, b);
    for (std::size_t i = 0; i < row.control_count; ++i)
    {
        ControlRow<F>& c = row.controls[i];
        if constexpr (WithBias) solve_spring(row, c, a, b);
        if (!row.has_ends) continue;
        solve_motor(row, c, a, b);
        solve_range<WithBias>(row, c, k, a, b);
    }
}

/// One pass over a joint by itself: what is soft first, what is rigid last.
template <bool WithBias, class F>
void solve(JointRow<F>& row, const JointConstants<F>& k, BodyLanes<F>& a, BodyLanes<F>& b)
{
    solve_controls<WithBias>(row, k, a, b);
    if (row.rigid_count > 0) solve_rigid<WithBias>(row, k, a, b);
}

/// Adds what the substep gave to the sums over the step.
template <class F>
void sum_up(JointRow<F>& row)
{
    const auto add = [&](const Jacobian<F>& j, F lambda)
    {
        row.total_impulse = row.total_impulse + j.l_b * lambda;
        row.total_twist = row.total_twist + lambda * (j.s_b - cross(row.r_b, j.l_b));
    };
    for (std::size_t i = 0; i < row.rigid_count; ++i) add(row.rigid[i], row.lambda[i]);
    for (std::size_t i = 0; i < row.control_count; ++i)
    {
        const ControlRow<F>& c = row.controls[i];
        add(c.j, c.lambda_spring + c.lambda_motor + c.lambda_lower - c.lambda_upper);
    }
    if (row.has_drive) row.total_impulse = row.total_impulse + row.drive.lambda;
}

} // namespace carom::detail
