// Polygons against polygons, and against capsules and segments as polygons of two corners.
//
// Separating axes: of two convex polygons that are apart, the normal of some face separates them; of two that overlap, the face
// that separates least badly gives the least way out. Around the circle of directions, the separation has a single hill wherever
// it is positive, so the best face normal is next to the true direction of the nearest points: those lie on the best face or at one of
// its ends, and on the facing edge of the other polygon. Two polygons of two corners have too few faces for that (manifold_segment.cpp).
#include "geometry/faces.hpp"
#include "math/float4.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace carom::detail
{

namespace
{

/// One number for each of 4 `blocks` corners, to be read by fours or singly. Both compilers define a union to allow that.
template <int blocks>
union Lanes
{
    Float4 block[blocks];
    float one[4 * blocks];
};

/// A polygon component by component, padded to full blocks with copies of its first corner. Loops go over the padded length, which the
/// compiler knows.
template <int blocks>
struct Hull
{
    static constexpr int size = 4 * blocks;

    Lanes<blocks> x;
    Lanes<blocks> y;
    Lanes<blocks> normal_x;
    Lanes<blocks> normal_y;
    int count;
    float radius;

    Vec2 vertex(int i) const { return {x.one[i], y.one[i]}; }
    Vec2 normal(int i) const { return {normal_x.one[i], normal_y.one[i]}; }
    int next(int i) const { return i + 1 < count ? i + 1 : 0; }
    Edge edge(int i) const { return {vertex(i), vertex(next(i)), static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(next(i))}; }
};

struct Vec4
{
    Float4 x;
    Float4 y;
};

/// Four neighbours of an array, component by component.
Vec4 load(const Vec2* v)
{
    Float4 low;
    Float4 high;
    std::memcpy(&low, v, sizeof low);
    std::memcpy(&high, v + 2, sizeof high);
    return {__builtin_shufflevector(low, high, 0, 2, 4, 6), __builtin_shufflevector(low, high, 1, 3, 5, 7)};
}

/// Where A is: only to be moved so that `origin` comes to (0, 0).
struct ShiftOnly
{
    Vec2 origin;
    Vec2 point(Vec2 p) const { return p - origin; }
    Vec4 point(const Vec4& p) const { return {p.x - splat4(origin.x), p.y - splat4(origin.y)}; }
    Vec2 direction(Vec2 d) const { return d; }
    Vec4 direction(const Vec4& d) const { return d; }
};

/// Where B is, seen from A. The difference of the two large numbers is taken first.
struct MoveAndShift
{
    Rot q;
    Vec2 shift;
    MoveAndShift(const Transform& b_in_a, Vec2 origin) : q(b_in_a.q), shift(b_in_a.p - origin) {}
    Vec2 point(Vec2 p) const { return rotate(q, p) + shift; }
    Vec4 point(const Vec4& p) const
    {
        const Vec4 d = direction(p);
        return {d.x + splat4(shift.x), d.y + splat4(shift.y)};
    }
    Vec2 direction(Vec2 d) const { return rotate(q, d); }
    Vec4 direction(const Vec4& d) const { return {splat4(q.c) * d.x - splat4(q.s) * d.y, splat4(q.s) * d.x + splat4(q.c) * d.y}; }
};

/// @param polygon of at most 4 `blocks` corners; the places behind its last one are read and not used
template <int blocks, class Place>
void fill(Hull<blocks>& hull, const Polygon& polygon, const Place& place)
{
    hull.count = polygon.count;
    hull.radius = polygon.radius;
    struct Corner
    {
        Vec2 vertex;
        Vec2 normal;
    } first;
    for (int k = 0; k < blocks; ++k)
    {
        const Vec4 v = place.point(load(polygon.vertices.data() + 4 * k));
        const Vec4 n = place.direction(load(polygon.normals.data() + 4 * k));
        const Int4 is_used = Int4{0, 1, 2, 3} + 4 * k < polygon.count;
        if (k == 0) first = {{v.x[0], v.y[0]}, {n.x[0], n.y[0]}};
        hull.x.block[k] = is_used ? v.x : splat4(first.vertex.x);
        hull.y.block[k] = is_used ? v.y : splat4(first.vertex.y);
        hull.normal_x.block[k] = is_used ? n.x : splat4(first.normal.x);
        hull.normal_y.block[k] = is_used ? n.y : splat4(first.normal.y);
    }
}

template <int blocks, class Place>
void fill(Hull<blocks>& hull, const SegmentCore& core, const Place& place)
{
    const Vec2 p1 = place.point(core.p1);
    const Vec2 p2 = place.point(core.p2);
    const Vec2 right = right_normal(core);
    const Vec2 normal_0 = place.direction(right);
    const Vec2 normal_1 = place.direction(-right);
    hull.count = 2;
    hull.radius = core.radius;
    for (int k = 0; k < blocks; ++k)
    {
        hull.x.block[k] = Float4{p1.x, p2.x, p1.x, p1.x};
        hull.y.block[k] = Float4{p1.y, p2.y, p1.y, p1.y};
        hull.normal_x.block[k] = Float4{normal_0.x, normal_1.x, normal_0.x, normal_0.x};
        hull.normal_y.block[k] = Float4{normal_0.y, normal_1.y, normal_0.y, normal_0.y};
    }
}

struct BestFace
{
    int face;
    float separation; ///< of the cores [m]
    float lead;       ///< over every other face [m]
};

/// max over the faces i of `reference` of min over the corners w of `other` of n_i . (w - v_i)
template <int blocks>
BestFace best_face(const Hull<blocks>& reference, const Hull<blocks>& other)
{
    Lanes<blocks> separation;
    for (int j = 0; j < Hull<blocks>::size; ++j)
    {
        for (int k = 0; k < blocks; ++k)
        {
            const Float4 dx = splat4(other.x.one[j]) - reference.x.block[k];
            const Float4 dy = splat4(other.y.one[j]) - reference.y.block[k];
            const Float4 s = reference.normal_x.block[k] * dx + reference.normal_y.block[k] * dy;
            separation.block[k] = j == 0 ? s : min4(s, separation.block[k]);
        }
    }
    int best = 0;
    float second = -std::numeric_limits<float>::max();
    for (int i = 1; i < reference.count; ++i)
    {
        const bool is_better = separation.one[i] > separation.one[best];
        second = std::max(second, separation.one[is_better ? best : i]);
        if (is_better) best = i;
    }
    return {best, separation.one[best], separation.one[best] - second};
}

struct FacingEdge
{
    int edge;
    float lead; ///< over every other edge: a difference of cosines
};

/// The edge of `other` that faces `normal` most squarely. It ends in the corner that is deepest behind the normal's face.
template <int blocks>
FacingEdge facing_edge(const Hull<blocks>& other, Vec2 normal)
{
    Lanes<blocks> along;
    for (int k = 0; k < blocks; ++k)
    {
        along.block[k] = other.normal_x.block[k] * splat4(normal.x) + other.normal_y.block[k] * splat4(normal.y);
    }
    int best = 0;
    float second = std::numeric_limits<float>::max();
    for (int j = 1; j < other.count; ++j)
    {
        const bool is_better = along.one[j] < along.one[best];
        second = std::min(second, along.one[is_better ? best : j]);
        if (is_better) best = j;
    }
    return {best, second - along.one[best]};
}

template <int blocks>
Face hull_face(const Hull<blocks>& hull, int face)
{
    return {hull.edge(face), hull.normal(face), hull.radius};
}

EdgePair pair_of(const Face& reference, const Face& other, bool reference_is_b, Vec2 origin)
{
    return {reference.edge, other.edge, reference.normal, reference.radius, other.radius, reference_is_b, origin, 0};
}

/// Separated cores: which of the regions of the two edges holds the nearest points? The reference edge gets the nearest
/// corner w of the incident edge over it, or else the incident edge the end v of the reference edge, or else v and w are nearest.
///
///       w o----                  w o------                     w o----
///         .                      .                            /
///     ----+-----        ------o v                  ----o v
///     w over the face         v over w's face      corner to corner
LocalManifold touch_separated(const Face& reference, const Face& other, bool reference_is_b, Vec2 origin, const Nearness& near)
{
    EdgePair pair = pair_of(reference, other, reference_is_b, origin);
    const Edge& v = pair.reference;
    const Edge& w = pair.incident;
    const Vec2 tangent = left_perp(pair.normal);
    const float h1 = dot(w.v1 - v.v1, pair.normal);
    const float h2 = dot(w.v2 - v.v1, pair.normal);
    const bool first = h1 < h2;
    const Vec2 corner = first ? w.v1 : w.v2;
    const float t = dot(corner - v.v1, tangent);
    pair.slack = corner_slack * (first ? h1 : h2);
    if (t >= -pair.slack && t <= dot(v.v2 - v.v1, tangent) + pair.slack) return clip(pair, near.margin);

    const bool is_lower_end = t < 0;
    const Vec2 end = is_lower_end ? v.v1 : v.v2;
    if (dot(end - corner, (first ? w.v2 : w.v1) - corner) > 0) return clip(pair_of(other, reference, !reference_is_b, origin), near.margin);
    return join_corners(pair, {end, corner, is_lower_end ? v.i1 : v.i2, first ? w.i1 : w.i2}, near.margin);
}

LocalManifold touch(const Face& reference, const Face& other, float separation, bool reference_is_b, Vec2 origin, const Nearness& near)
{
    if (separation > near.tolerances.least_core_distance) return touch_separated(reference, other, reference_is_b, origin, near);
    return clip(pair_of(reference, other, reference_is_b, origin), near.margin);
}

bool is_reference_b(float separation_a, float separation_b, const Nearness& near)
{
    return separation_b > separation_a + near.tolerances.reference_preference;
}

template <int blocks>
LocalManifold collide_hulls(const Hull<blocks>& a, const Hull<blocks>& b, Vec2 origin, const Nearness& near)
{
    FaceSearch& search = near.search;
    const float reach = a.radius + b.radius + near.margin;
    const BestFace best_a = best_face(a, b);
    if (best_a.separation > reach) return no_contact(best_a.separation - reach, search);
    const BestFace best_b = best_face(b, a);
    if (best_b.separation > reach) return no_contact(best_b.separation - reach, search);

    const FacingEdge facing_a = facing_edge(a, b.normal(best_b.face));
    const FacingEdge facing_b = facing_edge(b, a.normal(best_a.face));
    search.face_a = static_cast<std::uint8_t>(best_a.face);
    search.face_b = static_cast<std::uint8_t>(best_b.face);
    search.facing_a = static_cast<std::uint8_t>(facing_a.edge);
    search.facing_b = static_cast<std::uint8_t>(facing_b.edge);
    search.lead = std::min(best_a.lead, best_b.lead);
    search.turn_lead = std::min(facing_a.lead, facing_b.lead);
    if (is_reference_b(best_a.separation, best_b.separation, near))
        return touch(hull_face(b, best_b.face), hull_face(a, facing_a.edge), best_b.separation, true, origin, near);
    return touch(hull_face(a, best_a.face), hull_face(b, facing_b.edge), best_a.separation, false, origin, near);
}

/// How far a shape is in front of a face, when one of its edges that faces it is known: the deepest corner is one of its ends.
float separation_of(const Face& face, const Face& facing)
{
    return std::min(dot(face.normal, facing.edge.v1 - face.edge.v1), dot(face.normal, facing.edge.v2 - face.edge.v1));
}

/// @param facing_a, facing_b the edges that face face_b and face_a
LocalManifold collide_faces(const Face& face_a, const Face& facing_b, const Face& face_b, const Face& facing_a, Vec2 origin,
                            const Nearness& near)
{
    const float reach = face_a.radius + face_b.radius + near.margin;
    const float separation_a = separation_of(face_a, facing_b);
    if (separation_a > reach) return no_contact(separation_a - reach, near.search);
    const float separation_b = separation_of(face_b, facing_a);
    if (separation_b > reach) return no_contact(separation_b - reach, near.search);
    if (is_reference_b(separation_a, separation_b, near)) return touch(face_b, facing_a, separation_b, true, origin, near);
    return touch(face_a, facing_b, separation_a, false, origin, near);
}

/// The same as collide_hulls() with what it has found.
template <class A, class B>
LocalManifold collide_known(const A& a, const B& b, Vec2 origin, const Transform& b_in_a, const Nearness& near)
{
    const FaceSearch& known = near.search;
    const ShiftOnly at_a = {origin};
    const MoveAndShift at_b(b_in_a, origin);
    const Face face_a = face_of(a, known.face_a, at_a);
    const Face face_b = face_of(b, known.face_b, at_b);
    // Of shapes that lie on each other, each one's face is the edge that faces the other's.
    if (face_each_other(known)) return collide_faces(face_a, face_b, face_b, face_a, origin, near);
    return collide_faces(face_a, face_of(b, known.facing_b, at_b), face_b, face_of(a, known.facing_a, at_a), origin, near);
}

template <int blocks, class A, class B>
LocalManifold collide_as_hulls(const A& shape_a, const B& shape_b, Vec2 origin, const Transform& b_in_a, const Nearness& near)
{
    Hull<blocks> a;
    Hull<blocks> b;
    fill(a, shape_a, ShiftOnly{origin});
    fill(b, shape_b, MoveAndShift(b_in_a, origin));
    return collide_hulls(a, b, origin, near);
}

} // namespace

LocalManifold collide_polygons(const Polygon& a, const Polygon& b, const Transform& b_in_a, const Nearness& near)
{
    const Vec2 origin = origin_of(a);
    if (near.search.are_known) return collide_known(a, b, origin, b_in_a, near);
    if (a.count <= 4 && b.count <= 4) return collide_as_hulls<1>(a, b, origin, b_in_a, near);
    return collide_as_hulls<2>(a, b, origin, b_in_a, near);
}

LocalManifold collide_polygon_segment(const Polygon& a, const SegmentCore& b, const Transform& b_in_a, const Nearness& near)
{
    const Vec2 origin = origin_of(a);
    if (near.search.are_known) return collide_known(a, b, origin, b_in_a, near);
    if (a.count <= 4) return collide_as_hulls<1>(a, b, origin, b_in_a, near);
    return collide_as_hulls<2>(a, b, origin, b_in_a, near);
}

LocalManifold collide_segment_polygon(const SegmentCore& a, const Polygon& b, const Transform& b_in_a, const Nearness& near)
{
    const Vec2 origin = origin_of(a);
    if (near.search.are_known) return collide_known(a, b, origin, b_in_a, near);
    if (b.count <= 4) return collide_as_hulls<1>(a, b, origin, b_in_a, near);
    return collide_as_hulls<2>(a, b, origin, b_in_a, near);
}

} // namespace carom::detail
