// A shape S whose middle is behind the segment passes through it. It goes on passing until its middle is in front and S is clear of the
// segment. What does not pass is pushed forwards or along the segment, never backwards.
#include "dynamics/one_sided.hpp"

#include "geometry/surface.hpp"

#include <algorithm>
#include <utility>

namespace carom::detail
{

namespace
{

bool is_clear(const LocalManifold& manifold, float slop)
{
    float deepest = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i) deepest = std::min(deepest, manifold.points[i].separation);
    return deepest >= -slop;
}

/// @param other in the segment's frame
bool has_middle_behind(const ConvexPoints& segment, const ConvexPoints& other)
{
    const Edge face = face_of(segment, 0); // its normal is to the right
    return dot(normal_of(face), middle_of(other) - face.v1) < 0;
}

/// The contact that pushes S along the segment and off one of its ends.
/// @param end    0: the segment's first point, 1: the second
/// @param margin [m]
LocalManifold push_off_end(const ConvexPoints& segment, std::size_t end, const ConvexPoints& other, bool segment_is_b, float margin)
{
    const Vec2 corner = segment.points[end];
    const Vec2 outward = normalize(corner - segment.points[1 - end]);
    std::size_t farthest = 0;
    for (std::size_t i = 1; i < static_cast<std::size_t>(other.count); ++i)
    {
        if (dot(outward, other.points[i] - other.points[farthest]) < 0) farthest = i;
    }
    const float separation = dot(outward, other.points[farthest] - corner) - other.radius;
    const auto [index, other_index] = std::pair(static_cast<std::uint32_t>(end), static_cast<std::uint32_t>(farthest));
    LocalManifold manifold;
    if (separation > margin) return manifold;
    manifold.normal = segment_is_b ? -outward : outward;
    manifold.count = 1;
    manifold.points[0] = {corner + 0.5f * separation * outward, separation,
                          segment_is_b ? feature_of(other_index, index) : feature_of(index, other_index)};
    return manifold;
}

/// The contact of a one-sided segment with a shape S in front of it, in the segment's frame. Where the least overlap would push S backwards,
/// S is pushed over the front or off the end, whichever takes less.
LocalManifold front_only(const LocalManifold& manifold, Contact& contact, const ConvexPoints& segment, const ConvexPoints& other,
                         bool segment_is_b, const Tolerances& tolerances)
{
    const Vec2 front = normal_of(face_of(segment, 0));
    if (has_middle_behind(segment, other))
        contact.is_passing = true;
    else if (is_clear(manifold, tolerances.linear_slop))
        contact.is_passing = false;
    if (contact.is_passing || manifold.count == 0) return {};

    const Vec2 outward = segment_is_b ? -manifold.normal : manifold.normal;
    if (dot(front, outward) > 0) return manifold;
    const FaceContact over_front = collide_on_face(segment, 0, other, 0, segment_is_b, tolerances.speculative_distance);
    const std::size_t end = dot(outward, segment.points[1] - segment.points[0]) > 0 ? 1 : 0;
    const LocalManifold over_end = push_off_end(segment, end, other, segment_is_b, tolerances.speculative_distance);
    const bool is_end_better = over_end.count == 0 || over_end.points[0].separation > over_front.face_separation;
    return is_end_better ? over_end : over_front.manifold;
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
    if (a_is_one_sided) return front_only(manifold, contact, a, moved(b, b_in_a), false, shapes.tolerances);
    const Transform a_in_b = relative(frame_b, frame_a);
    return moved(front_only(moved(manifold, a_in_b), contact, b, moved(a, a_in_b), true, shapes.tolerances), b_in_a);
}

bool comes_from_behind(const ShapeStore& shapes, std::uint32_t shape_a, std::uint32_t shape_b, const Transform& b_in_a)
{
    const bool a_is_one_sided = shapes.records[shape_a].is_one_sided;
    if (!a_is_one_sided && !shapes.records[shape_b].is_one_sided) return false;
    const ConvexPoints a = convex_points(shapes.geometry[shape_a]);
    const ConvexPoints b = moved(convex_points(shapes.geometry[shape_b]), b_in_a);
    return a_is_one_sided ? has_middle_behind(a, b) : has_middle_behind(b, a);
}

} // namespace carom::detail
