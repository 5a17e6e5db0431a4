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

/// How the bodies of a contact fall without it, along its normal.
template <class F>
struct FreeFall
{
    F acceleration = F(0); ///< of B past A by gravity and forces [m/s^2]
    F set_back = F(0);     ///< how much farther apart the velocities' places are than the poses, by continuous collision [m]
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

/// The normal velocity at which a point leaves, by Newton's law of restitution: e times the speed at which it meets.
///
/// It meets elsewhere than here: up to the speculative distance ahead, or as far behind as the last step has gone too deep, and the
/// velocity may be that of a place that continuous collision took back. Between here and there it falls with the acceleration a:
///   u^2 = v^2 - 2 a (s + set_back)    at the surface, where v is the speed now
///   w^2 = (e u)^2 + 2 a s             here, so that the point leaves the surface with e u
/// An integrator of velocities first (semi-implicit Euler) has the velocities of the middles of substeps: v = v_n + a h / 2. So a
/// perfect bounce keeps exactly the energy that the integrator keeps, vn^2 / 2 - a s - h a vn / 2; with v = v_n a ball that falls
/// from 5 m at 240 substeps a second would lose 0.8% of its height a bounce. Tests: bounce_test.
template <class F>
F speed_after_bounce(F vn, F separation, F restitution, const FreeFall<F>& fall, F h)
{
    const F half_kick = F(0.5f) * h * fall.acceleration;
    const F v = vn + half_kick;
    const F u2 = lane_max(v * v - F(2) * fall.acceleration * (separation + fall.set_back), F(0));
    const F w2 = lane_max(restitution * restitution * u2 + F(2) * fall.acceleration * separation, F(0));
    const F falling = lane_max(lane_sqrt(w2) - half_kick, F(0));
    return select(fall.acceleration * fall.acceleration > F(0), falling, F(0) - restitution * vn);
}

/// The points of a contact that bounce now, and how fast they shall leave.
template <class F, int N>
struct BouncePlan
{
    std::array<F, N> bounces; ///< 1 or 0
    std::array<F, N> target;  ///< vn to bring about [m/s]
    F count = F(0);
};

template <class F, int N>
BouncePlan<F, N> plan_bounce(const ContactRow<F, N>& row, const PassConstants<F>& k, const FreeFall<F>& fall, const BodyLanes<F>& a,
                             const BodyLanes<F>& b)
{
    BouncePlan<F, N> plan;
    for (std::size_t i = 0; i < N; ++i)
    {
        const PointRow<F>& point = row.points[i];
        const F s = dot(point.r_b - point.r_a, row.n) + point.adjusted_separation;
        const F vn = dot(relative_velocity(point, a, b), row.n);
        const auto meets = (vn < -k.restitution_threshold) & (s + k.reach * vn < F(0)) & (row.restitution > F(0));
        plan.bounces[i] = select(meets, F(1), F(0));
        plan.target[i] = speed_after_bounce(vn, s, row.restitution, fall, k.h);
        plan.count = plan.count + plan.bounces[i];
    }
    return plan;
}

/// How much an impulse along n at one point changes the normal velocity at another.
template <class F, int N>
F coupling(const ContactRow<F, N>& row, const PointRow<F>& i, const PointRow<F>& j)
{
    return dot(row.n, scale(row.inv_mass_a + row.inv_mass_b, row.n)) + row.inv_inertia_a * (cross(i.r_a, row.n) * cross(j.r_a, row.n)) +
           row.inv_inertia_b * (cross(i.r_b, row.n) * cross(j.r_b, row.n));
}

/// The restitution impulses of a face whose two points both bounce, as one linear system: exact, so that a box which lands flat does
/// not begin to turn.
/// @return whether they push both, 1 or 0 lane by lane; else they are not for use
template <class F>
F solve_face(const ContactRow<F, 2>& row, const BouncePlan<F, 2>& plan, const BodyLanes<F>& a, const BodyLanes<F>& b,
             std::array<F, 2>& impulse)
{
    const PointRow<F>& p = row.points[0];
    const PointRow<F>& q = row.points[1];
    const F k_pp = coupling(row, p, p);
    const F k_qq = coupling(row, q, q);
    const F k_pq = coupling(row, p, q);
    const F rhs_p = plan.target[0] - dot(relative_velocity(p, a, b), row.n);
    const F rhs_q = plan.target[1] - dot(relative_velocity(q, a, b), row.n);
    const F det = k_pp * k_qq - k_pq * k_pq;
    const F inv_det = F(1) / lane_max(det, F(1e-30f));
    impulse[0] = (k_qq * rhs_p - k_pq * rhs_q) * inv_det;
    impulse[1] = (k_pp * rhs_q - k_pq * rhs_p) * inv_det;
    const auto one_where = [](const auto& mask) { return select(mask, F(1), F(0)); };
    const F is_solvable = one_where(plan.count > F(1.5f)) * one_where(det > F(1e-4f) * k_pp * k_qq);
    return is_solvable * one_where(impulse[0] > F(0)) * one_where(impulse[1] > F(0));
}

/// Gives the points their speeds.
/// @return the impulse of each point
template <class F, int N>
std::array<F, N> apply_bounce(const ContactRow<F, N>& row, const BouncePlan<F, N>& plan, BodyLanes<F>& a, BodyLanes<F>& b)
{
    std::array<F, N> together = {};
    F is_together = F(0);
    if constexpr (N == 2) is_together = solve_face(row, plan, a, b, together);
    // Otherwise the points push against each other, so they are visited until they agree: each visit takes off 96% of a square's error.
    constexpr int visits = N == 1 ? 1 : 4;
    std::array<F, N> impulse = {};
    for (int visit = 0; visit < visits; ++visit)
    {
        for (std::size_t i = 0; i < N; ++i)
        {
            const PointRow<F>& point = row.points[i];
            const F vn = dot(relative_velocity(point, a, b), row.n);
            const F alone = lane_max(impulse[i] - point.normal_mass * (vn - plan.target[i]), F(0)) * plan.bounces[i];
            const F next = select(is_together > F(0), together[i], alone);
            apply_impulse(row, point, row.n * (next - impulse[i]), a, b);
            impulse[i] = next;
        }
    }
    return impulse;
}

/// Restitution, at the start of a step: a point that meets another surface within the step, faster than the threshold, leaves it at
/// once, with Coulomb friction and rolling resistance under the restitution impulse. That impulse is excluded from warm starting.
///
/// Restitution comes before the passes, since those stop an approach without a bounce and spread its momentum over all bodies that
/// touch: a row of balls that is hit would move on as one. Here each pair collides by itself, again and again until no pair approaches.
/// @return number of points that bounced; 0 when nothing has changed
template <class F, int N>
F bounce(ContactRow<F, N>& row, const PassConstants<F>& k, BodyLanes<F>& a, BodyLanes<F>& b, const FreeFall<F>& fall = {})
{
    const BouncePlan<F, N> plan = plan_bounce(row, k, fall, a, b);
    const std::array<F, N> impulse = apply_bounce(row, plan, a, b);
    const LaneVec<F> t = right_perp(row.n);
    F pressure = F(0);
    for (std::size_t i = 0; i < N; ++i)
    {
        PointRow<F>& point = row.points[i];
        const F vt = dot(relative_velocity(point, a, b), t);
        const F limit = row.friction * impulse[i];
        const F friction = lane_max(-limit, lane_min(F(0) - point.tangent_mass * (vt - row.tangent_speed), limit));
        apply_impulse(row, point, t * friction, a, b);
        point.total_n = point.total_n + impulse[i];
        point.total_t = point.total_t + friction;
        pressure = pressure + impulse[i];
    }
    const F limit = row.rolling_resistance * pressure;
    const F twist = lane_max(-limit, lane_min(F(0) - row.rolling_mass * (b.w - a.w), limit));
    row.rolling_total = row.rolling_total + twist;
    a.w = a.w - row.inv_inertia_a * twist;
    b.w = b.w + row.inv_inertia_b * twist;
    return plan.count;
}

} // namespace carom::detail
