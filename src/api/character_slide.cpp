// How far a character can go, and along what: casts, the planes that it touches, slides and steps.
#include "api/character_move.hpp"

#include "geometry/bounds.hpp"
#include "geometry/manifold.hpp"

#include <utility>

namespace carom
{

QueryFilter CharacterMove::filter(const QueryPredicate* predicate) const
{
    QueryFilter filter = def_.filter;
    filter.sensors = false;
    filter.predicate = predicate;
    return filter;
}

/// Where the world of queries ends, it ends for characters.
void CharacterMove::move_by(Vec2 way)
{
    const Vec2 limit = {max_coordinate, max_coordinate};
    character_.position_ = max(-limit, min(limit, character_.position_ + way));
}

/// The surfaces within a margin of the skin; those that are overlapped deepest are kept when there are too many.
void CharacterMove::find_planes(float margin)
{
    const detail::Tolerances tolerances = {.length_unit = margins_.unit};
    plane_count_ = 0;
    const auto look = [&](ShapeId id)
    {
        const ShapeView shape = std::as_const(world_).shape(id);
        const Transform at = std::as_const(world_).body(shape.body()).transform();
        const detail::LocalManifold contact = detail::collide(shape.geometry(), skinned_, relative(at, here()), margin, tolerances);
        if (contact.count == 0) return;
        detail::LocalPoint deepest = contact.points[0];
        if (contact.count == 2 && contact.points[1].separation < deepest.separation) deepest = contact.points[1];
        const Plane plane = {id, shape.body(), rotate(at.q, contact.normal), at * deepest.position, deepest.separation};
        if (plane_count_ < most_planes)
        {
            planes_[plane_count_++] = plane;
            return;
        }
        Plane& shallowest =
            *std::max_element(planes_.begin(), planes_.end(), [](const Plane& a, const Plane& b) { return a.separation < b.separation; });
        if (plane.separation < shallowest.separation) shallowest = plane;
    };
    const Aabb box = expanded(detail::bounds_of(skinned_, here()), margin);
    const Vec2 limit = {max_coordinate, max_coordinate};
    world_.visit_overlapping(Aabb{max(-limit, min(limit, box.min)), max(-limit, min(limit, box.max))}, look, filter(def_.filter.predicate));
}

/// On the edge of a step, the normal is anything between those of its faces. It counts as ground when the face behind the edge is.
std::optional<Vec2> CharacterMove::edge_normal(Vec2 point, Vec2 normal) const
{
    const float side = dot(normal, right_) > 0 ? -1.0f : 1.0f;
    if (dot(normal, def_.up) < 0 || dot(point, def_.up) > highest_step_) return std::nullopt;
    const Vec2 start = point + margins_.behind_edge * side * right_ + margins_.above_edge * def_.up;
    const std::optional<RayHit> face = world_.cast_ray(start, -2 * margins_.above_edge * def_.up, filter(def_.filter.predicate));
    if (!face || face->starts_inside || !is_walkable(face->normal)) return std::nullopt;
    return face->normal;
}

Vec2 CharacterMove::ground_normal(Vec2 point, Vec2 normal) const
{
    return is_walkable(normal) ? normal : edge_normal(point, normal).value_or(normal);
}

/// How much of a way is free, as a share.
/// @param first what ends it, when something does
float CharacterMove::free_way(Vec2 way, CastHit* first)
{
    const float distance = length(way);
    if (distance < margins_.least_way) return 1;
    find_planes(margins_.contact);
    Without planes(def_.filter.predicate);
    for (std::size_t i = 0; i < plane_count_; ++i)
        if (planes_[i].separation < 0) planes.add(planes_[i].shape);

    float share = 1;
    if (const std::optional<CastHit> hit = world_.cast_shape(skinned_, here(), way, filter(&planes)); hit && !hit->starts_inside)
    {
        share = hit->fraction;
        if (first) *first = *hit;
    }
    const std::optional<CastHit> guard = world_.cast_shape(guarded_, here(), way, filter(def_.filter.predicate));
    if (guard && !guard->starts_inside && guard->fraction < share)
    {
        share = std::max(0.0f, guard->fraction - margins_.contact / distance);
        if (first) *first = *guard;
    }
    return share;
}

/// A way along a plane, less what leads into it. What is too steep to walk on is a wall: it lets nobody up.
Vec2 CharacterMove::against(Vec2 way, const Plane& plane) const
{
    const Vec2 n = plane.normal;
    const float into = dot(way, n);
    if (into >= 0) return way;
    const Vec2 along = way - into * n;
    const bool climbs = dot(along, def_.up) > std::max(0.0f, dot(way, def_.up)) + margins_.least_way;
    if (!climbs || is_walkable(ground_normal(plane.point, n))) return along;
    const Vec2 wall = normalize(dot(n, right_) * right_);
    const Vec2 beside = way - std::min(0.0f, dot(way, wall)) * wall;
    return beside - std::min(0.0f, dot(beside, n)) * n;
}

/// Along all that is touched; nothing is left of it in a corner.
Vec2 CharacterMove::against_all(Vec2 way) const
{
    for (std::size_t i = 0; i < plane_count_; ++i) way = against(way, planes_[i]);
    for (std::size_t i = 0; i < plane_count_; ++i)
        if (dot(way, planes_[i].normal) < -1e-4f * length(way)) return {};
    return way;
}

/// Like free_way, but a surface that the way only grazes does not stop it: the normals of corners are not exact.
/// @param way bent by as little as it takes
float CharacterMove::slide_share(Vec2& way)
{
    constexpr float graze = 1e-3f;
    CastHit first;
    const float share = free_way(way, &first);
    const float distance = length(way);
    const float into = dot(way, first.normal);
    if (share * distance >= margins_.least_way || into < -graze * distance) return share;
    way += (0.01f * graze * distance - into) * first.normal;
    return free_way(way);
}

void CharacterMove::slide(Vec2 way, bool may_step)
{
    constexpr int most_slides = 6; // each ends at a surface, and two surfaces make a corner
    for (int i = 0; i < most_slides && length(way) > margins_.least_way; ++i)
    {
        find_planes(margins_.contact);
        const Vec2 along = against_all(way);
        const float wanted = dot(way, right_);
        const bool is_stopped = dot(along, right_) * wanted <= 0.5f * wanted * wanted;
        if (may_step && is_stopped && step_up(way)) return;
        way = along;
        const float share = slide_share(way);
        move_by(share * way);
        way *= 1 - share;
    }
}

/// Up, forward and down again. It counts when there is ground, higher than before.
bool CharacterMove::step_up(Vec2 way)
{
    const Vec2 forward = dot(way, right_) * right_;
    if (def_.step_height <= 0 || length(forward) < margins_.least_way) return false;
    const Vec2 before = character_.position_;
    const Vec2 up = def_.step_height * def_.up;
    const Vec2 lift = free_way(up) * up;
    move_by(lift);
    const float share = free_way(forward);
    move_by(share * forward);

    CastHit ground;
    const float down = free_way(-lift, &ground);
    move_by(-down * lift);
    const bool is_higher = dot(character_.position_ - before, def_.up) > margins_.least_step;
    const bool has_ground =
        down < 1 && dot(ground.point, def_.up) <= highest_step_ && is_walkable(ground_normal(ground.point, ground.normal));
    if (share * length(forward) > margins_.least_way && is_higher && has_ground) return true;
    character_.position_ = before;
    return false;
}

} // namespace carom
