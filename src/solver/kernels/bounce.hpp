// Restitution of a contact row: which points bounce, how fast they leave, and with which impulses. Before the passes of a step.
#pragma once

#include "solver/kernels/contact_row.hpp"

#include <array>

namespace carom::detail
{

/// How the bodies of a contact fall without it, along its normal.
template <class F>
struct FreeFall
{
    F acceleration = F(0); ///< of B past A by gravity and forces [m/s^2]
    F set_back = F(0);     ///< how much farther apart the velocities' places are than the poses, by continuous collision [m]
};

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

/// 1 where a point meets the other surface within the step, fast enough to bounce; else 0.
template <class F, int N>
F bounces(const ContactRow<F, N>& row, const F& separation, const F& vn, const PassConstants<F>& k)
{
    const auto meets = (vn < -k.restitution_threshold) & (separation + k.reach * vn < F(0)) & (row.restitution > F(0));
    return select(meets, F(1), F(0));
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
        plan.bounces[i] = bounces(row, s, vn, k);
        plan.target[i] = speed_after_bounce(vn, s, row.restitution, fall, k.h);
        plan.count = plan.count + plan.bounces[i];
    }
    return plan;
}

/// Whether any lane has something to plan: most rows that are asked have not.
template <class F, int N>
bool any_bounces(const ContactRow<F, N>& row, const PassConstants<F>& k, const BodyLanes<F>& a, const BodyLanes<F>& b)
{
    F count = F(0);
    for (const PointRow<F>& point : row.points)
    {
        const F s = dot(point.r_b - point.r_a, row.n) + point.adjusted_separation;
        count = count + bounces(row, s, dot(relative_velocity(point, a, b), row.n), k);
    }
    return any(count > F(0));
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
