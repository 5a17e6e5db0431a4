// One move of a character: carry, get out, slide with steps, follow the ground.
//
// The outline is kept a skin's width away from everything, by casting it with the skin around it. What the skin overlaps (something was
// moved into it, or it is squeezed) is left out of that cast and acts as a plane; and the bare outline is cast as well, so that nothing
// is ever entered.
#include "geometry/distance.hpp"
#include "geometry/manifold.hpp"
#include "geometry/validate.hpp"
#include "world/validate.hpp"

#include <carom/character.hpp>

#include <algorithm>
#include <array>

namespace carom
{

namespace
{

/// Rounds of slide: each ends at a surface, and two surfaces make a corner.
constexpr int most_slides = 6;
/// Planes that are heeded at once; more than a few touch only in a heap of rubble.
constexpr std::size_t most_planes = 16;
/// A surface this near to the skin is touched [m]: more than the rounding of a cast that ended there.
constexpr float contact_margin = 2e-4f;
/// Ways shorter than this are none [m].
constexpr float least_way = 1e-6f;
/// Share of the skin that even the bare outline keeps.
constexpr float least_skin = 0.2f;

Geometry grown(const Geometry& geometry, float by)
{
    if (const auto* circle = std::get_if<Circle>(&geometry)) return Circle{circle->center, circle->radius + by};
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) return Capsule{capsule->p1, capsule->p2, capsule->radius + by};
    if (const auto* segment = std::get_if<Segment>(&geometry)) return Capsule{segment->p1, segment->p2, by};
    Polygon polygon = *std::get_if<Polygon>(&geometry);
    polygon.radius += by;
    return polygon;
}

/// A surface that the skin touches or overlaps.
struct Plane
{
    ShapeId shape;
    BodyId body;
    Vec2 normal;          ///< towards the character
    Vec2 point;           ///< in the world [m]
    float separation = 0; ///< from the skin [m]
};

/// Leaves shapes out that act as planes, on top of the user's own predicate.
class Without final : public QueryPredicate
{
public:
    explicit Without(const QueryPredicate* own) : own_(own) {}
    void add(ShapeId shape)
    {
        if (count_ < shapes_.size()) shapes_[count_++] = shape;
    }
    bool accepts(ShapeId shape, BodyId body) const override
    {
        const auto end = shapes_.begin() + static_cast<std::ptrdiff_t>(count_);
        return std::find(shapes_.begin(), end, shape) == end && (!own_ || own_->accepts(shape, body));
    }

private:
    const QueryPredicate* own_;
    std::array<ShapeId, most_planes> shapes_;
    std::size_t count_ = 0;
};

} // namespace

/// A move in progress.
class CharacterMove
{
public:
    CharacterMove(Character& character, World& world, Vec2 velocity, float dt)
        : character_(character),
          def_(character.def_),
          world_(world),
          velocity_(velocity),
          dt_(dt),
          right_(right_perp(def_.up)),
          skinned_(grown(def_.geometry, def_.skin)),
          guarded_(grown(def_.geometry, least_skin * def_.skin)),
          least_up_(sin_cos(def_.max_slope).cos)
    {
    }

    Vec2 run();

private:
    // Where it is and what it touches.
    Transform here() const { return {character_.position_, {}}; }
    bool is_on_ground() const { return character_.ground_.state == GroundState::OnGround; }
    float lowest_point() const;
    bool is_walkable(Vec2 normal) const { return dot(normal, def_.up) >= least_up_; }
    QueryFilter filter(const QueryPredicate* predicate) const;
    void find_planes(float margin);
    std::optional<Vec2> edge_normal(Vec2 point, Vec2 normal) const;
    Vec2 ground_normal(Vec2 point, Vec2 normal) const;

    // Moving.
    void move_by(Vec2 way);
    float free_way(Vec2 way, CastHit* first = nullptr);
    float slide_share(Vec2& way);
    Vec2 against(Vec2 way, const Plane& plane) const;
    Vec2 against_all(Vec2 way) const;
    void carry();
    void get_out();
    void slide(Vec2 way, bool may_step);
    bool step_up(Vec2 way);
    void push(Vec2 wanted);
    void clip_velocity();
    const Plane* best_support() const;
    void find_ground(float reach);
    void stand_on(ShapeId shape, BodyId body, Vec2 point, Vec2 normal);

