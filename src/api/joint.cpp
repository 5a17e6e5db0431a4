// Joints as the public API shows them: World's calls and the view of a joint.
#include <carom/joint.hpp>

#include "api/validate.hpp"
#include "dynamics/ids.hpp"
#include "dynamics/walks.hpp"
#include "edit/edits.hpp"
#include "solver/joints/joint_setup.hpp"
#include "state/guards.hpp"

#include <algorithm>
#include <cmath>

namespace carom
{

using detail::null_index;
using detail::require_idle;
using detail::require_joint;
using detail::WorldState;

namespace
{

JointId joint_id(const WorldState& world, std::uint32_t slot) { return detail::id_of<JointId>(world.joints, slot, world.world); }

/// Null for the world itself.
BodyId joined_body(const WorldState& world, std::uint32_t slot) { return detail::id_or_null<BodyId>(world.bodies, slot, world.world); }

const detail::Joint& read(const WorldState& world, JointId id, std::string_view function)
{
    return world.joints.joints[require_joint(world, id, function)];
}

std::uint32_t editable(const WorldState& world, JointId id, std::string_view function)
{
    require_idle(world, function);
    return require_joint(world, id, function);
}

/// The transform of a body, or of the world for a null id.
Transform place_of(const WorldState& world, BodyId id, std::string_view function, std::string_view field)
{
    return id ? world.bodies.poses[detail::require_body(world, id, function, field)].transform : Transform{};
}

Transform seen_from(const Transform& body, Vec2 point, Rot axis) { return {inverse_transform(body, point), relative(body.q, axis)}; }

} // namespace

// ---- world ----

JointId World::create_joint(const JointDef& def, const JointSpec& spec)
{
    WorldState& world = state("create_joint");
    require_idle(world, "create_joint");
    detail::validate(world, def, "create_joint");
    detail::validate(spec, "create_joint", world.shapes.tolerances);
    detail::validate_ends(def, spec, "create_joint");
    return joint_id(world, detail::create_joint(world, def, spec));
}

void World::destroy_joint(JointId id)
{
    WorldState& world = state("destroy_joint");
    require_idle(world, "destroy_joint");
    detail::destroy_joint(world, require_joint(world, id, "destroy_joint"));
}

JointDef World::joint_at(BodyId a, BodyId b, Vec2 point, float axis) const
{
    const WorldState& world = state("joint_at");
    detail::require_within("joint_at", "point", point, max_coordinate);
    detail::require_finite("joint_at", "axis", axis);
    const Rot q = rotation(axis);
    return {.body_a = a,
            .body_b = b,
            .frame_a = seen_from(place_of(world, a, "joint_at", "a"), point, q),
            .frame_b = seen_from(place_of(world, b, "joint_at", "b"), point, q)};
}

MotorJoint World::motor_joint_as_placed(const JointDef& def) const
{
    const WorldState& world = state("motor_joint_as_placed");
    detail::validate(world, def, "motor_joint_as_placed");
    const Transform a = place_of(world, def.body_a, "motor_joint_as_placed", "body_a") * def.frame_a;
    const Transform b = place_of(world, def.body_b, "motor_joint_as_placed", "body_b") * def.frame_b;
    return {.offset = inverse_transform(a, b.p), .angle = angle(relative(a.q, b.q))};
}

JointDef World::joint_between(BodyId a, BodyId b, Vec2 point_a, Vec2 point_b) const
{
    const WorldState& world = state("joint_between");
    detail::require_within("joint_between", "point_a", point_a, max_coordinate);
    detail::require_within("joint_between", "point_b", point_b, max_coordinate);
    const Vec2 along = normalize(point_b - point_a);
    const Rot q = along == Vec2{} ? Rot{} : Rot{along.x, along.y};
    return {.body_a = a,
            .body_b = b,
            .frame_a = seen_from(place_of(world, a, "joint_between", "a"), point_a, q),
            .frame_b = seen_from(place_of(world, b, "joint_between", "b"), point_b, q)};
}

Joint World::joint(JointId id)
{
    WorldState& world = state("joint");
    require_joint(world, id, "joint");
    return {world, id};
}

JointView World::joint(JointId id) const
{
    WorldState& world = state("joint");
    require_joint(world, id, "joint");
    return {world, id};
}

std::optional<Joint> World::find_joint(JointId id)
{
    WorldState& world = state("find_joint");
    if (id.world != world.world || !world.joints.slots.is_live(id.index, id.generation)) return std::nullopt;
    return Joint(world, id);
}

std::optional<JointView> World::find_joint(JointId id) const
{
    WorldState& world = state("find_joint");
    if (id.world != world.world || !world.joints.slots.is_live(id.index, id.generation)) return std::nullopt;
    return JointView(world, id);
}

std::vector<JointId> World::joints() const
{
    const WorldState& world = state("joints");
    std::vector<JointId> ids;
    ids.reserve(static_cast<std::size_t>(world.joints.slots.live_count()));
    for (std::uint32_t slot = 0; slot < world.joints.slots.size(); ++slot)
        if (world.joints.slots.is_live(slot)) ids.push_back(joint_id(world, slot));
    return ids;
}

std::vector<JointId> World::joints_of(BodyId body) const
{
    const WorldState& world = state("joints_of");
    std::vector<JointId> ids;
    for (const detail::Tie joint : detail::joints_of(world.bodies, world.joints, detail::require_body(world, body, "joints_of")))
        ids.push_back(joint_id(world, joint.slot));
    std::sort(ids.begin(), ids.end());
    return ids;
}

int World::joint_count() const { return state("joint_count").joints.slots.live_count(); }

// ---- reading ----

JointType JointView::type() const { return static_cast<JointType>(read(*world_, id_, "type").spec.index()); }

const JointSpec& JointView::spec() const { return read(*world_, id_, "spec").spec; }

BodyId JointView::body_a() const { return joined_body(*world_, read(*world_, id_, "body_a").body_a); }

BodyId JointView::body_b() const { return joined_body(*world_, read(*world_, id_, "body_b").body_b); }

Transform JointView::frame_a() const { return read(*world_, id_, "frame_a").frame_a; }

Transform JointView::frame_b() const { return read(*world_, id_, "frame_b").frame_b; }

bool JointView::collide_connected() const { return read(*world_, id_, "collide_connected").collide_connected; }

float JointView::break_force() const { return read(*world_, id_, "break_force").break_force; }

float JointView::break_torque() const { return read(*world_, id_, "break_torque").break_torque; }

std::uint64_t JointView::user_data() const { return read(*world_, id_, "user_data").user_data; }

Vec2 JointView::force() const { return read(*world_, id_, "force").force; }

float JointView::torque() const { return read(*world_, id_, "torque").torque; }

float JointView::angle() const
{
    const detail::Joint& joint = read(*world_, id_, "angle");
    const Transform a = detail::world_frame(world_->bodies, joint.body_a, joint.frame_a);
    const Transform b = detail::world_frame(world_->bodies, joint.body_b, joint.frame_b);
    const float wrapped = carom::angle(relative(a.q, b.q));
    return std::holds_alternative<RevoluteJoint>(joint.spec) ? detail::unwrapped(wrapped, joint.angle) : wrapped;
}

Vec2 JointView::offset() const
{
    const detail::Joint& joint = read(*world_, id_, "offset");
    const Transform a = detail::world_frame(world_->bodies, joint.body_a, joint.frame_a);
    return inverse_transform(a, detail::world_frame(world_->bodies, joint.body_b, joint.frame_b).p);
}

float JointView::error() const
{
    const detail::Joint& joint = read(*world_, id_, "error");
    const Vec2 apart = offset();
    const float turn = std::abs(angle());
    if (std::holds_alternative<RevoluteJoint>(joint.spec)) return length(apart);
    if (std::holds_alternative<PrismaticJoint>(joint.spec)) return std::max(std::abs(apart.y), turn);
    if (std::holds_alternative<WheelJoint>(joint.spec)) return std::abs(apart.y);
    if (std::holds_alternative<GearJoint>(joint.spec)) return std::abs(joint.gear_slip);
    if (const auto* weld = std::get_if<WeldJoint>(&joint.spec))
        return std::max(weld->linear ? 0.0f : length(apart), weld->angular ? 0.0f : turn);
    if (const auto* rod = std::get_if<DistanceJoint>(&joint.spec))
    {
        const float l = length(apart);
        if (rod->limit) return std::max({0.0f, l - rod->limit->upper, rod->limit->lower - l});
        return rod->spring ? 0.0f : std::abs(l - rod->length);
    }
    if (const auto* rope = std::get_if<PulleyJoint>(&joint.spec))
    {
        const Vec2 a = detail::world_frame(world_->bodies, joint.body_a, joint.frame_a).p;
        const Vec2 b = detail::world_frame(world_->bodies, joint.body_b, joint.frame_b).p;
        return std::max(0.0f, distance(a, rope->ground_a) + rope->ratio * distance(b, rope->ground_b) - rope->length);
    }
    return 0;
}

// ---- changing ----

void Joint::set_spec(const JointSpec& spec)
{
    const std::uint32_t slot = editable(*world_, id_, "set_spec");
    detail::validate(spec, "set_spec", world_->shapes.tolerances);
    detail::Joint& joint = world_->joints.joints[slot];
    if (spec.index() != joint.spec.index())
        detail::usage_error("set_spec", "spec", static_cast<int>(spec.index()), "give one of the joint's own type, or make another joint");
    const bool is_same_shape = detail::shape_of(spec).key() == detail::shape_of(joint.spec).key();
    world_->joints.set_spec(slot, spec);
    detail::wake_ends(*world_, joint);
    if (!is_same_shape) detail::forget_impulses(joint);
}

void Joint::set_frames(const Transform& frame_a, const Transform& frame_b)
{
    const std::uint32_t slot = editable(*world_, id_, "set_frames");
    detail::validate_frame(frame_a, "frame_a", "set_frames");
    detail::validate_frame(frame_b, "frame_b", "set_frames");
    detail::Joint& joint = world_->joints.joints[slot];
    joint.frame_a = frame_a;
    joint.frame_b = frame_b;
    detail::wake_ends(*world_, joint);
    detail::forget_impulses(joint);
}

void Joint::set_collide_connected(bool collide_connected)
{
    detail::set_collide_connected(*world_, editable(*world_, id_, "set_collide_connected"), collide_connected);
}

void Joint::set_break_limits(float force, float torque)
{
    const std::uint32_t slot = editable(*world_, id_, "set_break_limits");
    detail::validate_break_limit(force, "force", "set_break_limits");
    detail::validate_break_limit(torque, "torque", "set_break_limits");
    world_->joints.joints[slot].break_force = force;
    world_->joints.joints[slot].break_torque = torque;
}

void Joint::set_user_data(std::uint64_t user_data) { world_->joints.joints[editable(*world_, id_, "set_user_data")].user_data = user_data; }

} // namespace carom
