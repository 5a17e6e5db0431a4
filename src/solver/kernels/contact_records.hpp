// Between contacts as they are stored and their rows. Contacts are records of floats: each of the groups of eight that a row needs is one transpose.
#pragma once

#include "math/lane_records.hpp"
#include "solver/kernels/contact_row.hpp"

#include <cstddef>

namespace carom::detail
{

/// Where a ContactManifold holds what kernels read and write [floats].
struct ManifoldFloats
{
    static constexpr std::size_t arms = 0;
    static constexpr std::size_t normal = 8;
    static constexpr std::size_t rolling = 14;
    static constexpr std::size_t impulses = 16;
    static constexpr std::size_t all = 32;
    static constexpr std::size_t has_result = 124; ///< [bytes]
};

/// Results as kernels see them, in the order of ContactResult; the last float is free.
inline constexpr std::size_t result_floats = 8;

/// Masses as kernels see them: inverse masses along x and y, inverse inertia, and one float that no kernel reads.
inline constexpr std::size_t mass_floats = 4;

/// See Softness.
template <class F>
struct SoftnessLanes
{
    F bias_rate;
    F mass_scale;
    F impulse_scale;
};

/// What filling shares between rows.
template <class F>
struct FillConstants
{
    F warm_scale;  ///< from the last step's impulses to the first guess of this step's
    F whirl_speed; ///< from which on a body meets others as a disc would [rad/s]
    SoftnessLanes<F> between_dynamic;
    SoftnessLanes<F> with_static;
};

/// What storing impulses shares between rows.
template <class F>
struct StoreConstants
{
    F carried_part;   ///< how much of a lasting load is carried
    F carry_share;    ///< weight of this step's load in its running mean
    F calm_share;     ///< the same between bodies at rest
    F settled_within; ///< see Tolerances [m]
};

/// Velocities and masses of a row's bodies at the start of a step.
template <class F>
struct RowBodies
{
    BodyLanes<F> a;
    BodyLanes<F> b;
    FourLanes<F> mass_a; ///< see mass_floats
    FourLanes<F> mass_b;
};

/// The arm of a point on a disc: straight towards what it touches.
template <class F>
LaneVec<F> arm_of_disc(const LaneVec<F>& r, const LaneVec<F>& n)
{
    return n * dot(r, n);
}

/// A body that whirls is everywhere around its centre at once. At its corner as it happens to be, its spin may seem to take it away from what it
/// runs into. Test: bullets_test.
template <class F, int N>
void round_off(ContactRow<F, N>& row, const RowBodies<F>& bodies, const F& whirl_speed)
{
    const F fast = whirl_speed * whirl_speed;
    const auto a_whirls = bodies.a.w * bodies.a.w > fast;
    const auto b_whirls = bodies.b.w * bodies.b.w > fast;
    const auto choose = [](const auto& mask, const LaneVec<F>& yes, const LaneVec<F>& no) -> LaneVec<F>
    { return {select(mask, yes.x, no.x), select(mask, yes.y, no.y)}; };
    if (any(a_whirls))
    {
        row.core_a = select(a_whirls, dot(row.points[0].r_a, row.n), row.core_a);
        for (PointRow<F>& point : row.points) point.r_a = choose(a_whirls, arm_of_disc(point.r_a, row.n), point.r_a);
    }
    if (any(b_whirls))
    {
        row.core_b = select(b_whirls, -dot(row.points[0].r_b, row.n), row.core_b);
        for (PointRow<F>& point : row.points) point.r_b = choose(b_whirls, arm_of_disc(point.r_b, row.n), point.r_b);
    }
}

/// Writes a point as it is in the records; `adjusted_separation` is the separation until prepare().
template <class F>
void fill_point(PointRow<F>& point, const LaneVec<F>& r_a, const LaneVec<F>& r_b, const F& separation, const F& lambda_n, const F& lambda_t)
{
    point.r_a = r_a;
    point.r_b = r_b;
    point.adjusted_separation = separation;
    point.lambda_n = lambda_n;
    point.lambda_t = lambda_t;
    point.total_n = point.total_t = F(0);
}

/// Twice as stiff against what nothing can push.
template <class F, int N>
void choose_softness(ContactRow<F, N>& row, const FillConstants<F>& k)
{
    const auto are_movable = (row.inv_mass_a.x + row.inv_mass_a.y > F(0)) & (row.inv_mass_b.x + row.inv_mass_b.y > F(0));
    row.bias_rate = select(are_movable, k.between_dynamic.bias_rate, k.with_static.bias_rate);
    row.mass_scale = select(are_movable, k.between_dynamic.mass_scale, k.with_static.mass_scale);
    row.impulse_scale = select(are_movable, k.between_dynamic.impulse_scale, k.with_static.impulse_scale);
}

/// Fills a row but for its contacts and `body_a`, `body_b`, which stand in it already.
/// @param manifolds of its contacts; zeros for free lanes
template <class F, int N>
void fill(ContactRow<F, N>& row, const LaneRecords<F, const float>& manifolds, const RowBodies<F>& bodies, const FillConstants<F>& fill_k,
          const PassConstants<F>& k)
{
    const FourLanes<F>& mass_a = bodies.mass_a;
    const FourLanes<F>& mass_b = bodies.mass_b;
    row.pushed_a = indices_where(mass_a.f0 + mass_a.f1 + mass_a.f2 > F(0), row.body_a);
    row.pushed_b = indices_where(mass_b.f0 + mass_b.f1 + mass_b.f2 > F(0), row.body_b);
    row.inv_mass_a = {mass_a.f0, mass_a.f1};
    row.inv_mass_b = {mass_b.f0, mass_b.f1};
    row.inv_inertia_a = mass_a.f2;
    row.inv_inertia_b = mass_b.f2;
    choose_softness(row, fill_k);

    const EightLanes<F> normal =
        gather_eight(manifolds, ManifoldFloats::normal); // x, y, separations, roundings, rolling and carried impulse
    const F gap = F(0.5f) * normal.f2;                   // points are halfway between the surfaces
    row.n = {normal.f0, normal.f1};
    row.core_a = normal.f4 + gap;
    row.core_b = normal.f5 + gap;
    row.rolling_lambda = fill_k.warm_scale * normal.f6;
    row.rolling_total = F(0);
    row.carried = fill_k.warm_scale * normal.f7;

    const EightLanes<F> impulses = gather_eight(manifolds, ManifoldFloats::impulses); // of the points, and the surface
    row.friction = impulses.f4;
    row.restitution = impulses.f5;
    row.rolling_resistance = impulses.f6;
    row.tangent_speed = impulses.f7;

    const EightLanes<F> arms = gather_eight(manifolds, ManifoldFloats::arms);
    fill_point(row.points[0], {arms.f0, arms.f1}, {arms.f2, arms.f3}, normal.f2, fill_k.warm_scale * impulses.f0,
               fill_k.warm_scale * impulses.f1);
    if constexpr (N == 2)
        fill_point(row.points[1], {arms.f4, arms.f5}, {arms.f6, arms.f7}, normal.f3, fill_k.warm_scale * impulses.f2,
                   fill_k.warm_scale * impulses.f3);
    round_off(row, bodies, fill_k.whirl_speed);
    prepare(row, k, bodies.a, bodies.b);
}

/// Writes what the solver has found to the records of contacts.
/// @param results see result_floats
template <class F, int N>
void store_points(const ContactRow<F, N>& row, const LaneRecords<F, float>& manifolds, const LaneRecords<F, float>& results)
{
    const PointRow<F>& p = row.points[0];
    if constexpr (N == 2)
    {
        const PointRow<F>& q = row.points[1];
        scatter_four(manifolds, ManifoldFloats::impulses, FourLanes<F>{p.lambda_n, p.lambda_t, q.lambda_n, q.lambda_t});
        scatter_eight(
            results, 0,
            EightLanes<F>{p.total_n, p.total_t, q.total_n, q.total_t, p.normal_velocity, q.normal_velocity, row.rolling_total, F(0)});
    }
    else
    {
        scatter_two(manifolds, ManifoldFloats::impulses, TwoLanes<F>{p.lambda_n, p.lambda_t});
        scatter_eight(results, 0, EightLanes<F>{p.total_n, p.total_t, F(0), F(0), p.normal_velocity, F(0), row.rolling_total, F(0)});
    }
}

/// Writes the rolling impulse, and what each point has been carrying.
/// @param are_calm 1 where both bodies are at rest or can't be pushed, else 0
/// @return 1 where the spring of a contact is far from where the whole correction would hold it, else 0
template <class F, int N>
F store_load(const ContactRow<F, N>& row, const LaneRecords<F, float>& manifolds, const F& are_calm, const StoreConstants<F>& k)
{
    // The mean of the points: followed one by one, they would amplify a tower's rocking.
    F load = F(0);
    for (const PointRow<F>& point : row.points) load = load + point.lambda_n / F(static_cast<float>(N));
    const F missing = k.carried_part * load - row.carried;
    const F share = select(are_calm > F(0), k.calm_share, k.carry_share);
    scatter_two(manifolds, ManifoldFloats::rolling, TwoLanes<F>{row.rolling_lambda, row.carried + share * missing});
    const F stiffness = row.points[0].normal_mass * row.mass_scale * row.bias_rate;
    return select(row.impulse_scale * missing > k.settled_within * stiffness, F(1), F(0));
}

} // namespace carom::detail
