// Makers of shapes, and what can be asked of a shape at a place: its bounds, and whether it holds a point.
#include "geometry/bounds.hpp"
#include "geometry/nearest.hpp"
#include "geometry/polygon.hpp"
#include "geometry/validate.hpp"
#include "math/usage_error.hpp"

#include <carom/shape.hpp>

#include <array>
#include <cmath>
#include <variant>

namespace carom
{

namespace
{

/// Half the least side of a box's inner part [m], a little less so that rounding does not refuse the limit itself.
float least_half_side(const detail::Tolerances& tolerances) { return 0.4999f * tolerances.min_edge_length; }

Polygon centered_box(float half_width, float half_height, float radius)
{
    Polygon polygon;
    polygon.vertices = {{{-half_width, -half_height}, {half_width, -half_height}, {half_width, half_height}, {-half_width, half_height}}};
    polygon.normals = {{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    polygon.radius = radius;
    polygon.count = 4;
    return polygon;
}

void check_sides(std::string_view function, float width, float height, const detail::Tolerances& tolerances)
{
    detail::require_range(function, "width", width, tolerances.min_edge_length, max_coordinate);
    detail::require_range(function, "height", height, tolerances.min_edge_length, max_coordinate);
}

/// Rounding of large coordinates may move corners, so normals and centroid are made anew from where the corners came to lie.
Polygon moved(const Polygon& polygon, const Transform& transform, std::string_view function, const detail::Tolerances& tolerances)
{
    std::array<Vec2, max_polygon_vertices> corners;
    const std::size_t count = static_cast<std::size_t>(polygon.count);
    for (std::size_t i = 0; i < count; ++i) corners[i] = transform * polygon.vertices[i];
    return detail::polygon_from_corners({corners.data(), count}, polygon.radius, function, tolerances);
}

Aabb bounds_around(Vec2 a, Vec2 b, float radius) { return expanded({min(a, b), max(a, b)}, radius); }

Aabb bounds_of_polygon(const Polygon& polygon, const Transform& transform)
{
    Vec2 lower = transform * polygon.vertices[0];
    Vec2 upper = lower;
    for (std::size_t i = 1; i < static_cast<std::size_t>(polygon.count); ++i)
    {
        const Vec2 v = transform * polygon.vertices[i];
        lower = min(lower, v);
        upper = max(upper, v);
    }
    return expanded({lower, upper}, polygon.radius);
}

} // namespace

Circle circle(float radius, Vec2 center)
{
    const Circle made = {center, radius};
    detail::validate(made, "circle", "");
    return made;
}

Capsule capsule(Vec2 p1, Vec2 p2, float radius, float length_unit)
{
    const Capsule made = {p1, p2, radius};
    detail::validate(made, "capsule", "", detail::tolerances_for(length_unit, "capsule"));
    return made;
}

Segment segment(Vec2 p1, Vec2 p2, float length_unit)
{
    const Segment made = {p1, p2};
    detail::validate(made, "segment", "", detail::tolerances_for(length_unit, "segment"));
    return made;
}

Polygon box(float width, float height, float length_unit)
{
    check_sides("box", width, height, detail::tolerances_for(length_unit, "box"));
    return centered_box(0.5f * width, 0.5f * height, 0);
}

Polygon rounded_box(float width, float height, float radius, float length_unit)
{
    const detail::Tolerances tolerances = detail::tolerances_for(length_unit, "rounded_box");
    check_sides("rounded_box", width, height, tolerances);
    detail::require_not_negative("rounded_box", "radius", radius);
    const float inner_half_width = 0.5f * width - radius;
    const float inner_half_height = 0.5f * height - radius;
    const float least = least_half_side(tolerances);
    if (!(inner_half_width >= least && inner_half_height >= least))
    {
        detail::usage_error("rounded_box", "radius", radius,
                            "give a radius less than half of the shorter side by at least " +
                                detail::least_size_text(0.5f * tolerances.min_edge_length, tolerances));
    }
    return centered_box(inner_half_width, inner_half_height, radius);
}

Polygon offset_box(float width, float height, Vec2 center, float angle, float length_unit)
{
    const detail::Tolerances tolerances = detail::tolerances_for(length_unit, "offset_box");
    check_sides("offset_box", width, height, tolerances);
    detail::require_within("offset_box", "center", center, max_coordinate);
    detail::require_finite("offset_box", "angle", angle);
    return moved(centered_box(0.5f * width, 0.5f * height, 0), {center, rotation(angle)}, "offset_box", tolerances);
}

Geometry transformed(const Geometry& geometry, const Transform& transform, float length_unit)
{
    const detail::Tolerances tolerances = detail::tolerances_for(length_unit, "transformed");
    detail::validate(geometry, "transformed", tolerances);
    detail::validate(transform, "transformed", "transform");
    if (const Polygon* p = std::get_if<Polygon>(&geometry)) return moved(*p, transform, "transformed", tolerances);

    Geometry result = geometry;
    if (Circle* c = std::get_if<Circle>(&result)) c->center = transform * c->center;
    if (Capsule* c = std::get_if<Capsule>(&result)) *c = {transform * c->p1, transform * c->p2, c->radius};
    if (Segment* s = std::get_if<Segment>(&result)) *s = {transform * s->p1, transform * s->p2};
    detail::validate(result, "transformed", tolerances);
    return result;
}

Aabb detail::bounds_of(const Geometry& geometry, const Transform& transform)
{
    if (const Polygon* p = std::get_if<Polygon>(&geometry)) return bounds_of_polygon(*p, transform);
    if (const Circle* c = std::get_if<Circle>(&geometry))
    {
        const Vec2 center = transform * c->center;
        return bounds_around(center, center, c->radius);
    }
    if (const Capsule* c = std::get_if<Capsule>(&geometry)) return bounds_around(transform * c->p1, transform * c->p2, c->radius);
    if (const Segment* s = std::get_if<Segment>(&geometry)) return bounds_around(transform * s->p1, transform * s->p2, 0);
    return {transform.p, transform.p}; // a variant without a value: never made by this engine
}

bool detail::holds(const Geometry& geometry, Vec2 local_point)
{
    if (const Polygon* p = std::get_if<Polygon>(&geometry)) return nearest_on_polygon(*p, local_point).distance <= p->radius;
    if (const Circle* c = std::get_if<Circle>(&geometry)) return distance(c->center, local_point) <= c->radius;
    if (const Capsule* c = std::get_if<Capsule>(&geometry)) return nearest_on_segment(c->p1, c->p2, local_point).distance <= c->radius;
    if (const Segment* s = std::get_if<Segment>(&geometry)) return nearest_on_segment(s->p1, s->p2, local_point).distance <= 0;
    return false;
}

Aabb aabb_of(const Geometry& geometry, const Transform& transform)
{
    detail::validate(geometry, "aabb_of", detail::any_world);
    detail::require_finite("aabb_of", "transform.p", transform.p); // a body may have gone beyond max_coordinate
    detail::validate_rotation(transform.q, "aabb_of", "transform");
    return detail::bounds_of(geometry, transform);
}

bool contains(const Geometry& geometry, Vec2 local_point)
{
    detail::validate(geometry, "contains", detail::any_world);
    detail::require_finite("contains", "local_point", local_point);
    return detail::holds(geometry, local_point);
}

} // namespace carom
