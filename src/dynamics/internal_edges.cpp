// A contact of shape S with tile T is judged against the other tiles T' of the same surface that are near S. They are found among S's
// other contacts, for whatever is near S has one, or among the few shapes of T's body.
//
//            S                        S |  n                       S    n = (-0.7, 0.7)
//       _____|_______              _____|_<___ ___               ____ /____
//       |  T   | T'  |             |  T'  |  T  |                | T' | T  |
//    n is outward from the        n is the normal of a face      n points away from a corner of T that
//    surface: kept                of T that T' hides: dropped    T' shares, and T' lies in front: dropped
//
// A dropped contact is made again with a face of T that is no seam, if S is over that face (`second_choice`): a small thing that sinks into
// the floor at a seam is pushed up, not apart, and a ball over a gap of some millimetres rolls on as if it were not there.
#include "dynamics/internal_edges.hpp"

#include "dynamics/walks.hpp"
#include "geometry/surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace carom::detail
{

namespace
{

/// Normals nearer than this are those of a face [rad]: above rounding, below any corner that one would feel. At 50 m/s it lifts by 1 cm/s; ten
/// times as much is a bump of 1 mm. Terrain.nothing_bumps_on_tiles_that_are_bodies breaks.
constexpr float same_direction = 2e-4f;

/// Tilt up to which S's own face against T's corner becomes T's face against S's corner [rad]. Beyond it S rests on one of its corners.
constexpr float small_tilt = 0.1f;

/// The ground goes on beyond the end of a face when it falls off by no more than this [rad]. Only then may S be held up beside the face.
constexpr float flat_on = 0.01f;

/// More tiles than this near one shape are not looked at; a shape as long as that many tiles is carried by the rest.
constexpr std::size_t most_neighbors = 16;

/// S, T and the T', all in T's frame.
struct Surroundings
{
    ConvexPoints tile;
    ConvexPoints slider;
    Vec2 slider_middle;
    bool tile_is_b = false;
    bool is_one_sided = false; ///< the tile: its face 1 is nothing to S
    std::array<ConvexPoints, most_neighbors> neighbors;
    std::size_t neighbor_count = 0;
    Tolerances tolerances;
};

/// One side of a contact seen as the tile, the other as what slides over it.
struct Roles
{
    std::uint32_t tile;
    std::uint32_t slider;
    std::uint32_t tile_body;
    std::uint32_t slider_body;
};

Vec2 velocity_at(const BodyStore& bodies, std::uint32_t body, Vec2 point)
{
    return bodies.velocity(body) + cross(bodies.spin(body), point - bodies.poses[body].center);
}

bool move_as_one(const BodyStore& bodies, std::uint32_t a, std::uint32_t b, Vec2 point, float same_velocity)
{
    if (a == b) return true;
    if (bodies.is_dynamic(a) || bodies.is_dynamic(b)) return false;
    if (!bodies.is_active(a) && !bodies.is_active(b)) return true;
    return length_squared(velocity_at(bodies, a, point) - velocity_at(bodies, b, point)) <= same_velocity * same_velocity;
}

/// The list of contacts to search: the slider's, or that of a dynamic tile's body when that is shorter: others of its shapes are all that
/// counts then. A big body has many contacts, and whichever side it is on, each of them comes here.
std::uint32_t shorter_list(const BodyStore& bodies, const ContactStore& contacts, const Roles& roles)
{
    const std::uint32_t of_slider = bodies.records[roles.slider_body].first_contact;
    if (!bodies.is_dynamic(roles.tile_body)) return of_slider;
    const std::uint32_t of_tile = bodies.records[roles.tile_body].first_contact;
    std::uint32_t a = of_slider;
    std::uint32_t b = of_tile;
    while (a != null_index && b != null_index)
    {
        a = contacts.contacts[a / 2].next[a % 2];
        b = contacts.contacts[b / 2].next[b % 2];
    }
    return a == null_index ? of_slider : of_tile;
}

/// Every other shape of the tile's surface that may be near the slider: action(shape, its body). A chain's segment knows its neighbours.
template <class Action>
void for_each_neighbor(const BodyStore& bodies, const ShapeStore& shapes, const ContactStore& contacts, const Roles& roles, Vec2 point,
                       Action&& action)
{
    // Of a dynamic body only its own shapes count, and a few are quicker to look at than many contacts.
    constexpr std::uint32_t few = 8;
    if (bodies.is_dynamic(roles.tile_body) && bodies.records[roles.tile_body].shape_count <= few)
    {
        const Filter& filter = shapes.records[roles.slider].filter;
        for (const std::uint32_t shape : shapes_of(bodies, shapes, roles.tile_body))
        {
            const ShapeRecord& record = shapes.records[shape];
            if (shape != roles.tile && !record.is_sensor && should_collide(record.filter, filter)) action(shape, roles.tile_body);
        }
        return;
    }
    const ShapeRecord& tile = shapes.records[roles.tile];
    for (const std::uint32_t linked : {tile.previous_in_chain, tile.next_in_chain})
        if (linked != null_index) action(linked, roles.tile_body);
    for (const Tie tie : ties_from(contacts.contacts, shorter_list(bodies, contacts, roles)))
    {
        const Contact& contact = contacts.contacts[tie.slot];
        const bool slider_is_a = contact.shape_a == roles.slider;
        if (contact.is_sensor || (!slider_is_a && contact.shape_b != roles.slider)) continue;
        const std::uint32_t other = slider_is_a ? contact.shape_b : contact.shape_a;
        const std::uint32_t body = slider_is_a ? contact.body_b : contact.body_a;
        if (other == tile.previous_in_chain || other == tile.next_in_chain) continue;
        if (other != roles.tile && move_as_one(bodies, roles.tile_body, body, point, shapes.tolerances.same_velocity)) action(other, body);
    }
}

/// In the world, around all points of the contact and what could adjoin there.
Aabb around_points(const LocalManifold& manifold, const Transform& frame, const Tolerances& tolerances)
{
    Aabb box = {frame * manifold.points[0].position, frame * manifold.points[0].position};
    float deepest = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
    {
        const Vec2 point = frame * manifold.points[i].position;
        box = merge(box, {point, point});
        deepest = std::max(deepest, std::abs(manifold.points[i].separation));
    }
    return expanded(box, deepest + tolerances.seen_around + tolerances.adjoining_gap);
}

/// The point on T's surface, seen from T; the manifold's is halfway to S.
Vec2 on_tile(const LocalManifold& manifold, std::size_t i, Vec2 outward)
{
    return manifold.points[i].position - 0.5f * manifold.points[i].separation * outward;
}

/// How far a shape at most reaches in front of the lowest contact point, told by its bounds [m]. A segment hides what is behind it,
/// wherever it ends.
float rise_at_most(const ShapeStore& shapes, std::uint32_t shape, const LocalManifold& manifold, const Transform& frame, Vec2 outward,
                   bool tile_is_b)
{
    if (std::holds_alternative<Segment>(shapes.geometry[shape])) return std::numeric_limits<float>::max();
    const Aabb& bounds = shapes.bounds[shape].tight;
    const Vec2 farthest = {outward.x > 0 ? bounds.max.x : bounds.min.x, outward.y > 0 ? bounds.max.y : bounds.min.y};
    float rise = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
    {
        const Vec2 outward_in_frame = tile_is_b ? -manifold.normal : manifold.normal;
        rise = std::max(rise, dot(farthest - frame * on_tile(manifold, i, outward_in_frame), outward));
    }
    return rise;
}

Vec2 outward_of(const LocalManifold& manifold, const Surroundings& near) { return near.tile_is_b ? -manifold.normal : manifold.normal; }

/// T's face whose normal is nearest, and the angle to it [rad], small ones exactly.
struct NearestFace
{
    int face = -1;
    float angle = pi;
};

NearestFace nearest_face(const ConvexPoints& tile, Vec2 outward)
{
    NearestFace best;
    for (int i = 0; i < face_count(tile); ++i)
    {
        const Vec2 normal = normal_of(face_of(tile, i));
        const float angle = dot(normal, outward) > 0 ? std::abs(cross(normal, outward)) : pi;
        if (angle < best.angle) best = {i, angle};
    }
    return best;
}

/// Whether neighbours hide the face all around the contact points, but for what counts as a difference in height.
bool is_seam(const Surroundings& near, int face, const LocalManifold& manifold)
{
    const Edge edge = face_of(near.tile, face);
    const Vec2 along = left_perp(normal_of(edge));
    const float length = dot(edge.v2 - edge.v1, along);
    Stretch seen = {length, 0};
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
    {
        const float t = std::clamp(dot(manifold.points[i].position - edge.v1, along), 0.0f, length);
        seen = {std::min(seen.start, t - near.tolerances.seen_around), std::max(seen.end, t + near.tolerances.seen_around)};
    }
    seen = {std::max(seen.start, 0.0f), std::min(seen.end, length)};

    std::array<Stretch, most_neighbors> hidden;
    std::size_t count = 0;
    for (std::size_t i = 0; i < near.neighbor_count; ++i)
    {
        const Stretch stretch = hidden_stretch(near.tile, face, near.neighbors[i], near.slider_middle, near.tolerances.adjoining_gap);
        if (stretch.end > seen.start && stretch.start < seen.end && stretch.end > stretch.start) hidden[count++] = stretch;
    }
    std::sort(hidden.begin(), hidden.begin() + static_cast<std::ptrdiff_t>(count),
              [](const Stretch& a, const Stretch& b) { return a.start < b.start; });
    float open = 0;
    float reached = seen.start;
    for (std::size_t i = 0; i < count; ++i)
    {
        open += std::max(std::min(hidden[i].start, seen.end) - reached, 0.0f);
        reached = std::max(reached, hidden[i].end);
    }
    open += std::max(seen.end - reached, 0.0f);
    return open <= std::min(near.tolerances.tile_step_height, 0.5f * (seen.end - seen.start));
}

/// A neighbour that shares a contact point and lies in front of it; none when the normal is outward for all of them.
const ConvexPoints* find_blocker(const Surroundings& near, const LocalManifold& manifold, Vec2 outward)
{
    for (std::size_t p = 0; p < static_cast<std::size_t>(manifold.count); ++p)
    {
        const Vec2 point = on_tile(manifold, p, outward);
        for (std::size_t i = 0; i < near.neighbor_count; ++i)
        {
            const ConvexPoints& other = near.neighbors[i];
            const bool adjoins = distance_to(other, point) <= near.tolerances.adjoining_gap;
            if (adjoins && rise_before(other, point, outward, near.tolerances.adjoining_gap) > same_direction) return &other;
        }
    }
    return nullptr;
}

/// Whether the ground goes on beyond both ends of a face that neighbours share, and falls off nowhere there.
bool goes_on_flat(const Surroundings& near, const Edge& face, Vec2 normal)
{
    for (const Vec2 end : {face.v1 + near.tile.radius * normal, face.v2 + near.tile.radius * normal})
    {
        for (std::size_t i = 0; i < near.neighbor_count; ++i)
        {
            const ConvexPoints& other = near.neighbors[i];
            if (distance_to(other, end) > near.tolerances.adjoining_gap) continue;
            bool is_flat = false;
            for (std::size_t w = 0; w < static_cast<std::size_t>(other.count); ++w)
            {
                const Vec2 way = other.points[w] + other.radius * normal - end;
                is_flat = is_flat || (length(way) > near.tolerances.adjoining_gap && dot(way, normal) >= -flat_on * length(way));
            }
            if (!is_flat) return false;
        }
    }
    return true;
}

/// Whether a neighbour T' supports S across a convex corner of the surface. The corner is convex when T and T' lie behind each other's
/// faces. T' supports S when S lies over its face and is less deep behind that face than behind T's. Over T's face, S would be pushed
/// off T' by its whole overhang.
///
///       ____S___
///      |________|
///     ___T'___         T is the wall, T' the top of the ledge. Where T' rises in front of T, the corner is concave, and S rests on both.
///             | T
///             |
bool is_supported_by_neighbor(const Surroundings& near, int face, float separation)
{
    for (std::size_t i = 0; i < near.neighbor_count; ++i)
    {
        const ConvexPoints& other = near.neighbors[i];
        if (!is_behind(other, near.tile, face, near.tolerances.adjoining_gap)) continue;
        for (int other_face = 0; other_face < face_count(other); ++other_face)
        {
            const Edge support = face_of(other, other_face);
            const bool is_in_front = dot(normal_of(support), near.slider_middle - support.v1) > 0;
            if (!is_in_front || !is_behind(near.tile, other, other_face, near.tolerances.adjoining_gap)) continue;
            const FaceContact contact =
                collide_on_face(other, other_face, near.slider, 0, near.tile_is_b, near.tolerances.speculative_distance);
            if (contact.manifold.count == 0 || contact.face_separation <= separation + near.tolerances.tile_step_height) continue;
            Surroundings seen_from_other = near;
            seen_from_other.tile = other;
            seen_from_other.neighbors[i] = near.tile;
            if (!is_seam(seen_from_other, other_face, contact.manifold)) return true;
        }
    }
    return false;
}

/// The contact with the face of T that separates best of those that are no seam; without points unless S is over that face with its
/// deepest point, or is but slightly tilted against it; without points too when a neighbour supports S across a corner.
LocalManifold second_choice(const Surroundings& near, Vec2 outward, int seam)
{
    FaceContact best;
    float best_separation = -std::numeric_limits<float>::max();
    bool is_best_flat = false;
    Vec2 best_normal;
    int best_face = -1;
    for (int face = 0; face < face_count(near.tile); ++face)
    {
        if (face == seam || (face == 1 && near.is_one_sided)) continue;
        const Edge edge = face_of(near.tile, face);
        const Vec2 normal = normal_of(edge);
        const bool is_flat = goes_on_flat(near, edge, normal);
        const float slack = is_flat ? 1.5f * near.tolerances.adjoining_gap : 0.0f;
        const FaceContact contact =
            collide_on_face(near.tile, face, near.slider, slack, near.tile_is_b, near.tolerances.speculative_distance);
        if (contact.face_separation <= best_separation) continue;
        if (contact.manifold.count > 0 && is_seam(near, face, contact.manifold)) continue;
        best = contact;
        best_separation = contact.face_separation;
        best_normal = normal;
        best_face = face;
        is_best_flat = is_flat;
    }
    const bool is_deepest = best.point_separation - best.face_separation <= near.tolerances.deepest_within;
    const bool is_tilted = seam < 0 && is_best_flat && dot(best_normal, outward) > 0 && std::abs(cross(best_normal, outward)) <= small_tilt;
    if ((!is_deepest && !is_tilted) || best.manifold.count == 0) return {};
    return is_supported_by_neighbor(near, best_face, best_separation) ? LocalManifold{} : best.manifold;
}

/// A tip that has slipped into a real gap and finds no face to stand on keeps the corners that hold it.
bool is_held_by_gap(const Surroundings& near, const LocalManifold& manifold, Vec2 outward, const ConvexPoints& blocker)
{
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
    {
        if (manifold.points[i].separation < 0 && distance_to(blocker, on_tile(manifold, i, outward)) > near.tolerances.real_gap)
            return near.slider.count > 1;
    }
    return false;
}

/// In T's frame.
LocalManifold judge(const Surroundings& near, const LocalManifold& manifold)
{
    const Vec2 outward = outward_of(manifold, near);
    const NearestFace nearest = nearest_face(near.tile, outward);
    if (nearest.angle <= same_direction)
        return is_seam(near, nearest.face, manifold) ? second_choice(near, outward, nearest.face) : manifold;

    const ConvexPoints* blocker = find_blocker(near, manifold, outward);
    if (!blocker) return manifold;
    const LocalManifold second = second_choice(near, outward, -1);
    return second.count == 0 && is_held_by_gap(near, manifold, outward, *blocker) ? manifold : second;
}

LocalManifold judge_side(const LocalManifold& manifold, const Contact& contact, bool tile_is_b, const BodyStore& bodies,
                         const ShapeStore& shapes, const ContactStore& contacts)
{
    const Roles roles = tile_is_b ? Roles{contact.shape_b, contact.shape_a, contact.body_b, contact.body_a}
                                  : Roles{contact.shape_a, contact.shape_b, contact.body_a, contact.body_b};
    const bool is_dynamic = bodies.is_dynamic(roles.tile_body);
    if (is_dynamic && bodies.records[roles.tile_body].shape_count < 2) return manifold;

    const Transform& frame_a = bodies.poses[contact.body_a].transform;
    const Aabb box = around_points(manifold, frame_a, shapes.tolerances);
    const Vec2 middle = box.center();
    const Vec2 outward = rotate(frame_a.q, tile_is_b ? -manifold.normal : manifold.normal);
    float rise = -1;
    for_each_neighbor(bodies, shapes, contacts, roles, middle, [&](std::uint32_t shape, std::uint32_t)
    {
        if (overlaps(shapes.bounds[shape].tight, box))
            rise = std::max(rise, rise_at_most(shapes, shape, manifold, frame_a, outward, tile_is_b));
    });
    if (rise <= 0) return manifold;

    const Transform& frame = bodies.poses[roles.tile_body].transform;
    const auto seen = [&](std::uint32_t shape, std::uint32_t body)
    {
        const ConvexPoints points = convex_points(shapes.geometry[shape]);
        return body == roles.tile_body ? points : moved(points, relative(frame, bodies.poses[body].transform));
    };
    const ConvexPoints tile = convex_points(shapes.geometry[roles.tile]);
    const float angle = nearest_face(tile, inverse_rotate(frame.q, outward)).angle;
    // What hides a face rises before it; and of a body of several shapes that stands slightly tilted on a floor, the floor's normal is
    // the true one.
    const bool is_face = angle <= same_direction;
    if (is_face ? rise < 0.99f * shapes.tolerances.adjoining_gap : is_dynamic && angle <= small_tilt) return manifold;
    Surroundings near;
    near.tolerances = shapes.tolerances;
    near.tile = tile;
    near.slider = seen(roles.slider, roles.slider_body);
    near.slider_middle = middle_of(near.slider);
    near.tile_is_b = tile_is_b;
    near.is_one_sided = shapes.records[roles.tile].is_one_sided;
    const Aabb reach = expanded(shapes.bounds[roles.slider].tight, shapes.tolerances.speculative_distance + shapes.tolerances.seen_around);
    for_each_neighbor(bodies, shapes, contacts, roles, middle, [&](std::uint32_t shape, std::uint32_t body)
    {
        if (near.neighbor_count < most_neighbors && overlaps(shapes.bounds[shape].tight, reach))
            near.neighbors[near.neighbor_count++] = seen(shape, body);
    });
    if (!tile_is_b) return judge(near, manifold);
    const Transform a_in_b = relative(frame, frame_a);
    return moved(judge(near, moved(manifold, a_in_b)), relative(frame_a, frame));
}

} // namespace

LocalManifold without_internal_edges(const LocalManifold& manifold, const Contact& contact, const BodyStore& bodies,
                                     const ShapeStore& shapes, const ContactStore& contacts)
{
    if (manifold.count == 0) return manifold;
    const LocalManifold seen_from_a = judge_side(manifold, contact, false, bodies, shapes, contacts);
    return seen_from_a.count == 0 ? seen_from_a : judge_side(seen_from_a, contact, true, bodies, shapes, contacts);
}

} // namespace carom::detail
