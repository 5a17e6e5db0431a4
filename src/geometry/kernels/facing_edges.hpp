// From two edges face to face to contact points, as templates over the lane type.
//
//        w1 <-------- w2       incident edge
//              ^ n
//        v2 <-------- v1       reference edge, its shape below
//         t: from v1 to v2
#pragma once

#include "math/lane_vec.hpp"

namespace carom::detail
{

/// A corner that lies this far beyond the end of an edge, as a share of its distance, still counts as lying over the edge. Two boxes of
/// equal width, one exactly on the other, are face to face and not corner to corner; the price is a thousandth of a radian in the normal.
/// Test: Manifold.StackOfEqualBoxesHasTwoPoints.
inline constexpr float corner_slack = 1e-3f;

/// What places points relative to the reference edge.
template <class F>
struct ReferenceEdge
{
    LaneVec<F> v1;
    LaneVec<F> normal;  ///< unit, outward
    F reference_radius; ///< [m]
    F incident_radius;  ///< [m]
    LaneVec<F> origin;  ///< added to the positions [m]
};

/// A point of the incident edge in the frame of the reference edge: t along it from v1, h above it [m].
template <class F>
struct EdgePoint
{
    F t;
    F h;
};

template <class F>
EdgePoint<F> in_frame_of(const ReferenceEdge<F>& edge, const LaneVec<F>& point)
{
    const LaneVec<F> d = point - edge.v1;
    return {dot(d, left_perp(edge.normal)), dot(d, edge.normal)};
}

/// Where the incident edge crosses t; the ends lie on different sides of it.
template <class F>
EdgePoint<F> cut(const EdgePoint<F>& a, const EdgePoint<F>& b, const F& t)
{
    return {t, a.h + (t - a.t) / (b.t - a.t) * (b.h - a.h)};
}

template <class F>
EdgePoint<F> lower_end(const EdgePoint<F>& w1, const EdgePoint<F>& w2, const F& start)
{
    const EdgePoint<F> at_start = cut(w2, w1, start);
    const MaskOf<F> is_cut = w2.t < start;
    return {select(is_cut, at_start.t, w2.t), select(is_cut, at_start.h, w2.h)};
}

template <class F>
EdgePoint<F> upper_end(const EdgePoint<F>& w1, const EdgePoint<F>& w2, const F& end)
{
    const EdgePoint<F> at_end = cut(w2, w1, end);
    const MaskOf<F> is_cut = w1.t > end;
    return {select(is_cut, at_end.t, w1.t), select(is_cut, at_end.h, w1.h)};
}

template <class F>
F separation_at(const ReferenceEdge<F>& edge, const EdgePoint<F>& point)
{
    return point.h - edge.reference_radius - edge.incident_radius;
}

/// Halfway between the surfaces: the reference's lies at height reference_radius, the incident one's at h - incident_radius.
template <class F>
LaneVec<F> position_at(const ReferenceEdge<F>& edge, const EdgePoint<F>& point)
{
    const F middle = F(0.5f) * (point.h + edge.reference_radius - edge.incident_radius);
    return edge.origin + (edge.v1 + (left_perp(edge.normal) * point.t + edge.normal * middle));
}

} // namespace carom::detail
