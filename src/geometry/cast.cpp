// A cast of B against A is a ray from the origin against the difference A - B, grown by both radii. The boundary of that is made of
// edges, moved out by the radius, and of arcs around the corners; the ray meets the nearest of them first.
#include "geometry/cast.hpp"

#include "geometry/minkowski.hpp"

#include <algorithm>

namespace carom::detail
{

namespace
{

/// An edge counts as this much longer, as a share of its length, so that no ray slips through between an edge and its neighbour.
constexpr double seam = 1e-9;

/// The point of a segment that is nearest to the origin.
Vec2d foot_on_segment(Vec2d p1, Vec2d p2)
{
    const Vec2d edge = p2 - p1;
    const double along = -dot(p1, edge);
    const double length2 = dot(edge, edge);
    if (along <= 0) return p1;
    if (along >= length2) return p2;
    return p1 + (along / length2) * edge;
}

Vec2d foot_on_boundary(const MinkowskiHull& hull)
{
    Vec2d best = hull.corner(0).position;
    for (int i = 0; i < hull.count; ++i)
    {
        const Vec2d foot = foot_on_segment(hull.corner(i).position, hull.next(i).position);
        if (dot(foot, foot) < dot(best, best)) best = foot;
    }
    return best;
}

/// How the ray starts.
struct Start
{
    enum class Kind
    {
        Outside,
        Touching,
        Inside
    };
    Kind kind = Kind::Outside;
    bool goes_in = false; ///< when touching: the sweep leads into the surface
    Vec2d normal;         ///< when touching
};

/// A cosine this small between the sweep and the surface is rounding.
bool goes_into(Vec2d normal, Vec2d sweep) { return dot(normal, sweep) < -1e-7 * length(sweep); }

/// The faces that the origin lies in front of, or behind by no more than the touch distance.
struct Faces
{
    double distance = -1e300; ///< to the plane of the one that is farthest behind the origin [m]
    Vec2d normal;             ///< of that one
    bool goes_in = true;      ///< the sweep leads into all of them
};

/// @param touch the touch distance [m]
Faces faces_of(const MinkowskiHull& hull, Vec2d sweep, double touch)
{
    Faces faces;
    for (int i = 0; i < hull.count; ++i)
    {
        const Vec2d edge = hull.next(i).position - hull.corner(i).position;
        if (!(dot(edge, edge) > 0)) continue;
        const Vec2d normal = unit(right_perp(edge));
        const double distance = -dot(normal, hull.corner(i).position);
        if (distance >= -touch && !goes_into(normal, sweep)) faces.goes_in = false;
        if (distance <= faces.distance) continue;
        faces.distance = distance;
        faces.normal = normal;
    }
    return faces;
}

/// Near a corner without a radius the direction from the corner is rounding, so there the faces decide: what goes along or away from one of
/// them does not go in. A segment has a face on each side, and so nothing that starts on it goes into it.
Start start_of(const MinkowskiHull& hull, double radius, Vec2d sweep, double touch)
{
    const Faces faces = faces_of(hull, sweep, touch);
    const bool has_faces = faces.distance > -1e300;
    if (has_faces && faces.distance - radius > touch) return {};
    if (has_faces && faces.distance < -touch) return {Start::Kind::Inside, false, {}};

    const Vec2d foot = foot_on_boundary(hull);
    const double core_distance = length(foot);
    if (core_distance - radius > touch) return {};
    if (core_distance - radius < -touch) return {Start::Kind::Inside, false, {}};
    if (core_distance <= touch) return {Start::Kind::Touching, faces.goes_in, faces.normal};
    const Vec2d normal = (-1 / core_distance) * foot;
    return {Start::Kind::Touching, goes_into(normal, sweep), normal};
}

/// The part of the boundary that the ray meets first.
struct Hit
{
    double fraction = 1;
    Vec2d normal;
    int corner = -1; ///< of the hull; the edge that starts there, when it is one
    bool is_edge = false;
};

void try_edge(const MinkowskiHull& hull, int i, double radius, Vec2d sweep, Hit& best)
{
    const Vec2d start = hull.corner(i).position;
    const Vec2d edge = hull.next(i).position - start;
    const double length2 = dot(edge, edge);
    if (!(length2 > 0)) return;
    const Vec2d normal = unit(right_perp(edge));
    const double approach = -dot(normal, sweep);
    const double distance = -dot(normal, start) - radius;
    if (!(approach > 0) || distance < 0 || distance > best.fraction * approach) return;
    const double fraction = distance / approach;
    const double along = dot(fraction * sweep - start, edge);
    if (along < -seam * length2 || along > (1 + seam) * length2) return;
    best = {fraction, normal, i, true};
}

void try_corner(const MinkowskiHull& hull, int i, double radius, Vec2d sweep, Hit& best)
{
    const Vec2d center = hull.corner(i).position;
    const double sweep2 = dot(sweep, sweep);
    const double aside = cross(sweep, center);
    const double rest = radius * radius * sweep2 - aside * aside;
    if (!(sweep2 > 0) || rest < 0) return;
    const double fraction = (dot(sweep, center) - std::sqrt(rest)) / sweep2;
    if (fraction < 0 || fraction > best.fraction || (best.corner >= 0 && fraction == best.fraction)) return;
    const Vec2d out = fraction * sweep - center; // with no radius there is only the way that the ray came
    best = {fraction, radius > 0 ? unit(out) : -unit(sweep), i, false};
}

/// What the ray from the origin along `sweep` does to the hull; nothing is known of points yet.
struct HullCast
{
    enum class Kind
    {
        Miss,
        StartsInside,
        Hit
    };
    Kind kind = Kind::Miss;
    Hit hit;
};

HullCast cast_at_hull(const MinkowskiHull& hull, double radius, Vec2d sweep, double touch)
{
    const Start start = start_of(hull, radius, sweep, touch);
    if (start.kind == Start::Kind::Inside) return {HullCast::Kind::StartsInside, {}};
    if (start.kind == Start::Kind::Touching)
    {
        return start.goes_in ? HullCast{HullCast::Kind::Hit, {0, start.normal, -1, false}} : HullCast{};
    }
    Hit best;
    for (int i = 0; i < hull.count; ++i) try_edge(hull, i, radius, sweep, best);
    for (int i = 0; i < hull.count; ++i) try_corner(hull, i, radius, sweep, best);
    return best.corner < 0 ? HullCast{} : HullCast{HullCast::Kind::Hit, best};
}

float to_fraction(double fraction) { return static_cast<float>(std::clamp(fraction, 0.0, 1.0)); }

/// The point of A's surface that B meets: on an edge of A it is under B's corner, else it is a corner of A.
Vec2 meeting_point(const ConvexPoints& a, const ConvexPoints& b, const Transform& b_in_a, const MinkowskiHull& hull, const Hit& hit,
                   Vec2d sweep)
{
    const MinkowskiCorner& corner = hull.corner(hit.corner);
    if (hit.is_edge && corner.index_a != hull.next(hit.corner).index_a)
    {
        const Vec2d on_b = rotated(b_in_a.q, Vec2d(b.points[static_cast<std::size_t>(corner.index_b)])) + Vec2d(b_in_a.p);
        return to_float(on_b + hit.fraction * sweep - double{b.radius} * hit.normal);
    }
    return to_float(Vec2d(a.points[static_cast<std::size_t>(corner.index_a)]) + double{a.radius} * hit.normal);
}

} // namespace

std::optional<CastResult> cast_ray(const ConvexPoints& shape, Vec2 start, Vec2 sweep, const Tolerances& tolerances)
{
    const HullCast cast = cast_at_hull(minkowski_difference(shape, start), shape.radius, Vec2d(sweep), double{tolerances.touch_distance});
    if (cast.kind == HullCast::Kind::Miss) return std::nullopt;
    if (cast.kind == HullCast::Kind::StartsInside) return CastResult{0, {}, start, true};
    return CastResult{to_fraction(cast.hit.fraction), to_float(cast.hit.normal), to_float(Vec2d(start) + cast.hit.fraction * Vec2d(sweep)),
                      false};
}

std::optional<CastResult> cast_ray(const Geometry& shape, Vec2 start, Vec2 sweep, const Tolerances& tolerances)
{
    return cast_ray(convex_points(shape), start, sweep, tolerances);
}

std::optional<CastResult> cast_shape(const ConvexPoints& a, const ConvexPoints& b, const Transform& b_in_a, Vec2 sweep,
                                     const Tolerances& tolerances)
{
    const MinkowskiHull hull = minkowski_difference(a, b, b_in_a);
    const HullCast cast = cast_at_hull(hull, double{a.radius} + double{b.radius}, Vec2d(sweep), double{tolerances.touch_distance});
    if (cast.kind == HullCast::Kind::Miss) return std::nullopt;
    const bool starts_inside = cast.kind == HullCast::Kind::StartsInside;
    if (starts_inside || cast.hit.corner < 0) // already there: GJK knows where
    {
        const DistanceResult nearest = distance(a, b, b_in_a);
        return CastResult{0, starts_inside ? Vec2{} : to_float(cast.hit.normal), nearest.point_a, starts_inside};
    }
    return CastResult{to_fraction(cast.hit.fraction), to_float(cast.hit.normal), meeting_point(a, b, b_in_a, hull, cast.hit, Vec2d(sweep)),
                      false};
}

} // namespace carom::detail
