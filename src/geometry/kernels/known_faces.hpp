// The contact of two shapes whose best faces are known and face each other, from their bodies' poses to points in the world, as templates over
// the lane type. What has another outcome than one or two points along a face is left to collide() (geometry/manifold.hpp).
#pragma once

#include "geometry/kernels/facing_edges.hpp"

namespace carom::detail
{

template <class F>
struct LaneTransform
{
    LaneVec<F> p;
    LaneRot<F> q;
};

/// The frame of `b` seen from the frame of `a`.
template <class F>
LaneTransform<F> relative(const LaneTransform<F>& a, const LaneTransform<F>& b)
{
    return {inverse_rotate(a.q, b.p - a.p), relative(a.q, b.q)};
}

/// Of a search: see CollisionMemory (dynamics/collision_memory.hpp), whose first eight floats these are.
template <class F>
struct SearchedAt
{
    LaneTransform<F> made_at;
    LaneVec<F> arm;
    F radius;
    F allowed;
};

/// Whether the result of a search still holds.
template <class F>
MaskOf<F> holds(const SearchedAt<F>& search, const LaneTransform<F>& b_in_a)
{
    const LaneRot<F> turn = relative(search.made_at.q, b_in_a.q);
    const F less = turn.c - F(1);
    // |s| + |c - 1| is at least |Q - I|
    const F rest = search.allowed - (lane_max(turn.s, -turn.s) - less) * search.radius;
    const LaneVec<F> arm = search.arm;
    const LaneVec<F> moved = b_in_a.p - search.made_at.p + LaneVec<F>{less * arm.x - turn.s * arm.y, turn.s * arm.x + less * arm.y};
    const F moved_squared = dot(moved, moved);
    const MaskOf<F> is_used_up = (rest < F(0)) | (moved_squared > rest * rest);
    return !is_used_up;
}

/// Two faces, each of which is the edge that faces the other.
template <class F>
struct FacePair
{
    LaneVec<F> a_v1; ///< in A's frame, moved by `origin` to where the shape is [m]
    LaneVec<F> a_v2;
    LaneVec<F> a_normal;
    LaneVec<F> origin;
    LaneVec<F> b_v1; ///< in B's frame [m]
    LaneVec<F> b_v2;
    LaneVec<F> b_normal;
    F a_radius; ///< [m]
    F b_radius;
};

/// Where a body is: see BodyPose.
template <class F>
struct LanePose
{
    LaneTransform<F> transform;
    LaneVec<F> center;       ///< of mass, in the world [m]
    LaneVec<F> local_center; ///< of mass, in the body's frame [m]
};

/// What decides how near is near enough: see Tolerances [m].
struct TouchLimits
{
    float margin;
    float least_core_distance;
    float reference_preference;
};

/// One or two points in the world.
template <class F>
struct FaceTouch
{
    LaneVec<F> r_a[2]; ///< from A's centre of mass to the points [m]
    LaneVec<F> r_b[2];
    LaneVec<F> normal; ///< from A to B
    F separation[2];
    MaskOf<F> is_known;  ///< that the contact is this; where it is not, the rest means nothing
    MaskOf<F> has_lower; ///< the point at the start of the reference face is one
    MaskOf<F> has_upper; ///< so is that at its end. When only this one is, it comes first
    MaskOf<F> reference_is_b;
};

/// The two edges of a pair seen from A, and which of them is the reference.
template <class F>
struct PlacedFaces
{
    ReferenceEdge<F> reference;
    LaneVec<F> v2; ///< the other end of the reference edge
    LaneVec<F> w1; ///< the incident edge
    LaneVec<F> w2;
    F separation; ///< of the cores along the reference face [m]
    MaskOf<F> are_apart;
    MaskOf<F> reference_is_b;
};

template <class F>
PlacedFaces<F> place_faces(const FacePair<F>& pair, const LaneTransform<F>& b_in_a, const TouchLimits& limits)
{
    const LaneVec<F> shift = b_in_a.p - pair.origin;
    const LaneVec<F> b_v1 = rotate(b_in_a.q, pair.b_v1) + shift;
    const LaneVec<F> b_v2 = rotate(b_in_a.q, pair.b_v2) + shift;
    const LaneVec<F> b_normal = rotate(b_in_a.q, pair.b_normal);
    const F over_a = lane_min(dot(pair.a_normal, b_v1 - pair.a_v1), dot(pair.a_normal, b_v2 - pair.a_v1));
    const F over_b = lane_min(dot(b_normal, pair.a_v1 - b_v1), dot(b_normal, pair.a_v2 - b_v1));
    const F reach = pair.a_radius + pair.b_radius + F(limits.margin);
    const MaskOf<F> is_b = over_b > over_a + F(limits.reference_preference);
    const MaskOf<F> are_apart = (over_a > reach) | (over_b > reach);
    const ReferenceEdge<F> reference = {select(is_b, b_v1, pair.a_v1), select(is_b, b_normal, pair.a_normal),
                                        select(is_b, pair.b_radius, pair.a_radius), select(is_b, pair.a_radius, pair.b_radius),
                                        pair.origin};
    return {reference,
            select(is_b, b_v2, pair.a_v2),
            select(is_b, pair.a_v1, b_v1),
            select(is_b, pair.a_v2, b_v2),
            select(is_b, over_b, over_a),
            are_apart,
            is_b};
}

template <class F>
FaceTouch<F> touch_faces(const LanePose<F>& a, const LanePose<F>& b, const SearchedAt<F>& search, const FacePair<F>& pair,
                         const TouchLimits& limits)
{
    const LaneTransform<F> b_in_a = relative(a.transform, b.transform);
    const PlacedFaces<F> faces = place_faces(pair, b_in_a, limits);
    const ReferenceEdge<F>& reference = faces.reference;
    const EdgePoint<F> w1 = in_frame_of(reference, faces.w1);
    const EdgePoint<F> w2 = in_frame_of(reference, faces.w2);
    const F length = dot(faces.v2 - reference.v1, left_perp(reference.normal));

    // Separated cores touch along the face when the nearer corner is over it, but for some slack.
    const MaskOf<F> is_separated = faces.separation > F(limits.least_core_distance);
    const F slack = select(is_separated, F(corner_slack) * lane_min(w1.h, w2.h), F(0));
    const F start = -slack;
    const F end = length + slack;
    const F nearer = select(w1.h < w2.h, w1.t, w2.t);
    const MaskOf<F> is_off = (nearer < start) | (nearer > end);
    const F lowest = lane_min(w1.t, w2.t);
    const F highest = lane_max(w1.t, w2.t);
    const MaskOf<F> have_common_stretch = (highest > start) & (lowest < end);

    const EdgePoint<F> lower = lower_end(w1, w2, start);
    const EdgePoint<F> upper = upper_end(w1, w2, end);
    const F lower_separation = separation_at(reference, lower);
    const F upper_separation = separation_at(reference, upper);
    const MaskOf<F> has_lower = !(lower_separation > F(limits.margin));
    const MaskOf<F> has_upper = !(upper_separation > F(limits.margin));
    const LaneVec<F> centers = b.center - a.center;
    const auto arm = [&](const EdgePoint<F>& point) { return rotate(a.transform.q, position_at(reference, point) - a.local_center); };

    FaceTouch<F> touch;
    const MaskOf<F> is_other = faces.are_apart | (is_separated & is_off);
    touch.is_known = holds(search, b_in_a) & have_common_stretch & (has_lower | has_upper) & !is_other;
    touch.has_lower = has_lower;
    touch.has_upper = has_upper;
    touch.reference_is_b = faces.reference_is_b;
    touch.r_a[1] = arm(upper);
    touch.r_a[0] = select(has_lower, arm(lower), touch.r_a[1]);
    touch.r_b[0] = touch.r_a[0] - centers;
    touch.r_b[1] = touch.r_a[1] - centers;
    touch.separation[0] = select(has_lower, lower_separation, upper_separation);
    touch.separation[1] = upper_separation;
    touch.normal =
        rotate(a.transform.q, select(faces.reference_is_b, LaneVec<F>{-reference.normal.x, -reference.normal.y}, reference.normal));
    return touch;
}

} // namespace carom::detail
