// The views of a body: every call checks that the body still exists.
#include <carom/body.hpp>

#include "api/validate.hpp"
#include "dynamics/finalize_bodies.hpp"
#include "dynamics/walks.hpp"
#include "edit/edits.hpp"
#include "edit/wake.hpp"
#include "geometry/validate.hpp"
#include "state/guards.hpp"

namespace carom
{

using detail::require_body;

namespace
{

/// The slot of a body that may be changed now.
std::uint32_t editable(const detail::WorldState& world, BodyId id, std::string_view function)
{
    detail::require_idle(world, function);
    return require_body(world, id, function);
}

} // namespace

// ---- reading ----

BodyType BodyView::type() const { return world_->bodies.records[require_body(*world_, id_, "type")].type; }

Transform BodyView::transform() const { return world_->bodies.poses[require_body(*world_, id_, "transform")].transform; }

Vec2 BodyView::position() const { return world_->bodies.poses[require_body(*world_, id_, "position")].transform.p; }

float BodyView::angle() const { return carom::angle(world_->bodies.poses[require_body(*world_, id_, "angle")].transform.q); }

Vec2 BodyView::center_of_mass() const { return world_->bodies.poses[require_body(*world_, id_, "center_of_mass")].center; }

Vec2 BodyView::linear_velocity() const { return world_->bodies.velocity(require_body(*world_, id_, "linear_velocity")); }

float BodyView::angular_velocity() const { return world_->bodies.spin(require_body(*world_, id_, "angular_velocity")); }

Vec2 BodyView::velocity_at(Vec2 world_point) const
{
    const std::uint32_t body = require_body(*world_, id_, "velocity_at");
    detail::require_finite("velocity_at", "world_point", world_point);
    return world_->bodies.velocity(body) + cross(world_->bodies.spin(body), world_point - world_->bodies.poses[body].center);
}

MassData BodyView::mass_data() const { return world_->bodies.records[require_body(*world_, id_, "mass_data")].mass; }

bool BodyView::has_own_mass() const { return world_->bodies.records[require_body(*world_, id_, "has_own_mass")].has_mass_override; }

float BodyView::linear_damping() const { return world_->bodies.records[require_body(*world_, id_, "linear_damping")].linear_damping; }

float BodyView::angular_damping() const { return world_->bodies.records[require_body(*world_, id_, "angular_damping")].angular_damping; }

float BodyView::gravity_scale() const { return world_->bodies.records[require_body(*world_, id_, "gravity_scale")].gravity_scale; }

MotionLocks BodyView::locks() const { return world_->bodies.records[require_body(*world_, id_, "locks")].locks; }

bool BodyView::is_attractor() const { return world_->bodies.records[require_body(*world_, id_, "is_attractor")].is_attractor; }

bool BodyView::is_awake() const { return world_->bodies.is_active(require_body(*world_, id_, "is_awake")); }

bool BodyView::can_sleep() const { return world_->bodies.records[require_body(*world_, id_, "can_sleep")].can_sleep; }

bool BodyView::is_bullet() const { return world_->bodies.records[require_body(*world_, id_, "is_bullet")].is_bullet; }

bool BodyView::is_enabled() const { return world_->bodies.records[require_body(*world_, id_, "is_enabled")].is_enabled; }

Vec2 BodyView::force() const { return world_->bodies.drives[world_->bodies.motion_index[require_body(*world_, id_, "force")]].force; }

float BodyView::torque() const { return world_->bodies.drives[world_->bodies.motion_index[require_body(*world_, id_, "torque")]].torque; }

std::size_t BodyView::shape_count() const { return world_->bodies.records[require_body(*world_, id_, "shape_count")].shape_count; }

std::vector<ShapeId> BodyView::shapes() const
{
    const std::uint32_t body = require_body(*world_, id_, "shapes");
    std::vector<ShapeId> ids;
    ids.reserve(world_->bodies.records[body].shape_count);
    for (const std::uint32_t s : detail::shapes_of(world_->bodies, world_->shapes, body))
        ids.push_back(detail::shape_id(world_->shapes, s, world_->world));
    return ids;
}

std::string_view BodyView::name() const { return world_->bodies.records[require_body(*world_, id_, "name")].name; }

std::uint64_t BodyView::user_data() const { return world_->bodies.records[require_body(*world_, id_, "user_data")].user_data; }

Aabb BodyView::bounds() const
{
    const std::uint32_t body = require_body(*world_, id_, "bounds");
    const std::uint32_t first = world_->bodies.records[body].first_shape;
    if (first == detail::null_index) return {position(), position()};
    Aabb all = world_->shapes.bounds[first].tight;
    for (const std::uint32_t shape : detail::shapes_of(world_->bodies, world_->shapes, body))
        all = merge(all, world_->shapes.bounds[shape].tight);
    return all;
}

// ---- changing ----

void Body::set_type(BodyType type)
{
    const std::uint32_t body = editable(*world_, id_, "set_type");
    detail::validate_type(type, "set_type");
    const detail::BodyRecord& record = world_->bodies.records[body];
    if (record.has_mass_override) detail::validate_mass(record.mass_override, type, "set_type");
    detail::set_body_type(*world_, body, type);
}

void Body::set_transform(Vec2 position, float angle)
{
    const std::uint32_t body = editable(*world_, id_, "set_transform");
    detail::validate_position(position, angle, "set_transform");
    detail::set_body_transform(*world_, body, {position, rotation(angle)});
}

void Body::move_to(const Transform& target, float dt)
{
    const std::uint32_t body = editable(*world_, id_, "move_to");
    detail::BodyStore& bodies = world_->bodies;
    if (bodies.records[body].type != BodyType::Kinematic)
        detail::usage_error("move_to", "body", std::string_view(bodies.is_dynamic(body) ? "dynamic" : "static"),
                            "lead kinematic bodies; push a dynamic one, and teleport a static one with set_transform");
    detail::validate(target, "move_to", "target");
    detail::require_range("move_to", "dt", dt, detail::min_dt, detail::max_dt);

    const detail::BodyPose& pose = bodies.poses[body];
    const Vec2 velocity = (1 / dt) * (target * pose.local_center - pose.center);
    const float spin = carom::angle(relative(pose.transform.q, target.q)) / dt;
    const bool is_too_far = !(std::abs(velocity.x) <= max_speed && std::abs(velocity.y) <= max_speed && std::abs(spin) <= max_speed);
    if (is_too_far)
        detail::usage_error("move_to", "target.p", target.p, "give a place that a speed of 1e6 m/s and 1e6 rad/s reaches within dt");
    const bool stays = velocity == Vec2{} && spin == 0;
    if (stays && !bodies.is_active(body)) return; // asleep where it shall be
    detail::wake_with_neighbors(*world_, body);
    bodies.set_velocity(body, velocity);
    bodies.set_spin(body, spin);
    bodies.set_goal(body, {target.p, normalize(target.q)}, dt);
}

void Body::set_linear_velocity(Vec2 velocity)
{
    const std::uint32_t body = editable(*world_, id_, "set_linear_velocity");
    detail::validate_velocity(world_->bodies.records[body].type, velocity, "set_linear_velocity");
    detail::wake_with_neighbors(*world_, body);
    world_->bodies.set_velocity(body, velocity);
}

void Body::set_angular_velocity(float velocity)
{
    const std::uint32_t body = editable(*world_, id_, "set_angular_velocity");
    detail::validate_spin(world_->bodies.records[body].type, velocity, "set_angular_velocity");
    detail::wake_with_neighbors(*world_, body);
    world_->bodies.set_spin(body, velocity);
}

void Body::set_linear_damping(float rate)
{
    const std::uint32_t body = editable(*world_, id_, "set_linear_damping");
    detail::require_range("set_linear_damping", "rate", rate, 0, detail::max_factor);
    detail::wake_with_neighbors(*world_, body);
    world_->bodies.records[body].linear_damping = rate;
    world_->bodies.refresh(body);
}

void Body::set_angular_damping(float rate)
{
    const std::uint32_t body = editable(*world_, id_, "set_angular_damping");
    detail::require_range("set_angular_damping", "rate", rate, 0, detail::max_factor);
    detail::wake_with_neighbors(*world_, body);
    world_->bodies.records[body].angular_damping = rate;
    world_->bodies.refresh(body);
}

void Body::set_gravity_scale(float scale)
{
    const std::uint32_t body = editable(*world_, id_, "set_gravity_scale");
    detail::require_range("set_gravity_scale", "scale", scale, -detail::max_factor, detail::max_factor);
    detail::wake_with_neighbors(*world_, body);
    world_->bodies.records[body].gravity_scale = scale;
    world_->bodies.refresh(body);
}

void Body::set_locks(MotionLocks locks)
{
    const std::uint32_t body = editable(*world_, id_, "set_locks");
    detail::wake_with_neighbors(*world_, body);
    world_->bodies.records[body].locks = locks;
    world_->bodies.refresh(body);
}

void Body::set_is_attractor(bool is_attractor)
{
    world_->bodies.records[editable(*world_, id_, "set_is_attractor")].is_attractor = is_attractor;
}

void Body::set_awake(bool is_awake)
{
    const std::uint32_t body = editable(*world_, id_, "set_awake");
    if (is_awake)
        detail::wake_with_neighbors(*world_, body);
    else
        detail::put_body_to_sleep(*world_, body, world_->step_count);
}

void Body::set_can_sleep(bool can_sleep)
{
    const std::uint32_t body = editable(*world_, id_, "set_can_sleep");
    if (!can_sleep) detail::wake_body(*world_, body);
    world_->bodies.records[body].can_sleep = can_sleep;
    world_->bodies.refresh(body);
}

void Body::set_is_bullet(bool is_bullet)
{
    const std::uint32_t body = editable(*world_, id_, "set_is_bullet");
    world_->bodies.records[body].is_bullet = is_bullet;
    world_->bodies.refresh(body);
}

void Body::set_enabled(bool is_enabled) { detail::set_body_enabled(*world_, editable(*world_, id_, "set_enabled"), is_enabled); }

void Body::set_mass_data(const MassData& data)
{
    const std::uint32_t body = editable(*world_, id_, "set_mass_data");
    detail::BodyRecord& record = world_->bodies.records[body];
    detail::validate_mass(data, record.type, "set_mass_data");
    detail::wake_with_neighbors(*world_, body);
    record.has_mass_override = true;
    record.mass_override = data;
    world_->bodies.refresh_mass(body);
    detail::refresh_extent(*world_, body);
}

void Body::reset_mass_data()
{
    const std::uint32_t body = editable(*world_, id_, "reset_mass_data");
    detail::wake_with_neighbors(*world_, body);
    world_->bodies.records[body].has_mass_override = false;
    world_->bodies.refresh_mass(body);
    detail::refresh_extent(*world_, body);
}

void Body::set_name(std::string_view name) { world_->bodies.records[editable(*world_, id_, "set_name")].name = name; }

void Body::set_user_data(std::uint64_t user_data) { world_->bodies.records[editable(*world_, id_, "set_user_data")].user_data = user_data; }

void Body::apply_force(Vec2 force, Vec2 world_point)
{
    const std::uint32_t body = editable(*world_, id_, "apply_force");
    detail::require_finite("apply_force", "force", force);
    detail::require_within("apply_force", "world_point", world_point, max_coordinate);
    detail::wake_with_neighbors(*world_, body);
    if (!world_->bodies.is_pushable(body)) return;
    detail::BodyDrive& drive = world_->bodies.drives[world_->bodies.motion_index[body]];
    drive.force += force;
    drive.torque += cross(world_point - world_->bodies.poses[body].center, force);
}

void Body::apply_force_to_center(Vec2 force)
{
    const std::uint32_t body = editable(*world_, id_, "apply_force_to_center");
    detail::require_finite("apply_force_to_center", "force", force);
    detail::wake_with_neighbors(*world_, body);
    if (world_->bodies.is_pushable(body)) world_->bodies.drives[world_->bodies.motion_index[body]].force += force;
}

void Body::apply_torque(float torque)
{
    const std::uint32_t body = editable(*world_, id_, "apply_torque");
    detail::require_finite("apply_torque", "torque", torque);
    detail::wake_with_neighbors(*world_, body);
    if (world_->bodies.is_pushable(body)) world_->bodies.drives[world_->bodies.motion_index[body]].torque += torque;
}

void Body::apply_impulse(Vec2 impulse, Vec2 world_point)
{
    const std::uint32_t body = editable(*world_, id_, "apply_impulse");
    detail::require_finite("apply_impulse", "impulse", impulse);
    detail::require_within("apply_impulse", "world_point", world_point, max_coordinate);
    detail::wake_with_neighbors(*world_, body);
    if (!world_->bodies.is_pushable(body)) return;
    world_->bodies.push(body, impulse, cross(world_point - world_->bodies.poses[body].center, impulse));
}

void Body::apply_impulse_to_center(Vec2 impulse)
{
    const std::uint32_t body = editable(*world_, id_, "apply_impulse_to_center");
    detail::require_finite("apply_impulse_to_center", "impulse", impulse);
    detail::wake_with_neighbors(*world_, body);
    if (world_->bodies.is_pushable(body)) world_->bodies.push(body, impulse, 0);
}

void Body::apply_angular_impulse(float impulse)
{
    const std::uint32_t body = editable(*world_, id_, "apply_angular_impulse");
    detail::require_finite("apply_angular_impulse", "impulse", impulse);
    detail::wake_with_neighbors(*world_, body);
    if (world_->bodies.is_pushable(body)) world_->bodies.push(body, {}, impulse);
}

} // namespace carom
