// Chooses the kernel for two shapes, and holds the kernels of circles.
#include "geometry/manifold.hpp"
#include "geometry/faces.hpp"
#include "geometry/nearest.hpp"

#include <variant>

namespace carom::detail
{

namespace
{

/// The one point between a circle and another shape. It needs no feature: there is never another one.
/// @param center          of the circle, in A's frame
/// @param normal          unit, from the other shape to the circle, in A's frame
/// @param center_distance from the other shape's core to the circle's centre; negative inside [m]
LocalManifold circle_contact(Vec2 center, Vec2 normal, float center_distance, float circle_radius, float other_radius, bool circle_is_a,
                             const Nearness& near)
{
    LocalManifold manifold;
    const float separation = center_distance - circle_radius - other_radius;
    if (separation > near.margin)
    {
        near.search.gap = separation - near.margin;
        return manifold;
    }
    manifold.normal = circle_is_a ? -normal : normal;
    manifold.count = 1;
    manifold.points[0].position = center - 0.5f * (center_distance + circle_radius - other_radius) * normal;
    manifold.points[0].separation = separation;
    return manifold;
}

LocalManifold collide_circles(const Circle& a, const Circle& b, const Transform& b_in_a, const Nearness& near)
{
    const Vec2 center = b_in_a * b.center;
    const Nearest nearest = nearest_from_foot(a.center, center, {0, 1});
    return circle_contact(center, nearest.normal, nearest.distance, b.radius, a.radius, false, near);
}

Nearest nearest_on(const Polygon& polygon, Vec2 point) { return nearest_on_polygon(polygon, point); }

Nearest nearest_on(const SegmentCore& core, Vec2 point) { return nearest_on_segment(core.p1, core.p2, point); }

template <class Other>
LocalManifold collide_with_circle(const Other& a, const Circle& b, const Transform& b_in_a, const Nearness& near)
{
    const Vec2 center = b_in_a * b.center;
    const Nearest nearest = nearest_on(a, center);
    return circle_contact(center, nearest.normal, nearest.distance, b.radius, a.radius, false, near);
}

/// The other shape has many points and the circle one, so the circle is taken to B's frame.
template <class Other>
LocalManifold collide_circle_with(const Circle& a, const Other& b, const Transform& b_in_a, const Nearness& near)
{
    const Nearest nearest = nearest_on(b, inverse_transform(b_in_a, a.center));
    return circle_contact(a.center, rotate(b_in_a.q, nearest.normal), nearest.distance, a.radius, b.radius, true, near);
}

LocalManifold collide_with(const Circle& a, const Geometry& b, const Transform& b_in_a, const Nearness& near)
{
    switch (b.index())
    {
    case 0: return collide_circles(a, *std::get_if<Circle>(&b), b_in_a, near);
    case 1: return collide_circle_with(a, core_of(*std::get_if<Capsule>(&b)), b_in_a, near);
    case 2: return collide_circle_with(a, core_of(*std::get_if<Segment>(&b)), b_in_a, near);
    default: return collide_circle_with(a, *std::get_if<Polygon>(&b), b_in_a, near);
    }
}

LocalManifold collide_with(const SegmentCore& a, const Geometry& b, const Transform& b_in_a, const Nearness& near)
{
    switch (b.index())
    {
    case 0: return collide_with_circle(a, *std::get_if<Circle>(&b), b_in_a, near);
    case 1: return collide_segments(a, core_of(*std::get_if<Capsule>(&b)), b_in_a, near);
    case 2: return collide_segments(a, core_of(*std::get_if<Segment>(&b)), b_in_a, near);
    default: return collide_segment_polygon(a, *std::get_if<Polygon>(&b), b_in_a, near);
    }
}

LocalManifold collide_with(const Polygon& a, const Geometry& b, const Transform& b_in_a, const Nearness& near)
{
    switch (b.index())
    {
    case 0: return collide_with_circle(a, *std::get_if<Circle>(&b), b_in_a, near);
    case 1: return collide_polygon_segment(a, core_of(*std::get_if<Capsule>(&b)), b_in_a, near);
    case 2: return collide_polygon_segment(a, core_of(*std::get_if<Segment>(&b)), b_in_a, near);
    default: return collide_polygons(a, *std::get_if<Polygon>(&b), b_in_a, near);
    }
}

} // namespace

LocalManifold collide(const Geometry& a, const Geometry& b, const Transform& b_in_a, float margin, const Tolerances& tolerances,
                      FaceSearch& search)
{
    search.lead = search.gap = 0;
    const Nearness near = {margin, tolerances, search};
    switch (a.index())
    {
    case 0: return collide_with(*std::get_if<Circle>(&a), b, b_in_a, near);
    case 1: return collide_with(core_of(*std::get_if<Capsule>(&a)), b, b_in_a, near);
    case 2: return collide_with(core_of(*std::get_if<Segment>(&a)), b, b_in_a, near);
    default: return collide_with(*std::get_if<Polygon>(&a), b, b_in_a, near);
    }
}

} // namespace carom::detail
