// GJK: walks towards the point of the Minkowski difference B - A that is nearest to the origin, with at most three corners in hand.
// @source E. G. Gilbert, D. W. Johnson, S. S. Keerthi, "A fast procedure for computing the distance between complex objects in
//         three-dimensional space", 1988; C. Ericson, "Real-Time Collision Detection", 2004, chapters 5 and 9
#include "geometry/distance.hpp"

#include <algorithm>
#include <variant>

namespace carom::detail
{

namespace
{

/// Convex polygons of at most 8 corners each need no more than a handful of steps; this bounds cycles that rounding might make.
constexpr int max_iterations = 20;

/// A corner of B - A and the corners that it comes from.
struct SupportPoint
{
    Vec2 on_a;
    Vec2 on_b;
    Vec2 w; ///< on_b - on_a
    int index_a = 0;
    int index_b = 0;
    float weight = 0; ///< barycentric, of the point nearest to the origin
};

struct Simplex
{
    std::array<SupportPoint, 3> corners;
    int count = 0;
};

int support(const ConvexPoints& shape, Vec2 direction)
{
    int best = 0;
    float most = dot(shape.points[0], direction);
    for (int i = 1; i < shape.count; ++i)
    {
        const float d = dot(shape.points[static_cast<std::size_t>(i)], direction);
        if (d > most)
        {
            most = d;
            best = i;
        }
    }
    return best;
}

/// The corner of B - A that lies farthest along `direction`.
SupportPoint support(const ConvexPoints& a, const ConvexPoints& b, Vec2 direction)
{
    SupportPoint point;
    point.index_a = support(a, -direction);
    point.index_b = support(b, direction);
    point.on_a = a.points[static_cast<std::size_t>(point.index_a)];
    point.on_b = b.points[static_cast<std::size_t>(point.index_b)];
    point.w = point.on_b - point.on_a;
    return point;
}

void keep(Simplex& simplex, int i, float weight_i)
{
    simplex.corners[0] = simplex.corners[static_cast<std::size_t>(i)];
    simplex.corners[0].weight = weight_i;
    simplex.count = 1;
}

void keep(Simplex& simplex, int i, int j, float along_i, float along_j)
{
    const SupportPoint first = simplex.corners[static_cast<std::size_t>(i)];
    const SupportPoint second = simplex.corners[static_cast<std::size_t>(j)];
    simplex.corners[0] = first;
    simplex.corners[1] = second;
    simplex.corners[0].weight = along_i / (along_i + along_j);
    simplex.corners[1].weight = along_j / (along_i + along_j);
    simplex.count = 2;
}

/// Shares of the ends of the segment from u to v at the foot of the origin, not divided by their sum |v - u|^2.
struct SegmentShares
{
    float u;
    float v;
};

SegmentShares shares(Vec2 u, Vec2 v)
{
    const Vec2 e = v - u;
    return {dot(v, e), -dot(u, e)};
}

void reduce_segment(Simplex& simplex)
{
    const SegmentShares s = shares(simplex.corners[0].w, simplex.corners[1].w);
    if (s.v <= 0) return keep(simplex, 0, 1);
    if (s.u <= 0) return keep(simplex, 1, 1);
    keep(simplex, 0, 1, s.u, s.v);
}

/// Voronoi regions of the triangle: its corners, its edges, its inside.
void reduce_triangle(Simplex& simplex)
{
    const Vec2 w0 = simplex.corners[0].w;
    const Vec2 w1 = simplex.corners[1].w;
    const Vec2 w2 = simplex.corners[2].w;
    const SegmentShares s01 = shares(w0, w1);
    const SegmentShares s12 = shares(w1, w2);
    const SegmentShares s20 = shares(w2, w0);
    const float area = cross(w1 - w0, w2 - w0);
    // Areas of the triangles that the origin forms with the opposite edges, signed so that all are positive when it is inside.
    const float a0 = area * cross(w1, w2);
    const float a1 = area * cross(w2, w0);
    const float a2 = area * cross(w0, w1);

    if (s01.v <= 0 && s20.u <= 0) return keep(simplex, 0, 1);
    if (s01.u <= 0 && s12.v <= 0) return keep(simplex, 1, 1);
    if (s12.u <= 0 && s20.v <= 0) return keep(simplex, 2, 1);
    if (s01.u > 0 && s01.v > 0 && a2 <= 0) return keep(simplex, 0, 1, s01.u, s01.v);
    if (s12.u > 0 && s12.v > 0 && a0 <= 0) return keep(simplex, 1, 2, s12.u, s12.v);
    if (s20.u > 0 && s20.v > 0 && a1 <= 0) return keep(simplex, 2, 0, s20.u, s20.v);

    const float sum = a0 + a1 + a2;
    if (!(sum > 0)) return keep(simplex, 2, 1); // no area left in float: the shapes touch within rounding
    simplex.corners[0].weight = a0 / sum;
    simplex.corners[1].weight = a1 / sum;
    simplex.corners[2].weight = a2 / sum;
}

void reduce(Simplex& simplex)
{
    if (simplex.count == 1) simplex.corners[0].weight = 1;
    if (simplex.count == 2)
        reduce_segment(simplex);
    else if (simplex.count == 3)
        reduce_triangle(simplex);
}

/// Where on B - A the origin is nearest to.
struct NearestPoint
{
    Vec2 normal;        ///< unit, from the origin to the point; (0, 0) when the simplex holds the origin
    float distance = 0; ///< [m]
};

/// Of an edge, the normal is taken from the edge: near the origin, the point itself has no digits left to give a direction.
NearestPoint nearest_point(const Simplex& simplex)
{
    if (simplex.count == 3) return {};
    const Vec2 w0 = simplex.corners[0].w;
    Vec2 normal = normalize(w0);
    if (simplex.count == 2)
    {
        normal = normalize(left_perp(simplex.corners[1].w - w0));
        if (dot(normal, w0) < 0) normal = -normal;
    }
    const float distance = dot(normal, w0);
    return distance > 0 ? NearestPoint{normal, distance} : NearestPoint{};
}

bool has(const Simplex& simplex, const SupportPoint& point)
{
    for (int i = 0; i < simplex.count; ++i)
    {
        const SupportPoint& corner = simplex.corners[static_cast<std::size_t>(i)];
        if (corner.index_a == point.index_a && corner.index_b == point.index_b) return true;
    }
    return false;
}

/// Moves both shapes so that A's first point is the origin; there, distances keep their digits.
ConvexPoints placed(const ConvexPoints& shape, Rot q, Vec2 shift)
{
    ConvexPoints result = shape;
    for (int i = 0; i < shape.count; ++i)
    {
        Vec2& p = result.points[static_cast<std::size_t>(i)];
        p = rotate(q, p) + shift;
    }
    return result;
}

DistanceResult result_of(const Simplex& simplex, const NearestPoint& nearest, float radius_a, float radius_b, Vec2 origin)
{
    DistanceResult result;
    for (int i = 0; i < simplex.count; ++i)
    {
        const SupportPoint& corner = simplex.corners[static_cast<std::size_t>(i)];
        result.point_a += corner.weight * corner.on_a;
        result.point_b += corner.weight * corner.on_b;
    }
    result.point_a += origin + radius_a * nearest.normal;
    result.point_b += origin - radius_b * nearest.normal;
    result.normal = nearest.normal;
    result.distance = std::max(0.0f, nearest.distance - radius_a - radius_b);
    return result;
}

/// Ends when no corner of B - A lies nearer to the origin along the current normal than the simplex itself, within rounding.
DistanceResult gjk(const ConvexPoints& a, const ConvexPoints& b, Vec2 origin)
{
    constexpr float rounding = 1e-6f;
    Simplex simplex;
    simplex.corners[0] = support(a, b, a.points[0] - b.points[0]);
    simplex.count = 1;
    reduce(simplex);
    NearestPoint nearest = nearest_point(simplex);
    int iterations = 0;
    while (nearest.distance > 0 && iterations < max_iterations)
    {
        ++iterations;
        const SupportPoint next = support(a, b, -nearest.normal);
        if (has(simplex, next) || dot(nearest.normal, next.w) >= (1 - rounding) * nearest.distance) break;

        Simplex larger = simplex;
        larger.corners[static_cast<std::size_t>(larger.count++)] = next;
        reduce(larger);
        const NearestPoint nearer = nearest_point(larger);
        if (nearer.distance >= nearest.distance) break; // rounding: no way down any more
        simplex = larger;
        nearest = nearer;
    }
    DistanceResult result = result_of(simplex, nearest, a.radius, b.radius, origin);
    result.iterations = iterations;
    return result;
}

} // namespace

ConvexPoints convex_points(const Geometry& geometry)
{
    ConvexPoints points;
    if (const Polygon* polygon = std::get_if<Polygon>(&geometry)) return {polygon->vertices, polygon->count, polygon->radius};
    if (const Circle* circle = std::get_if<Circle>(&geometry))
    {
        points.points[0] = circle->center;
        points.count = 1;
        points.radius = circle->radius;
    }
    if (const Capsule* capsule = std::get_if<Capsule>(&geometry))
    {
        points.points[0] = capsule->p1;
        points.points[1] = capsule->p2;
        points.count = 2;
        points.radius = capsule->radius;
    }
    if (const Segment* segment = std::get_if<Segment>(&geometry))
    {
        points.points[0] = segment->p1;
        points.points[1] = segment->p2;
        points.count = 2;
    }
    return points;
}

DistanceResult distance(const ConvexPoints& a, const ConvexPoints& b, const Transform& b_in_a)
{
    const Vec2 origin = a.points[0];
    return gjk(placed(a, {}, -origin), placed(b, b_in_a.q, b_in_a.p - origin), origin);
}

namespace
{

/// Whether a corner of the points lies well within a distance of a place: a cheap reason for overlap.
bool has_corner_near(const ConvexPoints& points, Vec2 place, float reach)
{
    constexpr float share = 0.999f; // what is nearer to the edge is left to the exact distance
    for (int i = 0; i < points.count; ++i)
        if (length_squared(points.points[static_cast<std::size_t>(i)] - place) < share * reach * reach) return true;
    return false;
}

} // namespace

bool overlap(const Geometry& a, const Geometry& b, const Transform& b_in_a, const Tolerances& tolerances)
{
    const ConvexPoints points_a = convex_points(a);
    const ConvexPoints points_b = convex_points(b);
    const float reach = points_a.radius + points_b.radius;
    if (points_b.count == 1 && has_corner_near(points_a, b_in_a * points_b.points[0], reach)) return true;
    if (points_a.count == 1 && has_corner_near(points_b, inverse_transform(b_in_a, points_a.points[0]), reach)) return true;
    return distance(points_a, points_b, b_in_a).distance <= tolerances.touch_distance;
}

} // namespace carom::detail
