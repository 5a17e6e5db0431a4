// The joint row: what every joint is made of, written once for every lane width. What a joint of a type holds is in joint_kernels.hpp.
//
// A joint has up to three rigid rows C_i = 0 and up to two coordinates q_i (an angle, a way, a length), each with a spring, a motor and a
// range of its own; one that pulls to a place has a drive besides. A row's Jacobian J gives the rate of C or q at fixed positions:
//   J v = l_b . v_b + s_b w_b - l_a . v_a - s_a w_a          an impulse lambda pushes B by lambda l_b and turns it by lambda s_b
//
// Bodies move on arcs, so over a substep h the error changes by more than h J v. What is missing is the row's `curvature`:
//   (C(x + h v) - C(x)) / h = J v + curvature
// With it, the biased pass puts the error at the end of the substep to zero and the relaxing pass makes the velocity fit the place that was
// reached: two half-steps that mirror each other. A pendulum then keeps its energy, where J v = 0 alone would brake it by w^2 h a second.
// @source H. C. Andersen, "Rattle", 1983 (position and velocity constraints); E. Catto, "Solver2D", 2024 (soft steps with relaxation)
#pragma once

#include "math/lane_vec.hpp"
#include "solver/kernels/body_lanes.hpp"

#include <cstddef>
#include <cstdint>

namespace carom::detail
{

/// Most rows that one joint holds rigidly: x, y and the angle of a weld.
inline constexpr std::size_t most_rigid = 3;
/// Most coordinates that one joint limits, drives or springs: the slide and the angle of a wheel.
inline constexpr std::size_t most_controls = 2;

/// In the order of the alternatives of JointSpec.
enum class RowType : std::uint32_t
{
    Revolute,
    Prismatic,
    Distance,
    Weld,
    Wheel,
    Motor,
    Mouse,
    Gear,
    Pulley
};

/// So many of something. An array of its own for each lane type, so that its functions are too.
template <class T, std::size_t Count>
struct LaneList
{
    T at[Count];

    T& operator[](std::size_t i) { return at[i]; }
    const T& operator[](std::size_t i) const { return at[i]; }
    T* begin() { return at; }
    T* end() { return at + Count; }
};

/// Something for each rigid row.
template <class F>
using RigidList = LaneList<F, most_rigid>;

template <class F>
struct Jacobian
{
    LaneVec<F> l_a;
    LaneVec<F> l_b;
    F s_a;
    F s_b;
};

/// A damped spring of a joint, over one substep. With x the deflection before the substep and v the velocity after:
///   lambda = -m h (omega^2 (x + theta h v) + 2 zeta omega v)
/// theta = 0 takes the force where the substep begins: an undamped spring then swings for ever, as it should, but too stiff a one blows up.
/// theta = 1 takes it where the substep ends: stable at any stiffness, and it brakes. Springs are taken at the beginning up to
/// omega h = 0.5 (19 Hz at 240 substeps a second), where that is safe, and then more and more at the end. Solved for lambda:
///   change = -m (damping J v + push x) - impulse_scale lambda
template <class F>
struct SpringRow
{
    F damping;       ///< s / (1 + s), s = h (theta h omega^2 + 2 zeta omega)
    F push;          ///< h omega^2 / (1 + s) [1/s]
    F impulse_scale; ///< 1 / (1 + s)
};

/// A coordinate and what acts on it. Parts that a joint does not have are zero and do nothing.
template <class F>
struct ControlRow
{
    Jacobian<F> j;
    F q;                   ///< where it is
    F curvature;           ///< see above
    F mass;                ///< 1 / (J M^-1 J^T): of the spring, whose hertz count without the joint's rigid rows
    F held_mass;           ///< of the motor and the range: what an impulse moves while the rigid rows hold
    RigidList<F> reaction; ///< of the rigid rows, to an impulse of 1
    F lower;
    F upper;
    F lambda_lower;
    F lambda_upper;
    F target; ///< of the spring
    SpringRow<F> spring;
    F max_spring; ///< [N s] in a substep
    F lambda_spring;
    F motor_speed;
    F max_motor; ///< [N s] in a substep
    F lambda_motor;
};

/// A soft pull of a point to a place, of limited size.
template <class F>
struct DriveRow
{
    LaneVec<F> error; ///< where B's point is past its place [m]
    SpringRow<F> spring;
    F max_lambda; ///< [N s] in a substep
    LaneVec<F> lambda;
};

/// A joint in each lane, all of one type. In memory a row ends before the parts that its joints do not have: see row_bytes.
template <class F>
struct JointRow
{
    RowType type;
    std::uint32_t rigid_count;
    std::uint32_t control_count;
    bool has_drive;
    bool has_ends; ///< whether coordinates have motors or ranges

    BodyIndices<F> body_a;
    BodyIndices<F> body_b;
    BodyIndices<F> pushed_a; ///< body_a where its velocity can change, else 0
    BodyIndices<F> pushed_b;
    LaneIndices<F> joint; ///< where the lane's results go back to
    LaneVec<F> inv_mass_a;
    LaneVec<F> inv_mass_b;
    F inv_inertia_a;
    F inv_inertia_b;
    F arc; ///< 1 where the curvature counts; 0 in a rope that bears a load (heavy_load)

