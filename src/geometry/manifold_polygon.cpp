// Polygons against polygons, and against capsules and segments as polygons of two corners.
//
// Separating axes: of two convex polygons that are apart, the normal of some face separates them; of two that overlap, the face
// that separates least badly gives the least way out. Around the circle of directions, the separation has a single hill wherever
// it is positive, so the best face normal is next to the true direction of the nearest points: those lie on the best face or at one of
// its ends, and on the facing edge of the other polygon. Two polygons of two corners have too few faces for that (manifold_segment.cpp).
#include "geometry/manifold_kernels.hpp"
#include "math/float4.hpp"

#include <cstring>

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
    const Vec2 right = place.direction(normalize(right_perp(core.p2 - core.p1))); // p1 and p2 may be one point after rounding
    hull.count = 2;
    hull.radius = core.radius;
    for (int k = 0; k < blocks; ++k)
    {
        hull.x.block[k] = Float4{p1.x, p2.x, p1.x, p1.x};
        hull.y.block[k] = Float4{p1.y, p2.y, p1.y, p1.y};
        hull.normal_x.block[k] = Float4{right.x, -right.x, right.x, right.x};
        hull.normal_y.block[k] = Float4{right.y, -right.y, right.y, right.y};
    }
}

struct BestFace
{
    int face;
    float separation; ///< of the cores [m]
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
    BestFace best = {0, separation.one[0]};
    for (int i = 1; i < Hull<blocks>::size; ++i)
    {
        if (separation.one[i] > best.separation) best = {i, separation.one[i]};
    }
    return best;
}

/// The edge of `other` that faces `normal` most squarely. It ends in the corner that is deepest behind the normal's face.
template <int blocks>
int facing_edge(const Hull<blocks>& other, Vec2 normal)
{
    Lanes<blocks> along;
    for (int k = 0; k < blocks; ++k)
    {
        along.block[k] = other.normal_x.block[k] * splat4(normal.x) + other.normal_y.block[k] * splat4(normal.y);
    }
    int best = 0;
    float least = along.one[0];
    for (int j = 1; j < Hull<blocks>::size; ++j)
    {
        if (along.one[j] >= least) continue;
        least = along.one[j];
        best = j;
    }
    return best;
}

template <int blocks>
EdgePair pair_of(const Hull<blocks>& reference, int face, const Hull<blocks>& other, int other_face, bool reference_is_b, Vec2 origin)
{
    return {
        reference.edge(face), other.edge(other_face), reference.normal(face), reference.radius, other.radius, reference_is_b, origin, 0};
}

/// Separated cores: which of the regions of the two edges holds the nearest points? The reference edge gets the nearest
/// corner w of the incident edge over it, or else the incident edge the end v of the reference edge, or else v and w are nearest.
///
///       w o----                  w o------                     w o----
///         .                      .                            /
///     ----+-----        ------o v                  ----o v
///     w over the face         v over w's face      corner to corner
template <int blocks>
LocalManifold touch_separated(const Hull<blocks>& reference, int face, const Hull<blocks>& other, int other_face, bool reference_is_b,
                              Vec2 origin, float margin)
{
    EdgePair pair = pair_of(reference, face, other, other_face, reference_is_b, origin);
    const Edge& v = pair.reference;
    const Edge& w = pair.incident;
    const Vec2 tangent = left_perp(pair.normal);
    const float h1 = dot(w.v1 - v.v1, pair.normal);
    const float h2 = dot(w.v2 - v.v1, pair.normal);
    const bool first = h1 < h2;
    const Vec2 corner = first ? w.v1 : w.v2;
    const float t = dot(corner - v.v1, tangent);
    pair.slack = corner_slack * (first ? h1 : h2);
    if (t >= -pair.slack && t <= dot(v.v2 - v.v1, tangent) + pair.slack) return clip(pair, margin);

    const bool is_lower_end = t < 0;
    const Vec2 end = is_lower_end ? v.v1 : v.v2;
    if (dot(end - corner, (first ? w.v2 : w.v1) - corner) > 0)
    {
        return clip(pair_of(other, other_face, reference, face, !reference_is_b, origin), margin);
    }
    return join_corners(pair, {end, corner, is_lower_end ? v.i1 : v.i2, first ? w.i1 : w.i2}, margin);
}

template <int blocks>
LocalManifold collide_hulls(const Hull<blocks>& a, const Hull<blocks>& b, Vec2 origin, const Nearness& near)
{
    const float reach = a.radius + b.radius + near.margin;
    const BestFace best_a = best_face(a, b);
    if (best_a.separation > reach) return {};
    const BestFace best_b = best_face(b, a);
    if (best_b.separation > reach) return {};

    const bool reference_is_b = best_b.separation > best_a.separation + near.tolerances.reference_preference;
    const Hull<blocks>& reference = reference_is_b ? b : a;
    const Hull<blocks>& other = reference_is_b ? a : b;
    const BestFace best = reference_is_b ? best_b : best_a;
    const int other_face = facing_edge(other, reference.normal(best.face));
    if (best.separation > near.tolerances.least_core_distance)
    {
        return touch_separated(reference, best.face, other, other_face, reference_is_b, origin, near.margin);
    }
    return clip(pair_of(reference, best.face, other, other_face, reference_is_b, origin), near.margin);
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
    const Vec2 origin = a.vertices[0];
    if (a.count <= 4 && b.count <= 4) return collide_as_hulls<1>(a, b, origin, b_in_a, near);
    return collide_as_hulls<2>(a, b, origin, b_in_a, near);
}

LocalManifold collide_polygon_segment(const Polygon& a, const SegmentCore& b, const Transform& b_in_a, const Nearness& near)
{
    const Vec2 origin = a.vertices[0];
    if (a.count <= 4) return collide_as_hulls<1>(a, b, origin, b_in_a, near);
    return collide_as_hulls<2>(a, b, origin, b_in_a, near);
}

LocalManifold collide_segment_polygon(const SegmentCore& a, const Polygon& b, const Transform& b_in_a, const Nearness& near)
{
    const Vec2 origin = a.p1;
    if (b.count <= 4) return collide_as_hulls<1>(a, b, origin, b_in_a, near);
    return collide_as_hulls<2>(a, b, origin, b_in_a, near);
}

} // namespace carom::detail
