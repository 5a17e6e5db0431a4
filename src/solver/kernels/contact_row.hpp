// The contact row: non-penetration, friction and rolling resistance of one contact, written once for every lane width.
//
//            n                 A pair is always A, B; n points from A to B, t = right_perp(n).
//         B  |                 r_a, r_b: from the centres of mass to the point, fixed over the step
//     -------+----- t          vn = n . dv,  vt = t . dv,  dv = v_b + w_b x r_b - v_a - w_a x r_a
//         A                    impulse P = lambda_n n + lambda_t t acts on B at r_b, and -P on A at r_a
//
// Inverse masses are vectors, one component an axis, so that a body locked on one axis answers exactly on the other:
//   1 / m_n = n . (M_a^-1 + M_b^-1) n + I_a^-1 (r_a x n)^2 + I_b^-1 (r_b x n)^2
// @source E. Catto, "Solver2D", 2024 (soft steps with relaxation)
#pragma once

#include "math/lane_vec.hpp"
#include "solver/kernels/body_lanes.hpp"

#include <array>

namespace carom::detail
{

/// Unknowns and constants of one point.
template <class F>
struct PointRow
{
    LaneVec<F> r_a;
    LaneVec<F> r_b;
    F adjusted_separation; ///< s - n . (r_b - r_a) at the start of the step
    F normal_velocity;     ///< vn at the start of the step
    F normal_mass;         ///< m_n
    F tangent_mass;        ///< m_t
    F lambda_n;            ///< of this substep
    F lambda_t;            ///< of this substep
    F total_n;             ///< over the step so far
    F total_t;             ///< over the step so far
};

/// In the place of a contact's slot where a lane is free.
inline constexpr std::uint32_t no_contact = 0xffffffffu;

/// A contact of `Points` points in each lane.
template <class F, int Points>
struct ContactRow
{
    static constexpr int points_per_contact = Points;