    Character& character_;
    const CharacterDef& def_;
    World& world_;
    Vec2 velocity_;
    float dt_;
    Vec2 right_;
    Geometry skinned_;
    Geometry guarded_;       ///< what must never be entered
    float least_up_;         ///< of a normal on which it can walk
    float highest_step_ = 0; ///< height along `up` at which an edge is too high to step on [m]
    std::array<Plane, most_planes> planes_;
    std::size_t plane_count_ = 0;
};

/// Height of its foot along `up` [m].
float CharacterMove::lowest_point() const
{
    const detail::ConvexPoints outline = detail::convex_points(def_.geometry);
    float lowest = dot(outline.points[0], def_.up);
    for (std::size_t i = 1; i < static_cast<std::size_t>(outline.count); ++i) lowest = std::min(lowest, dot(outline.points[i], def_.up));
    return dot(character_.position_, def_.up) + lowest - outline.radius;
}

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
    plane_count_ = 0;
    const auto look = [&](ShapeId id)
    {
        const ShapeView shape = std::as_const(world_).shape(id);
        const Transform at = std::as_const(world_).body(shape.body()).transform();
        const detail::LocalManifold contact = detail::collide(shape.geometry(), skinned_, relative(at, here()), margin);
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
    const Aabb box = expanded(aabb_of(skinned_, here()), margin);
    const Vec2 limit = {max_coordinate, max_coordinate};
    world_.visit_overlapping(Aabb{max(-limit, min(limit, box.min)), max(-limit, min(limit, box.max))}, look, filter(def_.filter.predicate));
}

/// On the edge of a step, the normal is anything between those of its faces. It counts as ground when the face behind the edge is.
std::optional<Vec2> CharacterMove::edge_normal(Vec2 point, Vec2 normal) const
{
    constexpr float behind = 0.02f; // [m]
    constexpr float above = 0.05f;  // [m]
    const float side = dot(normal, right_) > 0 ? -1.0f : 1.0f;
    if (dot(normal, def_.up) < 0 || dot(point, def_.up) > highest_step_) return std::nullopt;
    const Vec2 start = point + behind * side * right_ + above * def_.up;
    const std::optional<RayHit> face = world_.cast_ray(start, -2 * above * def_.up, filter(def_.filter.predicate));
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
    if (distance < least_way) return 1;
    find_planes(contact_margin);
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
        share = std::max(0.0f, guard->fraction - contact_margin / distance);
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
    const bool climbs = dot(along, def_.up) > std::max(0.0f, dot(way, def_.up)) + least_way;
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
    if (share * distance >= least_way || into < -graze * distance) return share;
    way += (0.01f * graze * distance - into) * first.normal;
    return free_way(way);
}

