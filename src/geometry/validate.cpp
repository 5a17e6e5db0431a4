// The conditions that a shape must meet, and what to tell a user whose shape does not.
#include "geometry/validate.hpp"
#include "geometry/mass.hpp"
#include "geometry/vec2d.hpp"
#include "math/usage_error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <variant>

namespace carom::detail
{

namespace
{

/// Corners that were just far enough apart may have been rounded a little closer by a rotation.
double least_distance(const Tolerances& tolerances) { return 0.999 * double{tolerances.min_edge_length}; }

/// How far a normal may be from the true one; users may have computed theirs in another way.
constexpr double normal_tolerance = 1e-3;

/// Whose shape it is. Names are put together only on failure: the checks themselves must not allocate.
struct Subject
{
    std::string_view function;
    std::string_view prefix;

    std::string field(std::string_view name) const { return std::string(prefix).append(name); }
    std::string field(std::string_view name, int index) const { return field(name) + "[" + std::to_string(index) + "]"; }
};

bool is_within_reach(Vec2 v) { return std::abs(v.x) <= max_coordinate && std::abs(v.y) <= max_coordinate; }

void check_point(const Subject& subject, std::string_view name, Vec2 point)
{
    if (!is_within_reach(point)) require_within(subject.function, subject.field(name), point, max_coordinate);
}

void check_radius(const Subject& subject, float radius, bool may_be_zero)
{
    const bool is_good = (may_be_zero ? radius >= 0 : radius > 0) && radius <= max_coordinate;
    if (is_good) return;
    const std::string field = subject.field("radius");
    require_finite(subject.function, field, radius);
    if (may_be_zero) require_range(subject.function, field, radius, 0.0f, max_coordinate);
    usage_error(subject.function, field, radius, "give a value greater than 0 and not above 1e+06");
}

void check_ends(const Subject& subject, Vec2 p1, Vec2 p2, const Tolerances& tolerances)
{
    check_point(subject, "p1", p1);
    check_point(subject, "p2", p2);
    if (length(Vec2d(p2) - Vec2d(p1)) < least_distance(tolerances))
    {
        usage_error(subject.function, subject.field("p2"), p2,
                    "give ends that are at least " + least_size_text(tolerances.min_edge_length, tolerances) + " apart");
    }
}

/// Radii far below a nanometre have an area that float can't hold.
void check_mass(const Subject& subject, const AreaMoments& moments, float radius)
{
    constexpr double least = std::numeric_limits<float>::min();
    constexpr double most = std::numeric_limits<float>::max();
    if (moments.area >= least && moments.polar >= least && moments.area <= most && moments.polar <= most) return;
    usage_error(subject.function, subject.field("radius"), radius, "give a shape whose mass and inertia are neither zero nor infinite");
}

std::size_t next_index(const Polygon& polygon, std::size_t i) { return i + 1 < static_cast<std::size_t>(polygon.count) ? i + 1 : 0; }

/// Every corner lies left of every edge that it does not end. Then each edge is an edge of the convex hull, in its direction, and so the
/// polygon is the hull: no separate test of crossings or of the winding is needed.
void check_convexity(const Subject& subject, const Polygon& polygon, const Tolerances& tolerances)
{
    const std::size_t count = static_cast<std::size_t>(polygon.count);
    for (std::size_t i = 0; i < count; ++i)
    {
        const std::size_t next = next_index(polygon, i);
        const Vec2d start(polygon.vertices[i]);
        const Vec2d edge = Vec2d(polygon.vertices[next]) - start;
        const double edge_length = length(edge);
        if (edge_length < least_distance(tolerances))
        {
            usage_error(subject.function, subject.field("vertices", static_cast<int>(next)), polygon.vertices[next],
                        "give vertices that are at least " + least_size_text(tolerances.min_edge_length, tolerances) + " apart");
        }
        for (std::size_t j = 0; j < count; ++j)
        {
            if (j == i || j == next || cross(edge, Vec2d(polygon.vertices[j]) - start) >= tolerances.least_convexity * edge_length)
                continue;
            usage_error(subject.function, subject.field("vertices", static_cast<int>(j)), polygon.vertices[j],
                        "give the corners of a convex polygon counter-clockwise, or use convex_hull()");
        }
    }
}

void check_normals(const Subject& subject, const Polygon& polygon)
{
    for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i)
    {
        const Vec2d edge = Vec2d(polygon.vertices[next_index(polygon, i)]) - Vec2d(polygon.vertices[i]);
        const Vec2d error = Vec2d(polygon.normals[i]) - unit(right_perp(edge));
        if (dot(error, error) <= normal_tolerance * normal_tolerance) continue;
        usage_error(subject.function, subject.field("normals", static_cast<int>(i)), polygon.normals[i],
                    "give the outward unit normal of the edge, or use convex_hull()");
    }
}

void check_centroid(const Subject& subject, const Polygon& polygon, const Tolerances& tolerances)
{
    check_point(subject, "centroid", polygon.centroid);
    Aabb bounds = {polygon.vertices[0], polygon.vertices[0]};
    for (std::size_t i = 1; i < static_cast<std::size_t>(polygon.count); ++i)
    {
        bounds = merge(bounds, {polygon.vertices[i], polygon.vertices[i]});
    }
    if (contains(expanded(bounds, tolerances.min_edge_length), polygon.centroid)) return;
    usage_error(subject.function, subject.field("centroid"), polygon.centroid, "give the centre of the area, or use convex_hull()");
}

} // namespace

