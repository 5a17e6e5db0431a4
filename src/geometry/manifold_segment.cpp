// Capsules and segments against each other. Their cores have no inside, so the polygons' search for a separating face is not enough: two
// cores in line, end to end, are apart along no face's normal. Here the nearest points decide, and faces only where the cores cross.
#include "geometry/manifold_kernels.hpp"

namespace carom::detail
{

namespace
{

/// A core with what every test of it needs.
struct Core
{
    Vec2 p1;
    Vec2 p2;
    Vec2 along; ///< unit, p1 to p2
    Vec2 left;  ///< unit normal
    float length;
    float radius;
};

/// The direction comes from the shape's own frame: far away, p1 and p2 may be one point after rounding.
Core make_core(const SegmentCore& shape, Rot q, Vec2 shift)
{
    const Vec2 d = rotate(q, shape.p2 - shape.p1);
    const float l = length(d);
    const Vec2 along = {d.x / l, d.y / l};
    return {rotate(q, shape.p1) + shift, rotate(q, shape.p2) + shift, along, left_perp(along), l, shape.radius};
}

/// The end of one core that is nearest to the other core.
struct NearestEnd
{
    float distance2 = 0;   ///< [m^2]
    float t = 0;           ///< its foot's place along the other core, not clamped [m]
    std::uint32_t end = 0; ///< 0: p1, 1: p2
    bool is_end_of_b = false;
};

NearestEnd nearest_end(const Core& core, Vec2 point, std::uint32_t end, bool is_end_of_b)
{
    const float t = dot(point - core.p1, core.along);
    const Vec2 foot = t <= 0 ? core.p1 : t >= core.length ? core.p2 : core.p1 + t * core.along;
    return {length_squared(point - foot), t, end, is_end_of_b};
}

NearestEnd nearest_of_all_ends(const Core& a, const Core& b)
{
    NearestEnd best = nearest_end(a, b.p1, 0, true);
    for (const NearestEnd& other : {nearest_end(a, b.p2, 1, true), nearest_end(b, a.p1, 0, false), nearest_end(b, a.p2, 1, false)})
    {
        if (other.distance2 < best.distance2) best = other;
    }
    return best;
}

/// Whether the ends of each core lie strictly on different sides of the other.
bool do_cross(const Core& a, const Core& b)
{
    const float b1 = dot(b.p1 - a.p1, a.left);
    const float b2 = dot(b.p2 - a.p1, a.left);
    const float a1 = dot(a.p1 - b.p1, b.left);
    const float a2 = dot(a.p2 - b.p1, b.left);
    return ((b1 < 0 && b2 > 0) || (b1 > 0 && b2 < 0)) && ((a1 < 0 && a2 > 0) || (a1 > 0 && a2 < 0));
}

/// `reference` as an edge whose outward normal is `normal`, one of its two, and `incident` against it. An edge's shape is on its left, so
/// that the outward normal is on its right.
EdgePair face_to_face(const Core& reference, const Core& incident, Vec2 normal, bool reference_is_b)
{
    EdgePair pair;
    pair.reference = {reference.p1, reference.p2, 0, 1};
    if (dot(normal, reference.left) > 0) pair.reference = {reference.p2, reference.p1, 1, 0};
    pair.incident = {incident.p1, incident.p2, 0, 1};
    if (dot(incident.p2 - incident.p1, left_perp(normal)) > 0) pair.incident = {incident.p2, incident.p1, 1, 0};
    pair.normal = normal;
    pair.reference_radius = reference.radius;
    pair.incident_radius = incident.radius;
    pair.reference_is_b = reference_is_b;
    return pair;
}

/// How far `other` reaches behind the line of `core`, on the side where it reaches less far: the way to push it out over that line.
struct Crossing
{
    Vec2 normal;      ///< of the core, towards the side to push the other to
    float separation; ///< negative [m]
};

Crossing shorter_side(const Core& core, const Core& other)
{
    const float h1 = dot(other.p1 - core.p1, core.left);
    const float h2 = dot(other.p2 - core.p1, core.left);
    const float lowest = h1 < h2 ? h1 : h2;
    const float highest = h1 < h2 ? h2 : h1;
    return -lowest <= highest ? Crossing{core.left, lowest} : Crossing{-core.left, -highest};
}

} // namespace

LocalManifold collide_segments(const SegmentCore& shape_a, const SegmentCore& shape_b, const Transform& b_in_a, const Nearness& near)
{
    const Vec2 origin = shape_a.p1;
    const Core a = make_core(shape_a, {}, -origin);
    const Core b = make_core(shape_b, b_in_a.q, b_in_a.p - origin);

    EdgePair pair;
    if (do_cross(a, b))
    {
        // The difference of the cores is a parallelogram whose faces have the cores' normals: the least push is along one of those.
        const Crossing over_a = shorter_side(a, b);
        const Crossing over_b = shorter_side(b, a);
        const bool take_b = over_b.separation > over_a.separation + near.tolerances.reference_preference;
        pair = take_b ? face_to_face(b, a, over_b.normal, true) : face_to_face(a, b, over_a.normal, false);
        pair.origin = origin;
        return clip(pair, near.margin);
    }

    const NearestEnd nearest = nearest_of_all_ends(a, b);
    const float reach = a.radius + b.radius + near.margin;
    if (nearest.distance2 > reach * reach) return no_contact(std::sqrt(nearest.distance2) - reach, near.search);

    const Core& face = nearest.is_end_of_b ? a : b;
    const Core& other = nearest.is_end_of_b ? b : a;
    const Vec2 end = nearest.end == 0 ? other.p1 : other.p2;
    const Vec2 normal = dot(end - face.p1, face.left) >= 0 ? face.left : -face.left;
    pair = face_to_face(face, other, normal, !nearest.is_end_of_b);
    pair.origin = origin;

    pair.slack = corner_slack * std::sqrt(nearest.distance2);
    if (nearest.t >= -pair.slack && nearest.t <= face.length + pair.slack) return clip(pair, near.margin);
    const std::uint32_t face_end = nearest.t < 0 ? 0 : 1;
    return join_corners(pair, {face_end == 0 ? face.p1 : face.p2, end, face_end, nearest.end}, near.margin);
}

} // namespace carom::detail