void CharacterMove::slide(Vec2 way, bool may_step)
{
    for (int i = 0; i < most_slides && length(way) > least_way; ++i)
    {
        find_planes(contact_margin);
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
    constexpr float least_step = 0.001f; // [m]
    const Vec2 forward = dot(way, right_) * right_;
    if (def_.step_height <= 0 || length(forward) < least_way) return false;
    const Vec2 before = character_.position_;
    const Vec2 up = def_.step_height * def_.up;
    const Vec2 lift = free_way(up) * up;
    move_by(lift);
    const float share = free_way(forward);
    move_by(share * forward);

    CastHit ground;
    const float down = free_way(-lift, &ground);
    move_by(-down * lift);
    const bool is_higher = dot(character_.position_ - before, def_.up) > least_step;
    const bool has_ground =
        down < 1 && dot(ground.point, def_.up) <= highest_step_ && is_walkable(ground_normal(ground.point, ground.normal));
    if (share * length(forward) > least_way && is_higher && has_ground) return true;
    character_.position_ = before;
    return false;
}

/// Pushes each dynamic body that it touches as hard as it takes to make way, at most with the push force.
void CharacterMove::push(Vec2 wanted)
{
    if (def_.push_force <= 0) return;
    for (std::size_t i = 0; i < plane_count_; ++i)
    {
        const Plane& plane = planes_[i];
        Body body = world_.body(plane.body);
        const float approach = -dot(wanted - body.velocity_at(plane.point), plane.normal);
        if (body.type() != BodyType::Dynamic || approach <= 0 || is_walkable(plane.normal)) continue; // it stands on what is walkable
        const float impulse = std::min(def_.push_force * dt_, approach * body.mass_data().mass);
        const Vec2 limit = {max_coordinate, max_coordinate};
        body.apply_impulse(-impulse * plane.normal, max(-limit, min(limit, plane.point)));
    }
}

/// Goes along with the ground's body, by what that has moved since the last move. A body that was teleported does not take it along.
void CharacterMove::carry()
{
    const CharacterGround& ground = character_.ground_;
    const std::optional<BodyView> body = std::as_const(world_).find_body(ground.body);
    if (ground.state == GroundState::InAir || !body || body->type() == BodyType::Static) return;
    const Vec2 moved = body->transform() * character_.foot_on_ground_ - ground.point;
    const Vec2 expected = dt_ * body->velocity_at(ground.point);
    constexpr float surprise = 0.1f; // [m]
    const bool is_teleport = !(distance(moved, expected) <= surprise + length(expected)) || length(moved) > max_coordinate;
    if (is_teleport) return;

    Without ground_itself(def_.filter.predicate); // it comes along
    for (const ShapeId shape : body->shapes()) ground_itself.add(shape);
    const std::optional<CastHit> hit = world_.cast_shape(guarded_, here(), moved, filter(&ground_itself));
    const float back = length(moved) > least_way ? contact_margin / length(moved) : 0;
    move_by((hit ? std::max(0.0f, hit->fraction - back) : 1.0f) * moved);
}

/// Out of what overlaps the skin, by the shortest way that satisfies all planes.
void CharacterMove::get_out()
{
    constexpr int rounds = 4;
    constexpr int passes = 16;
    for (int round = 0; round < rounds; ++round)
    {
        find_planes(contact_margin);
        Vec2 shift;
        for (int pass = 0; pass < passes; ++pass)
            for (std::size_t i = 0; i < plane_count_; ++i)
                shift += std::max(0.0f, -(planes_[i].separation + dot(shift, planes_[i].normal))) * planes_[i].normal;
        if (length(shift) < least_way) return;
        // Through what it is in, but not into anything else.
        Without overlapped(def_.filter.predicate);
        for (std::size_t i = 0; i < plane_count_; ++i)
            if (planes_[i].separation < -(1 - least_skin) * def_.skin) overlapped.add(planes_[i].shape);
        const std::optional<CastHit> hit = world_.cast_shape(guarded_, here(), shift, filter(&overlapped));
        const float share = hit ? std::max(0.0f, hit->fraction - contact_margin / length(shift)) : 1.0f;
        move_by(share * shift);
        if (share <= 0) return;
    }
}

/// Takes from the velocity what leads into surfaces that do not go away by themselves.
void CharacterMove::clip_velocity()
{
    const bool stands = is_on_ground();
    const Vec2 reference = stands ? character_.ground_.velocity : Vec2{};
    for (std::size_t i = 0; i < plane_count_; ++i)
    {
        const Plane& plane = planes_[i];
        if (stands && is_walkable(ground_normal(plane.point, plane.normal))) continue;
        const Vec2 surface = std::as_const(world_).body(plane.body).velocity_at(plane.point);
        if (dot(velocity_ + reference - surface, plane.normal) < 0) velocity_ = against(velocity_, plane);
    }
    if (stands) velocity_ -= std::min(0.0f, dot(velocity_, def_.up)) * def_.up;
    const Vec2 limit = {max_speed, max_speed};
    velocity_ = max(-limit, min(limit, velocity_));
}

void CharacterMove::stand_on(ShapeId shape, BodyId id, Vec2 point, Vec2 normal)
{
    const BodyView body = std::as_const(world_).body(id);
    const GroundState state = is_walkable(normal) ? GroundState::OnGround : GroundState::TooSteep;
    character_.ground_ = {state, shape, id, point, normal, body.velocity_at(point)};
    character_.foot_on_ground_ = inverse_transform(body.transform(), point);
}

/// What it touches that points up most.
const Plane* CharacterMove::best_support() const
{
    const Plane* best = nullptr;
    for (std::size_t i = 0; i < plane_count_; ++i)
    {
        const float up = dot(ground_normal(planes_[i].point, planes_[i].normal), def_.up);
        if (up > 0.01f && (!best || up > dot(ground_normal(best->point, best->normal), def_.up))) best = &planes_[i];
    }
    return best;
}

/// Stands on what it touches, or looks for ground below and goes down to it.
void CharacterMove::find_ground(float reach)
{
    character_.ground_ = {};
    find_planes(contact_margin);
    const Plane* const touched = best_support();
    if (touched && is_walkable(ground_normal(touched->point, touched->normal)))
        return stand_on(touched->shape, touched->body, touched->point, ground_normal(touched->point, touched->normal));

    const std::optional<Plane> support = touched ? std::optional(*touched) : std::nullopt; // the planes change below
    const Vec2 way = -(reach + 2 * contact_margin) * def_.up;
    CastHit below;
    const float share = free_way(way, &below);
    if (share < 1 && is_walkable(ground_normal(below.point, below.normal)))
    {
        move_by(share * way);
        return stand_on(below.shape, below.body, below.point, ground_normal(below.point, below.normal));
    }
    if (support) stand_on(support->shape, support->body, support->point, support->normal);
}

Vec2 CharacterMove::run()
{
    const bool starts_on_ground = is_on_ground();
    const CharacterGround before = character_.ground_;
    const bool jumps = dot(velocity_, def_.up) > 1e-3f;
    const bool walks = starts_on_ground && !jumps;
    carry();
    get_out();
    highest_step_ = lowest_point() - def_.skin + def_.step_height + contact_margin;

    // On a slope it walks along the ground, up and down, at the speed that was asked for.
    slide(walks ? (dt_ * dot(velocity_, right_)) * right_perp(before.normal) : dt_ * velocity_, walks);

    if (jumps)
        character_.ground_ = {};
    else
        find_ground(starts_on_ground ? def_.snap_distance : 0);
    find_planes(contact_margin);
    push(velocity_ + (starts_on_ground ? before.velocity : Vec2{}));
    if (starts_on_ground && !is_on_ground()) velocity_ += before.velocity;
    if (!starts_on_ground && is_on_ground()) velocity_ -= character_.ground_.velocity;
    clip_velocity();
    return velocity_;
}

Character::Character(const CharacterDef& def) : def_(def), position_(def.position)
{
    constexpr std::string_view function = "Character";
    detail::validate(def.geometry, function);
    detail::require_within(function, "position", def.position, max_coordinate);
    detail::require_finite(function, "up", def.up);
    const float length2 = length_squared(def.up);
    if (!(length2 > 0.999f && length2 < 1.001f)) detail::usage_error(function, "up", def.up, "give a unit vector");
    detail::require_range(function, "max_slope", def.max_slope, 0, 1.5f);
    detail::require_range(function, "step_height", def.step_height, 0, max_coordinate);
    detail::require_range(function, "snap_distance", def.snap_distance, 0, max_coordinate);
    detail::require_range(function, "skin", def.skin, 0.001f, 0.1f);
    detail::require_range(function, "push_force", def.push_force, 0, 1e20f);
    detail::validate(grown(def.geometry, def.skin), function); // the largest shapes leave no room for the skin
}

void Character::set_position(Vec2 position)
{
    detail::require_within("set_position", "position", position, max_coordinate);
    position_ = position;
    ground_ = {};
}

Vec2 Character::move(World& world, Vec2 velocity, float dt)
{
    detail::require_queryable(world.state(), "move");
    detail::require_within("move", "velocity", velocity, max_speed);
    detail::require_range("move", "dt", dt, 1e-6f, 1.0f);
    return CharacterMove(*this, world, velocity, dt).run();
}

} // namespace carom
