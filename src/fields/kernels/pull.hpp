// The pull kernels: of bodies, and of groups to the second moment, at points and as a Taylor series about one.
//
// Masses come in eights, and each of the eight has a partial sum of its own, whatever the lane type: the widths differ in how many of them
// are added at once, not in what is added to what. So all give the same bits.
#pragma once

#include "math/lanes.hpp"

#include <cstddef>

namespace carom::detail
{

inline constexpr int pull_parts = 8; ///< partial sums

inline constexpr int group_floats = 12; ///< of a group, in the order of GroupBlock

/// Eight groups by component. Moments are means over the bodies of products of their offsets from the centre of mass.
struct alignas(32) GroupBlock
{
    float x[pull_parts], y[pull_parts], rest_x[pull_parts], rest_y[pull_parts], pull[pull_parts];
    float spread_xx[pull_parts], spread_xy[pull_parts], spread_yy[pull_parts];
    float skew_xxx[pull_parts], skew_xxy[pull_parts], skew_xyy[pull_parts], skew_yyy[pull_parts];
};

/// What bounds a pull.
struct PullLimits
{
    float softening_squared; ///< [m^2]
    float largest;           ///< of one mass [m/s^2]: so many times below the largest float as there are masses, so no sum overflows
};

/// Acceleration around a point, to fifth order in t, the offset from it in units of a radius:
/// g_i + g_ij t_j + g_ijk t_j t_k + ... + g_ijklmn t_j t_k t_l t_m t_n, where order n has its 1 / n! in it. Each is symmetric in its indices,
/// since the acceleration is a gradient: its components are those with all x, with one y, and so on to all y. All have the unit of
/// acceleration [m/s^2].
/// @tparam F a number, or lanes with one for each partial sum
template <class F>
struct PullSeries
{
    F value[2];
    F first[3];
    F second[4];
    F third[5];
    F fourth[6];
    F fifth[7];
};

template <class F>
struct PullLanes
{
    F x{0};
    F y{0};
};

/// A series about a place.
struct LocalPull
{
    float x, y;   ///< the place [m]
    float radius; ///< in which offsets count [m]; 0 where all points are at the place
    PullSeries<float> terms;
};

/// Masses at d from the target; with s = sqrt(|d|^2 + softening^2) each gives (pull / s / s) (d / s). In this order nothing but the clamped
/// factor can overflow, even where s^2 is the smallest float.
template <class F>
struct Attraction
{
    F inverse_s;
    F n_x; ///< d / s
    F n_y;
    F strength;
    typename LaneTraits<F>::Mask counts; ///< not at distance 0 (a body and itself), nor so far away that s^2 is no finite float
};

template <class F>
Attraction<F> attraction(F d_x, F d_y, F pull, const PullLimits& limits)
{
    const F s_squared = d_x * d_x + d_y * d_y + F(limits.softening_squared);
    const F inverse_s = F(1) / lane_sqrt(s_squared);
    const F strength = lane_max(lane_min(pull * inverse_s * inverse_s, F(limits.largest)), F(-limits.largest));
    const typename LaneTraits<F>::Mask counts = (s_squared > F(0)) & (s_squared < F(__builtin_inff()));
    return {inverse_s, d_x * inverse_s, d_y * inverse_s, strength, counts};
}

/// Bodies from one on.
template <class F>
void add_bodies(PullLanes<F>& sum, const float* body_x, const float* body_y, const float* pull, F x, F y, const PullLimits& limits)
{
    const Attraction<F> a = attraction<F>(load_lanes<F>(body_x) - x, load_lanes<F>(body_y) - y, load_lanes<F>(pull), limits);
    sum.x = sum.x + select(a.counts, a.strength * a.n_x, F(0));
    sum.y = sum.y + select(a.counts, a.strength * a.n_y, F(0));
}

/// Groups at d from a point, in units of s.
template <class F>
struct GroupPull
{
    Attraction<F> a;
    F q_xx, q_xy, q_yy;           ///< second moments
    F o_xxx, o_xxy, o_xyy, o_yyy; ///< third moments, over 6 and times how often they come
    F third[5];                   ///< third derivatives of g
    F g_x, g_y;                   ///< the pull over its strength
};

/// The mean of g(d + e) = (d + e) / s^3 over the offsets e of the group's bodies, to third order. The first order is zero, because offsets are
/// from the centre of mass. With Q = mean(e e^T), `spread`, O = mean(e e e), `skew`, and n = d / s:
///
///     d_j d_k g_i = -3 (delta_ij d_k + delta_ik d_j + delta_jk d_i) / s^5 + 15 d_i d_j d_k / s^7
///     1/2 Q_jk d_j d_k g = (1 / s^2) (n (7.5 n.Qn - 1.5 tr Q) - 3 Qn) / s^2
///     1/6 O_jkl d_j d_k d_l g, with the derivatives of add_series
///
/// Without them an opening angle of 0.5 errs by 4% of a body's acceleration (root mean square over 10,000 bodies spread evenly), with the second alone
/// by 0.2%, with both by a third of that.
template <class F>
GroupPull<F> group_pull(const GroupBlock& b, int part, F x, F y, const PullLimits& limits)
{
    const F d_x = load_lanes<F>(b.x + part) - x + load_lanes<F>(b.rest_x + part);
    const F d_y = load_lanes<F>(b.y + part) - y + load_lanes<F>(b.rest_y + part);
    const Attraction<F> a = attraction<F>(d_x, d_y, load_lanes<F>(b.pull + part), limits);
    const auto scaled = [&](const float* moment) { return load_lanes<F>(moment + part) * a.inverse_s * a.inverse_s; };
    const F q_xx = scaled(b.spread_xx);
    const F q_xy = scaled(b.spread_xy);
    const F q_yy = scaled(b.spread_yy);
    const F qn_x = q_xx * a.n_x + q_xy * a.n_y;
    const F qn_y = q_xy * a.n_x + q_yy * a.n_y;
    const F along = F(1) + F(7.5f) * (a.n_x * qn_x + a.n_y * qn_y) - F(1.5f) * (q_xx + q_yy);
    const F xx = a.n_x * a.n_x;
    const F xy = a.n_x * a.n_y;
    const F yy = a.n_y * a.n_y;
    const F d_xxxx = xx * (F(90) - F(105) * xx) - F(9);
    const F d_xxxy = xy * (F(45) - F(105) * xx);
    const F d_xxyy = F(15) * (xx + yy) - F(105) * xx * yy - F(3);
    const F d_xyyy = xy * (F(45) - F(105) * yy);
    const F d_yyyy = yy * (F(90) - F(105) * yy) - F(9);
    const F sixth = F(1 / 6.0f) * a.inverse_s;
    const F o_xxx = scaled(b.skew_xxx) * sixth;
    const F o_xxy = scaled(b.skew_xxy) * (F(3) * sixth);
    const F o_xyy = scaled(b.skew_xyy) * (F(3) * sixth);
    const F o_yyy = scaled(b.skew_yyy) * sixth;
    const F od_x = o_xxx * d_xxxx + o_xxy * d_xxxy + o_xyy * d_xxyy + o_yyy * d_xyyy;
    const F od_y = o_xxx * d_xxxy + o_xxy * d_xxyy + o_xyy * d_xyyy + o_yyy * d_yyyy;
    return {a,
            q_xx,
            q_xy,
            q_yy,
            o_xxx,
            o_xxy,
            o_xyy,
            o_yyy,
            {d_xxxx, d_xxxy, d_xxyy, d_xyyy, d_yyyy},
            a.n_x * along - F(3) * qn_x + od_x,
            a.n_y * along - F(3) * qn_y + od_y};
}

template <class F>
void add_groups(PullLanes<F>& sum, const GroupBlock& b, int part, F x, F y, const PullLimits& limits)
{
    const GroupPull<F> p = group_pull(b, part, x, y, limits);
    sum.x = sum.x + select(p.a.counts, p.a.strength * p.g_x, F(0));
    sum.y = sum.y + select(p.a.counts, p.a.strength * p.g_y, F(0));
}

/// Contracts the last index of a tensor with t, and adds that to one with an index less. Components are those of PullSeries.
template <class F, int Count>
void add_along(F (&sum)[Count], const F (&tensor)[Count + 1], F t_x, F t_y)
{
    for (int i = 0; i < Count; ++i) sum[i] = sum[i] + (tensor[i] * t_x + tensor[i + 1] * t_y);
}

/// A round of Horner's scheme, from the highest order down to `last`. One round to order 0 leaves the value at t there; rounds to 0, 1, and so on
/// to 4 leave the series about t.
template <class F>
void add_higher_orders(PullSeries<F>& s, F t_x, F t_y, int last)
{
    add_along(s.fourth, s.fifth, t_x, t_y);
    if (last < 4) add_along(s.third, s.fourth, t_x, t_y);
    if (last < 3) add_along(s.second, s.third, t_x, t_y);
    if (last < 2) add_along(s.first, s.second, t_x, t_y);
    if (last < 1) add_along(s.value, s.first, t_x, t_y);
}

template <class F, int Count>
void add_scaled(F (&sum)[Count], F factor, const F (&terms)[Count])
{
    for (int i = 0; i < Count; ++i) sum[i] = sum[i] + factor * terms[i];
}

/// a_i + 1/2 Q_jk b_ijk
template <class F, int Count>
void add_second_moments(F (&a)[Count], const GroupPull<F>& p, const F (&b)[Count + 2])
{
    for (int i = 0; i < Count; ++i) a[i] = a[i] + (F(0.5f) * (p.q_xx * b[i] + p.q_yy * b[i + 2]) + p.q_xy * b[i + 1]);
}

/// a_i + 1/6 O_jkl b_ijkl
template <class F, int Count>
void add_third_moments(F (&a)[Count], const GroupPull<F>& p, const F (&b)[Count + 3])
{
    for (int i = 0; i < Count; ++i) a[i] = a[i] + ((p.o_xxx * b[i] + p.o_xxy * b[i + 1]) + (p.o_xyy * b[i + 2] + p.o_yyy * b[i + 3]));
}

/// Adds the series of groups, none of which is so near or so far that it does not count. With r the radius, h = r / s, and D_n the n-th derivative
/// of g = d / s^3 by d in units of s:
///
///     term of order n = (-h)^n / n! (D_n + 1/2 Q_jk D_(n+2)_jk + 1/6 O_jkl D_(n+3)_jkl), with no derivative beyond D_5
///     D_1 = delta_ij - 3 n_i n_j
///     D_2 = -3 (delta_ij n_k + ..) + 15 n_i n_j n_k
///     D_3 = -3 (delta_ij delta_kl + ..) + 15 (delta_ij n_k n_l + ..) - 105 n_i n_j n_k n_l
///     D_4 = 15 (delta delta n + ..) - 105 (delta n n n + ..) + 945 n n n n n
///     D_5 = 15 (delta delta delta + ..) - 105 (delta delta n n + ..) + 945 (delta n n n n + ..) - 10395 n n n n n n
///
/// where .. stands for the other ways to share out the indices. What is left out is of sixth order in the size of the targets over the distance, of
/// fourth in that of the group.
/// @source W. Dehnen, "A Very Fast and Momentum-conserving Tree Code", 2000
template <class F>
void add_series(PullSeries<F>& sum, const GroupBlock& b, int part, F x, F y, F radius, const PullLimits& limits)
{
    const GroupPull<F> p = group_pull(b, part, x, y, limits);
    const F n_x = p.a.n_x;
    const F n_y = p.a.n_y;
    const F xx = n_x * n_x;
    const F xy = n_x * n_y;
    const F yy = n_y * n_y;
    const F squares = xx * yy;
    const F value[2] = {p.g_x, p.g_y};
    F first[3] = {F(1) - F(3) * xx, F(-3) * xy, F(1) - F(3) * yy};
    F second[4] = {n_x * (F(15) * xx - F(9)), n_y * (F(15) * xx - F(3)), n_x * (F(15) * yy - F(3)), n_y * (F(15) * yy - F(9))};
    F third[5] = {p.third[0], p.third[1], p.third[2], p.third[3], p.third[4]};
    const F fourth[6] = {n_x * (F(225) - xx * (F(1050) - F(945) * xx)),
                         n_y * (F(45) - xx * (F(630) - F(945) * xx)),
                         n_x * (F(45) - F(105) * (xx + F(3) * yy) + F(945) * squares),
                         n_y * (F(45) - F(105) * (yy + F(3) * xx) + F(945) * squares),
                         n_x * (F(45) - yy * (F(630) - F(945) * yy)),
                         n_y * (F(225) - yy * (F(1050) - F(945) * yy))};
    const F fifth[7] = {F(225) - xx * (F(4725) - xx * (F(14175) - F(10395) * xx)),
                        xy * (xx * (F(9450) - F(10395) * xx) - F(1575)),
                        F(45) - F(315) * (xx + xx + yy) + F(945) * xx * (xx + F(6) * yy) - F(10395) * xx * squares,
                        xy * (F(2835) * (xx + yy) - F(945) - F(10395) * squares),
                        F(45) - F(315) * (yy + yy + xx) + F(945) * yy * (yy + F(6) * xx) - F(10395) * yy * squares,
                        xy * (yy * (F(9450) - F(10395) * yy) - F(1575)),
                        F(225) - yy * (F(4725) - yy * (F(14175) - F(10395) * yy))};
    add_second_moments(first, p, third);
    add_second_moments(second, p, fourth);
    add_second_moments(third, p, fifth);
    add_third_moments(first, p, fourth);
    add_third_moments(second, p, fifth);
    const F h = -(radius * p.a.inverse_s);
    F factor = p.a.strength;
    add_scaled(sum.value, factor, value);
    factor = factor * h;
    add_scaled(sum.first, factor, first);
    factor = factor * (F(1 / 2.0f) * h);
    add_scaled(sum.second, factor, second);
    factor = factor * (F(1 / 3.0f) * h);
    add_scaled(sum.third, factor, third);
    factor = factor * (F(1 / 4.0f) * h);
    add_scaled(sum.fourth, factor, fourth);
    factor = factor * (F(1 / 5.0f) * h);
    add_scaled(sum.fifth, factor, fifth);
}

} // namespace carom::detail