    BodyIndices<F> body_a;
    BodyIndices<F> body_b;
    BodyIndices<F> pushed_a; ///< body_a where its velocity can change, else 0
    BodyIndices<F> pushed_b;
    LaneVec<F> inv_mass_a;
    LaneVec<F> inv_mass_b;
    F inv_inertia_a;
    F inv_inertia_b;
    LaneVec<F> n;
    F core_a; ///< from the points along -n to A's core
    F core_b; ///< from the points along n to B's core
    F friction;
    F restitution;
    F tangent_speed;
    F rolling_resistance;
    F rolling_mass;
    F rolling_lambda;
    F rolling_total;
    F bias_rate; // softness
    F mass_scale;
    F impulse_scale;
    F carried; ///< lambda_c of each point
    std::array<PointRow<F>, Points> points;
    LaneIndices<F> contact; ///< slots: where the lane's results go back to
    bool may_bounce;        ///< whether any lane approaches fast enough to bounce
};

/// What the kernels of a pass share.
template <class F>
struct PassConstants
{
    F inv_h;
    F push_out_speed;
    F restitution_threshold;
    F reach;    ///< how long ahead a meeting bounces now [s]: the step, and a quarter for what speeds up on the way
    F h = F(0); ///< substep [s]
};

template <class F, int N>
void apply_impulse(const ContactRow<F, N>& row, const PointRow<F>& point, const LaneVec<F>& impulse, BodyLanes<F>& a, BodyLanes<F>& b)
{
    a.v = a.v - scale(row.inv_mass_a, impulse);
    a.w = a.w - row.inv_inertia_a * cross(point.r_a, impulse);
    b.v = b.v + scale(row.inv_mass_b, impulse);
    b.w = b.w + row.inv_inertia_b * cross(point.r_b, impulse);
}

/// dv at the point.
template <class F>
LaneVec<F> relative_velocity(const PointRow<F>& point, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    return (b.v + cross(b.w, point.r_b)) - (a.v + cross(a.w, point.r_a));
}

/// How far the surfaces are apart now. What turns with a body is its core, the corners and edges that its rounding surrounds; the rounding
/// is under the point whichever way the body has turned:
///   s = n . (way of B's core - way of A's core) + s_0,  a core k away along n:  n . dq (r + k n) = n . dq r + k c
/// With the whole of r turned, a ball that rolls by theta in a step would seem to rise by R (1 - cos theta), and sink by as much.
template <class F, int N>
F separation(const ContactRow<F, N>& row, const PointRow<F>& point, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    const LaneVec<F> way = (b.dp + rotate(b.dq, point.r_b)) - (a.dp + rotate(a.dq, point.r_a));
    const F under_the_point = row.core_a * (a.dq.c - F(1)) + row.core_b * (b.dq.c - F(1));
    return dot(way, row.n) + under_the_point + point.adjusted_separation;
}

/// 1 / k, and 0 of what nothing can move.
template <class F>
F mass_of(F k)
{
    return select(k > F(0), F(1) / k, F(0));
}

/// 1 / m along a direction u at a point.
template <class F, int N>
F inverse_mass_along(const ContactRow<F, N>& row, const PointRow<F>& point, const LaneVec<F>& u)
{
    const LaneVec<F> inv_mass = row.inv_mass_a + row.inv_mass_b;
    const F arm_a = cross(point.r_a, u);
    const F arm_b = cross(point.r_b, u);
    return inv_mass.x * u.x * u.x + inv_mass.y * u.y * u.y + row.inv_inertia_a * arm_a * arm_a + row.inv_inertia_b * arm_b * arm_b;
}

/// What follows from bodies, normal and points of a row that has just been filled, when `adjusted_separation` is still the separation.
template <class F, int N>
void prepare(ContactRow<F, N>& row, const PassConstants<F>& k, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    row.rolling_mass = mass_of(row.inv_inertia_a + row.inv_inertia_b);
    row.may_bounce = false;
    for (PointRow<F>& point : row.points)
    {
        point.adjusted_separation = point.adjusted_separation - dot(point.r_b - point.r_a, row.n);
        point.normal_velocity = dot(relative_velocity(point, a, b), row.n);
        point.normal_mass = mass_of(inverse_mass_along(row, point, row.n));
        point.tangent_mass = mass_of(inverse_mass_along(row, point, right_perp(row.n)));
        // Or nearly fast enough: the kernel decides.
        const auto is_fast = point.normal_velocity < F(-0.99f) * k.restitution_threshold;
        row.may_bounce = row.may_bounce || any(is_fast & (row.restitution > F(0)));
    }
}

/// Applies the impulses of the substep before.
template <class F, int N>
void warm_start(const ContactRow<F, N>& row, BodyLanes<F>& a, BodyLanes<F>& b)
{
    const LaneVec<F> t = right_perp(row.n);
    for (const PointRow<F>& point : row.points) apply_impulse(row, point, row.n * point.lambda_n + t * point.lambda_t, a, b);
    a.w = a.w - row.inv_inertia_a * row.rolling_lambda;
    b.w = b.w + row.inv_inertia_b * row.rolling_lambda;
}

/// Non-penetration: s >= 0, lambda_n >= 0, complementary. With the separation at the end of the substep s + h vn:
///   apart (s > 0):     lambda_n = max(lambda_n - m_n (vn + s / h), 0)          stops the body at the surface, not before
///   overlapping:       lambda_n = max(lambda_n - m_n mu (vn + max(beta s, -push out)) - gamma (lambda_n - lambda_c), 0)
/// A spring alone would sag under a load by gamma lambda_n / (m_n mu beta); lambda_c, what the contact has been carrying, is what
/// its rest length is corrected for.
/// The relaxing pass has no bias against overlap and is rigid: it takes back the speed that the push added.
template <bool WithBias, class F, int N>
void solve_normal(const ContactRow<F, N>& row, PointRow<F>& point, const PassConstants<F>& k, BodyLanes<F>& a, BodyLanes<F>& b)
{
    const F s = separation(row, point, a, b);
    const auto is_apart = s > F(0);

    F bias = select(is_apart, s * k.inv_h, F(0));
    F mass_scale = F(1);
    F impulse_scale = F(0);
    if constexpr (WithBias)
    {
        bias = select(is_apart, bias, lane_max(row.bias_rate * s, -k.push_out_speed));
        mass_scale = select(is_apart, F(1), row.mass_scale);
        impulse_scale = select(is_apart, F(0), row.impulse_scale);
    }

    const F vn = dot(relative_velocity(point, a, b), row.n);
    const F give = impulse_scale * (point.lambda_n - row.carried);
    const F next = lane_max(point.lambda_n - point.normal_mass * mass_scale * (vn + bias) - give, F(0));
    const F change = next - point.lambda_n;
    point.lambda_n = next;
    apply_impulse(row, point, row.n * change, a, b);
}

/// Coulomb friction: |lambda_t| <= mu lambda_n, against the slip beyond the surfaces' own speed.
template <class F, int N>
void solve_friction(const ContactRow<F, N>& row, PointRow<F>& point, BodyLanes<F>& a, BodyLanes<F>& b)
{
    const LaneVec<F> t = right_perp(row.n);
    const F vt = dot(relative_velocity(point, a, b), t);
    const F limit = row.friction * point.lambda_n;
    const F next = lane_max(-limit, lane_min(point.lambda_t - point.tangent_mass * (vt - row.tangent_speed), limit));
    const F change = next - point.lambda_t;
    point.lambda_t = next;
    apply_impulse(row, point, t * change, a, b);
}

/// Rolling resistance: |lambda_r| <= c lambda_n, against relative spin.
template <class F, int N>
void solve_rolling(ContactRow<F, N>& row, BodyLanes<F>& a, BodyLanes<F>& b)
{
    F pressure = F(0);
    for (const PointRow<F>& point : row.points) pressure = pressure + point.lambda_n;
    const F limit = row.rolling_resistance * pressure;
    const F next = lane_max(-limit, lane_min(row.rolling_lambda - row.rolling_mass * (b.w - a.w), limit));
    const F change = next - row.rolling_lambda;
    row.rolling_lambda = next;
    a.w = a.w - row.inv_inertia_a * change;
    b.w = b.w + row.inv_inertia_b * change;
}

/// The biased pass of a substep.
template <class F, int N>
void solve(ContactRow<F, N>& row, const PassConstants<F>& k, BodyLanes<F>& a, BodyLanes<F>& b)
{
    for (PointRow<F>& point : row.points) solve_normal<true>(row, point, k, a, b);
}

/// The relaxing pass of a substep. Non-penetration comes first: it takes back what the bias pushed, and friction and rolling are
/// limited by the load that is left, not by the push.
template <class F, int N>
void relax(ContactRow<F, N>& row, const PassConstants<F>& k, BodyLanes<F>& a, BodyLanes<F>& b)
{
    for (PointRow<F>& point : row.points) solve_normal<false>(row, point, k, a, b);
    for (PointRow<F>& point : row.points) solve_friction(row, point, a, b);
    solve_rolling(row, a, b);

    row.rolling_total = row.rolling_total + row.rolling_lambda;
    for (PointRow<F>& point : row.points)
    {
        point.total_n = point.total_n + point.lambda_n;
        point.total_t = point.total_t + point.lambda_t;
    }
}

} // namespace carom::detail