    // At the start of the step.
    LaneVec<F> arm_a;  ///< from A's centre of mass to the origin of frame A [m]
    LaneVec<F> arm_b;  ///< from B's to that of frame B [m]
    LaneVec<F> apart;  ///< from the origin of frame A to that of frame B [m]
    LaneVec<F> axis;   ///< x axis of frame A
    LaneRot<F> facing; ///< of frame B, seen from frame A
    /// Motor joint: the offset, turned into the world. Pulley: from A's point to its ground point. Gear: the slide axis of A.
    LaneVec<F> place_a;
    LaneVec<F> place_b; ///< pulley and gear: the same of B
    F turn;             ///< angle of frame B in frame A over full turns [rad]; before find_turn() any angle on the same turn
    F length;           ///< distance joint [m]
    F ratio;            ///< gear and pulley
    F slip;             ///< gear: q_a + ratio q_b
    F turns_a;          ///< gear: 1 where the motion of A is its turn, 0 where it is a slide
    F turns_b;

    // As of the last linearisation.
    LaneVec<F> r_b; ///< arm of the point about which force and torque are told
    RigidList<Jacobian<F>> rigid;
    RigidList<F> error;
    RigidList<F> curvature;

    RigidList<F> lambda;      ///< of this substep
    LaneVec<F> total_impulse; ///< on B over the step so far
    F total_twist;            ///< about the origin of frame B

    DriveRow<F> drive;
    LaneList<ControlRow<F>, most_controls> controls;
};

/// How much of a row lies in memory.
template <class F>
constexpr std::size_t row_bytes(std::size_t control_count, bool has_drive)
{
    const std::size_t behind = sizeof(DriveRow<F>) + most_controls * sizeof(ControlRow<F>);
    if (control_count > 0) return sizeof(JointRow<F>) - (most_controls - control_count) * sizeof(ControlRow<F>);
    return sizeof(JointRow<F>) - behind + (has_drive ? sizeof(DriveRow<F>) : 0);
}

/// What the kernels of a pass share.
template <class F>
struct JointConstants
{
    F h;
    F inv_h;
    F bias_rate;     ///< at which rigid rows undo their error [1/s]
    F mass_scale;    ///< of rigid rows that are solved one by one
    F impulse_scale; ///< of the same
    F length_unit;   ///< of the world [m]
};

template <class F>
JointConstants<F> widened(const JointConstants<float>& k)
{
    return {F(k.h), F(k.inv_h), F(k.bias_rate), F(k.mass_scale), F(k.impulse_scale), F(k.length_unit)};
}

template <class F>
F velocity(const Jacobian<F>& j, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    return dot(j.l_b, b.v) + j.s_b * b.w - dot(j.l_a, a.v) - j.s_a * a.w;
}

template <class F>
void apply(const JointRow<F>& row, const Jacobian<F>& j, F lambda, BodyLanes<F>& a, BodyLanes<F>& b)
{
    a.v = a.v - scale(row.inv_mass_a, j.l_a * lambda);
    a.w = a.w - row.inv_inertia_a * (j.s_a * lambda);
    b.v = b.v + scale(row.inv_mass_b, j.l_b * lambda);
    b.w = b.w + row.inv_inertia_b * (j.s_b * lambda);
}

/// J_i M^-1 J_k^T: how much an impulse along row k changes the velocity of row i.
template <class F>
F coupling(const JointRow<F>& row, const Jacobian<F>& i, const Jacobian<F>& k)
{
    return dot(i.l_a, scale(row.inv_mass_a, k.l_a)) + row.inv_inertia_a * (i.s_a * k.s_a) + dot(i.l_b, scale(row.inv_mass_b, k.l_b)) +
           row.inv_inertia_b * (i.s_b * k.s_b);
}

template <class F>
F inverse_or_zero(F k)
{
    return select(k > F(0), F(1) / lane_max(k, F(1e-30f)), F(0));
}

/// Keeps the rows of one joint apart where locks leave its bodies fewer ways to move than it has rows: a share of the diagonal of K.
inline constexpr float row_softness = 1e-5f;

/// The impulses of the rigid rows that change their velocities by `x`: K impulses = x, by elimination in their order.
template <class F>
RigidList<F> impulses_for(const JointRow<F>& row, RigidList<F> x)
{
    const std::size_t count = row.rigid_count;
    RigidList<RigidList<F>> m;
    for (std::size_t i = 0; i < count; ++i)
    {
        for (std::size_t j = 0; j < count; ++j) m[i][j] = coupling(row, row.rigid[i], row.rigid[j]);
        m[i][i] = m[i][i] * F(1 + row_softness);
    }
    for (std::size_t i = 0; i < count; ++i)
    {
        const F inv = inverse_or_zero(m[i][i]);
        for (std::size_t j = i + 1; j < count; ++j)
        {
            const F f = m[j][i] * inv;
            for (std::size_t l = i; l < count; ++l) m[j][l] = m[j][l] - f * m[i][l];
            x[j] = x[j] - f * x[i];
        }
    }
    for (std::size_t i = count; i-- > 0;)
    {
        for (std::size_t l = i + 1; l < count; ++l) x[i] = x[i] - m[i][l] * x[l];
        x[i] = x[i] * inverse_or_zero(m[i][i]);
    }
    return x;
}

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
