// The joint row: what every joint is made of, written once for every lane width. How its parts are solved is in joint_solve.hpp, what a joint of
// a type holds in joint_kernels.hpp.
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

} // namespace carom::detail
