// Whoever has its middle behind the segment is on its way through, and stays so until it is in front and clear.
#include "dynamics/one_sided.hpp"

#include "geometry/surface.hpp"

#include <algorithm>

namespace carom::detail
{

namespace
{

bool is_clear(const LocalManifold& manifold)
{
    float deepest = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) deepest = std::min(deepest, manifold.points[i].separation);
    return deepest >= -linear_slop;
}

/// @param other in the segment's frame
bool is_behind(const ConvexPoints& segment, const ConvexPoints& other)
{
    const Edge face = face_of(segment, 0); // its normal is to the right
    return dot(normal_of(face), middle_of(other) - face.v1) < 0;
}

/// The contact of a one-sided segment with what is before it, in the segment's frame.
LocalManifold front_only(const LocalManifold& manifold, Contact& contact, const ConvexPoints& segment, const ConvexPoints& other,
                         bool segment_is_b)
{
    const Vec2 front = normal_of(face_of(segment, 0));
    if (is_behind(segment, other))
        contact.is_passing = true;
    else if (is_clear(manifold))
        contact.is_passing = false;
    if (contact.is_passing || manifold.count == 0) return {};

    const float forwards = dot(front, segment_is_b ? -manifold.normal : manifold.normal);
    if (forwards > 0) return manifold;
    return collide_on_face(segment, 0, other, 0, segment_is_b, speculative_distance).manifold;
}

} // namespace

LocalManifold keep_front(const LocalManifold& manifold, Contact& contact, const BodyStore& bodies, const ShapeStore& shapes)
{
    const bool a_is_one_sided = shapes.records[contact.shape_a].is_one_sided;
    const bool b_is_one_sided = shapes.records[contact.shape_b].is_one_sided;
    if (!a_is_one_sided && !b_is_one_sided) return manifold;

    const Transform& frame_a = bodies.poses[contact.body_a].transform;
    const Transform& frame_b = bodies.poses[contact.body_b].transform;
    const ConvexPoints a = convex_points(shapes.geometry[contact.shape_a]);
    const ConvexPoints b = convex_points(shapes.geometry[contact.shape_b]);
    const Transform b_in_a = relative(frame_a, frame_b);
    if (a_is_one_sided) return front_only(manifold, contact, a, moved(b, b_in_a), false);
    const Transform a_in_b = relative(frame_b, frame_a);
    return moved(front_only(moved(manifold, a_in_b), contact, b, moved(a, a_in_b), true), b_in_a);
}

bool comes_from_behind(const ShapeStore& shapes, std::uint32_t shape_a, std::uint32_t shape_b, const Transform& b_in_a)
{
    const bool a_is_one_sided = shapes.records[shape_a].is_one_sided;
    if (!a_is_one_sided && !shapes.records[shape_b].is_one_sided) return false;
    const ConvexPoints a = convex_points(shapes.geometry[shape_a]);
    const ConvexPoints b = moved(convex_points(shapes.geometry[shape_b]), b_in_a);
    return a_is_one_sided ? is_behind(a, b) : is_behind(b, a);
}

} // namespace carom::detail
