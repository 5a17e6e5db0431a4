// One move of a character: carry, get out, slide with steps, follow the ground.
#include "api/character_move.hpp"
#include "api/validate.hpp"
#include "geometry/distance.hpp"
#include "geometry/validate.hpp"
#include "state/guards.hpp"

#include <utility>

namespace carom
{

Geometry CharacterMove::grown(const Geometry& geometry, float by)
{
    if (const auto* circle = std::get_if<Circle>(&geometry)) return Circle{circle->center, circle->radius + by};
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) return Capsule{capsule->p1, capsule->p2, capsule->radius + by};
    if (const auto* segment = std::get_if<Segment>(&geometry)) return Capsule{segment->p1, segment->p2, by};
    Polygon polygon = *std::get_if<Polygon>(&geometry);
    polygon.radius += by;
    return polygon;
}

CharacterMove::CharacterMove(Character& character, World& world, Vec2 velocity, float dt)
    : character_(character),
      def_(character.def_),
      world_(world),
      margins_{.unit = world.length_unit()},
      velocity_(velocity),
      dt_(dt),
      right_(right_perp(def_.up)),
      skinned_(grown(def_.geometry, skin(def_))),
      guarded_(grown(def_.geometry, least_skin * skin(def_))),
      least_up_(sin_cos(def_.max_slope).cos)
{
}

/// Height of its foot along `up` [m].
float CharacterMove::lowest_point() const
{
    const detail::ConvexPoints outline = detail::convex_points(def_.geometry);
    float lowest = dot(outline.points[0], def_.up);
    for (std::size_t i = 1; i < static_cast<std::size_t>(outline.count); ++i) lowest = std::min(lowest, dot(outline.points[i], def_.up));
    return dot(character_.position_, def_.up) + lowest - outline.radius;
}

/// Goes along with the ground's body, by what that has moved since the last move. A body that was teleported does not take it along.
void CharacterMove::carry()
{
    const CharacterGround& ground = character_.ground_;
    const std::optional<BodyView> body = std::as_const(world_).find_body(ground.body);
    if (ground.state == GroundState::InAir || !body || body->type() == BodyType::Static) return;
    const Vec2 moved = body->transform() * character_.foot_on_ground_ - ground.point;
    const Vec2 expected = dt_ * body->velocity_at(ground.point);
    const bool is_teleport = !(distance(moved, expected) <= margins_.surprise + length(expected)) || length(moved) > max_coordinate;
    if (is_teleport) return;

    Without ground_itself(def_.filter.predicate); // it comes along
    for (const ShapeId shape : body->shapes()) ground_itself.add(shape);
    const std::optional<CastHit> hit = world_.cast_shape(guarded_, here(), moved, filter(&ground_itself));
    const float back = length(moved) > margins_.least_way ? margins_.contact / length(moved) : 0;
    move_by((hit ? std::max(0.0f, hit->fraction - back) : 1.0f) * moved);
}

/// Out of what overlaps the skin, by the shortest way that satisfies all planes.
void CharacterMove::get_out()
{
    constexpr int rounds = 4;
    constexpr int passes = 16;
    for (int round = 0; round < rounds; ++round)
    {
        find_planes(margins_.contact);
        Vec2 shift;
        for (int pass = 0; pass < passes; ++pass)
            for (std::size_t i = 0; i < plane_count_; ++i)
                shift += std::max(0.0f, -(planes_[i].separation + dot(shift, planes_[i].normal))) * planes_[i].normal;
        if (length(shift) < margins_.least_way) return;
        // Through what it is in, but not into anything else.
        Without overlapped(def_.filter.predicate);
        for (std::size_t i = 0; i < plane_count_; ++i)
            if (planes_[i].separation < -(1 - least_skin) * skin(def_)) overlapped.add(planes_[i].shape);
        const std::optional<CastHit> hit = world_.cast_shape(guarded_, here(), shift, filter(&overlapped));
        const float share = hit ? std::max(0.0f, hit->fraction - margins_.contact / length(shift)) : 1.0f;
        move_by(share * shift);
        if (share <= 0) return;
    }
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
const CharacterMove::Plane* CharacterMove::best_support() const
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
    find_planes(margins_.contact);
    const Plane* const touched = best_support();
    if (touched && is_walkable(ground_normal(touched->point, touched->normal)))
        return stand_on(touched->shape, touched->body, touched->point, ground_normal(touched->point, touched->normal));

    const std::optional<Plane> support = touched ? std::optional(*touched) : std::nullopt; // the planes change below
    const Vec2 way = -(reach + 2 * margins_.contact) * def_.up;
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
    const bool jumps = dot(velocity_, def_.up) > margins_.jump_speed;
    const bool walks = starts_on_ground && !jumps;
    carry();
    get_out();
    highest_step_ = lowest_point() - skin(def_) + def_.step_height + margins_.contact;

    // On a slope it walks along the ground, up and down, at the speed that was asked for.
    slide(walks ? (dt_ * dot(velocity_, right_)) * right_perp(before.normal) : dt_ * velocity_, walks);

    if (jumps)
        character_.ground_ = {};
    else
        find_ground(starts_on_ground ? def_.snap_distance : 0);
    find_planes(margins_.contact);
    push(velocity_ + (starts_on_ground ? before.velocity : Vec2{}));
    if (starts_on_ground && !is_on_ground()) velocity_ += before.velocity;
    if (!starts_on_ground && is_on_ground()) velocity_ -= character_.ground_.velocity;
    clip_velocity();
    return velocity_;
}

// ---- public ----

Character::Character(const CharacterDef& def) : def_(def), position_(def.position)
{
    constexpr std::string_view function = "Character";
    detail::require_range(function, "length_unit", def.length_unit, min_length_unit, max_length_unit);
    const detail::Tolerances tolerances = {.length_unit = def.length_unit};
    detail::validate(def.geometry, function, tolerances);
    detail::require_within(function, "position", def.position, max_coordinate);
    detail::require_finite(function, "up", def.up);
    const float length2 = length_squared(def.up);
    if (!(length2 > 0.999f && length2 < 1.001f)) detail::usage_error(function, "up", def.up, "give a unit vector");
    detail::require_range(function, "max_slope", def.max_slope, 0, 1.5f);
    detail::require_range(function, "step_height", def.step_height, 0, max_coordinate);
    detail::require_range(function, "snap_distance", def.snap_distance, 0, max_coordinate);
    detail::require_range(function, "skin", def.skin, 0.001f, 0.1f);
    detail::require_range(function, "push_force", def.push_force, 0, 1e20f);
    detail::validate(CharacterMove::grown(def.geometry, CharacterMove::skin(def)), function,
                     tolerances); // the largest shapes leave no room for the skin
}

void Character::set_position(Vec2 position)
{
    detail::require_within("set_position", "position", position, max_coordinate);
    position_ = position;
    ground_ = {};
}

Vec2 Character::move(World& world, Vec2 velocity, float dt)
{
    detail::require_queryable(world.state("move"), "move");
    if (world.length_unit() != def_.length_unit)
        detail::usage_error("move", "world.length_unit", world.length_unit(), "make the character with the same CharacterDef::length_unit");
    detail::require_within("move", "velocity", velocity, max_speed);
    detail::require_range("move", "dt", dt, 1e-6f, 1.0f);
    return CharacterMove(*this, world, velocity, dt).run();
}

} // namespace carom
