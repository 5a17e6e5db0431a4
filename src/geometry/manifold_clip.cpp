// From two facing edges, or two corners, to contact points.
#include "geometry/manifold_kernels.hpp"
#include "geometry/nearest.hpp"

namespace carom::detail
{

namespace
{

using Point = EdgePoint<float>;

ReferenceEdge<float> reference_of(const EdgePair& pair)
{
    return {lane_vec(pair.reference.v1), lane_vec(pair.normal), pair.reference_radius, pair.incident_radius, lane_vec(pair.origin)};
}

void add_point(LocalManifold& manifold, const EdgePair& pair, Point point, std::uint32_t reference_index, std::uint32_t incident_index,
               float margin)
{
    const ReferenceEdge<float> reference = reference_of(pair);
    const float separation = separation_at(reference, point);
    if (separation > margin) return;
    const LaneVec<float> position = position_at(reference, point);
    LocalPoint& added = manifold.points[static_cast<std::size_t>(manifold.count++)];
    added.position = {position.x, position.y};
    added.separation = separation;
    added.feature = pair.reference_is_b ? feature_of(incident_index, reference_index) : feature_of(reference_index, incident_index);
}

// Every function here returns one variable or the result of a call: so the manifold is written where the caller wants it, and never copied.

LocalManifold push_out_deepest(const EdgePair& pair, std::uint32_t v_index, Point w1, Point w2, float margin)
{
    LocalManifold manifold;
    manifold.normal = pair.reference_is_b ? -pair.normal : pair.normal;
    const bool first = w1.h < w2.h;
    add_point(manifold, pair, first ? w1 : w2, v_index, first ? pair.incident.i1 : pair.incident.i2, margin);
    return manifold;
}

/// The edges pass each other by beyond the corner `v` of the reference edge. While the cores are apart the normal joins the nearest
/// corners; when they overlap, that line could point anywhere, and the deepest end is pushed out along the reference normal.
LocalManifold pass_by(const EdgePair& pair, Vec2 v, std::uint32_t v_index, Point w1, Point w2, float margin)
{
    const Edge& w = pair.incident;
    if (w1.h > 0 && w2.h > 0)
    {
        const bool first = length_squared(w.v1 - v) < length_squared(w.v2 - v);
        return join_corners(pair, {v, first ? w.v1 : w.v2, v_index, first ? w.i1 : w.i2}, margin);
    }
    return push_out_deepest(pair, v_index, w1, w2, margin);
}

/// The ends of the stretch from t = start to end that the edges have in common.
LocalManifold clip_common(const EdgePair& pair, Point w1, Point w2, float start, float end, float margin)
{
    const Edge& v = pair.reference;
    const Edge& w = pair.incident;
    const Point lower = lower_end(w1, w2, start);
    const Point upper = upper_end(w1, w2, end);
    LocalManifold manifold;
    manifold.normal = pair.reference_is_b ? -pair.normal : pair.normal;
    add_point(manifold, pair, lower, v.i1, w.i2, margin);
    add_point(manifold, pair, upper, v.i2, w.i1, margin);
    return manifold;
}

} // namespace

LocalManifold clip(const EdgePair& pair, float margin)
{
    const Edge& v = pair.reference;
    const Edge& w = pair.incident;
    const float length_t = dot(v.v2 - v.v1, left_perp(pair.normal));
    const ReferenceEdge<float> reference = reference_of(pair);
    const Point w1 = in_frame_of(reference, lane_vec(w.v1));
    const Point w2 = in_frame_of(reference, lane_vec(w.v2));
    const float start = -pair.slack;
    const float end = length_t + pair.slack;
    if (w1.t <= start && w2.t <= start) return pass_by(pair, v.v1, v.i1, w1, w2, margin);
    if (w1.t >= end && w2.t >= end) return pass_by(pair, v.v2, v.i2, w1, w2, margin);

    return clip_common(pair, w1, w2, start, end, margin);
}

LocalManifold join_corners(const EdgePair& pair, const CornerPair& corners, float margin)
{
    LocalManifold manifold;
    const Nearest nearest = nearest_from_foot(corners.reference, corners.incident, pair.normal);
    const float separation = nearest.distance - pair.reference_radius - pair.incident_radius;
    if (separation > margin) return manifold;
    const float middle = 0.5f * (nearest.distance + pair.reference_radius - pair.incident_radius);
    manifold.normal = pair.reference_is_b ? -nearest.normal : nearest.normal;
    manifold.count = 1;
    manifold.points[0].position = pair.origin + (corners.reference + middle * nearest.normal);
    manifold.points[0].separation = separation;
    manifold.points[0].feature = pair.reference_is_b ? feature_of(corners.incident_index, corners.reference_index)
                                                     : feature_of(corners.reference_index, corners.incident_index);
    return manifold;
}

} // namespace carom::detail
