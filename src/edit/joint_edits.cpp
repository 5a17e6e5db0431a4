// Joints come and go: in the store, in the solver's colours, and in what their bodies may touch.
#include "edit/edits.hpp"

#include "dynamics/ids.hpp"
#include "dynamics/walks.hpp"
#include "edit/wake.hpp"
#include "memory/make_room.hpp"

namespace carom::detail
{

namespace
{

/// The solver works on a joint when it can push one of its bodies and both take part.
bool should_be_active(const BodyStore& bodies, const Joint& joint)
{
    const bool has_a = joint.body_a != null_index;
    const bool are_enabled = (!has_a || bodies.records[joint.body_a].is_enabled) && bodies.records[joint.body_b].is_enabled;
    return are_enabled && ((has_a && bodies.is_pushable(joint.body_a)) || bodies.is_pushable(joint.body_b));
}

void retire_joint(JointStore& joints, std::uint32_t slot)
{
    Joint& joint = joints.joints[slot];
    if (!joint.is_active()) return;
    joints.deactivate(slot);
}

void refresh_joint(const WakeGraph& graph, std::uint32_t slot)
{
    Joint& joint = graph.joints.joints[slot];
    const bool should = should_be_active(graph.bodies, joint);
    if (!should) return retire_joint(graph.joints, slot);
    if (joint.is_active()) return;
    graph.joints.activate(slot);
    if (joint.body_a == null_index) return;
    const bool are_dynamic = graph.bodies.is_dynamic(joint.body_a) && graph.bodies.is_dynamic(joint.body_b);
    if (are_dynamic) graph.islands.link(joint.body_a, joint.body_b, graph.bodies);
}

/// Ends what two bodies do to each other; sensors stay.
void destroy_contacts_between(WorldState& world, std::uint32_t a, std::uint32_t b)
{
    for (const Tie contact : contacts_of(world.bodies, world.contacts, b))
        if (contact.other == a && !world.contacts.contacts[contact.slot].is_sensor) destroy_contact(world, contact.slot);
}

/// Looks for pairs of a body's shapes anew in the next step.
void seek_pairs(WorldState& world, std::uint32_t body)
{
    if (!world.bodies.records[body].is_enabled) return;
    for (const std::uint32_t shape : shapes_of(world.bodies, world.shapes, body)) world.shapes.mark_changed(shape);
    world.must_review = true;
}

void apply_collide_connected(WorldState& world, const Joint& joint)
{
    if (joint.body_a == null_index) return;
    if (joint.collide_connected)
        seek_pairs(world, joint.body_b);
    else
        destroy_contacts_between(world, joint.body_a, joint.body_b);
}

} // namespace

void wake_ends(const WakeGraph& graph, const Joint& joint)
{
    if (joint.body_a != null_index) wake_body(graph, joint.body_a);
    wake_body(graph, joint.body_b);
}

std::uint32_t create_joint(WorldState& world, const JointDef& def, const JointSpec& spec)
{
    Joint joint;
    joint.body_a = def.body_a ? def.body_a.index : null_index;
    joint.body_b = def.body_b.index;
    joint.frame_a = def.frame_a;
    joint.frame_b = def.frame_b;
    joint.spec = spec;
    joint.break_force = def.break_force;
    joint.break_torque = def.break_torque;
    joint.user_data = def.user_data;
    joint.collide_connected = def.collide_connected;
    joint.angle =
        angle(relative(world_frame(world.bodies, joint.body_a, joint.frame_a).q, world_frame(world.bodies, joint.body_b, joint.frame_b).q));

    make_room(world.events.joint_break, world.joints.joints.size() + 1);
    const std::uint32_t slot = world.joints.create(joint, world.bodies);
    wake_ends(world, joint);
    Rollback without_joint([&] { world.joints.destroy(slot, world.bodies); });
    refresh_joint(world, slot);
    without_joint.dismiss();
    if (!joint.collide_connected) apply_collide_connected(world, joint);
    return slot;
}

void destroy_joint(WorldState& world, std::uint32_t slot)
{
    const Joint joint = world.joints.joints[slot];
    wake_ends(world, joint);
    if (joint.body_a != null_index) world.islands.unlink(joint.body_a, joint.body_b, world.bodies);
    retire_joint(world.joints, slot);
    world.joints.destroy(slot, world.bodies);
    if (!joint.collide_connected && joint.body_a != null_index) seek_pairs(world, joint.body_b);
}

void note_break(WorldState& world, std::uint32_t slot)
{
    const Joint& joint = world.joints.joints[slot];
    world.events.joint_break.push_back({.joint = id_of<JointId>(world.joints, slot, world.world),
                                        .body_a = id_or_null<BodyId>(world.bodies, joint.body_a, world.world),
                                        .body_b = id_or_null<BodyId>(world.bodies, joint.body_b, world.world),
                                        .force = length(joint.force),
                                        .torque = joint.torque < 0 ? -joint.torque : joint.torque,
                                        .user_data = joint.user_data});
}

void set_collide_connected(WorldState& world, std::uint32_t slot, bool collide_connected)
{
    Joint& joint = world.joints.joints[slot];
    if (joint.collide_connected == collide_connected) return;
    joint.collide_connected = collide_connected;
    wake_ends(world, joint);
    apply_collide_connected(world, joint);
}

void refresh_joints_of_body(const WakeGraph& graph, std::uint32_t body)
{
    for (const Tie joint : joints_of(graph.bodies, graph.joints, body)) refresh_joint(graph, joint.slot);
}

void retire_joints_of_body(const BodyStore& bodies, JointStore& joints, std::uint32_t body)
{
    for (const Tie joint : joints_of(bodies, joints, body)) retire_joint(joints, joint.slot);
}

} // namespace carom::detail