void validate(const Circle& circle, std::string_view function, std::string_view prefix)
{
    const Subject subject = {function, prefix};
    check_point(subject, "center", circle.center);
    check_radius(subject, circle.radius, false);
    check_mass(subject, moments_of(circle), circle.radius);
}

void validate(const Capsule& capsule, std::string_view function, std::string_view prefix, const Tolerances& tolerances)
{
    const Subject subject = {function, prefix};
    check_ends(subject, capsule.p1, capsule.p2, tolerances);
    check_radius(subject, capsule.radius, false);
    check_mass(subject, moments_of(capsule), capsule.radius);
}

void validate(const Segment& segment, std::string_view function, std::string_view prefix, const Tolerances& tolerances)
{
    check_ends({function, prefix}, segment.p1, segment.p2, tolerances);
}

void validate(const Polygon& polygon, std::string_view function, std::string_view prefix, const Tolerances& tolerances)
{
    const Subject subject = {function, prefix};
    if (polygon.count < 3 || polygon.count > max_polygon_vertices)
    {
        require_range(function, subject.field("count"), polygon.count, 3, max_polygon_vertices);
    }
    check_radius(subject, polygon.radius, true);
    for (int i = 0; i < polygon.count; ++i)
    {
        const Vec2 vertex = polygon.vertices[static_cast<std::size_t>(i)];
        if (!is_within_reach(vertex)) require_within(function, subject.field("vertices", i), vertex, max_coordinate);
    }
    check_convexity(subject, polygon, tolerances);
    check_normals(subject, polygon);
    check_centroid(subject, polygon, tolerances);
    check_mass(subject, moments_of(polygon), polygon.radius);
}

std::string least_size_text(float length, const Tolerances& tolerances)
{
    std::array<char, 32> digits = {};
    const float millimetres = 1000 * length;
    const std::to_chars_result end = std::to_chars(digits.data(), digits.data() + digits.size(), millimetres);
    std::string text = std::string(digits.data(), end.ptr) + " mm";
    if (tolerances.length_unit > 1) text += ", or make the world with a smaller length_unit,";
    return text;
}

void validate(const Geometry& geometry, std::string_view function, const Tolerances& tolerances)
{
    switch (geometry.index())
    {
    case 0: return validate(*std::get_if<Circle>(&geometry), function, "circle.");
    case 1: return validate(*std::get_if<Capsule>(&geometry), function, "capsule.", tolerances);
    case 2: return validate(*std::get_if<Segment>(&geometry), function, "segment.", tolerances);
    case 3: return validate(*std::get_if<Polygon>(&geometry), function, "polygon.", tolerances);
    default: usage_error(function, "geometry", "without a value", "give a shape");
    }
}

void validate(const Transform& transform, std::string_view function, std::string_view field)
{
    const Vec2 p = transform.p;
    if (!is_within_reach(p)) require_within(function, std::string(field) + ".p", p, max_coordinate);
    validate_rotation(transform.q, function, field);
}

void validate_rotation(Rot q, std::string_view function, std::string_view field)
{
    const float length2 = q.c * q.c + q.s * q.s;
    if (length2 > 0.999f && length2 < 1.001f) return;
    usage_error(function, std::string(field) + ".q", Vec2{q.c, q.s}, "give a unit rotation, as rotation() makes");
}

} // namespace carom::detail
