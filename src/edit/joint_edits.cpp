// Joints come and go: in the store, in the solver's colours, and in what their bodies may touch.
#include "edit/edits.hpp"

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

template <class Action>
void for_each_joint(const BodyStore& bodies, const JointStore& joints, std::uint32_t body, Action&& action)
{
    for (std::uint32_t edge = bodies.records[body].first_joint; edge != null_index;)
    {
        const std::uint32_t next = joints.joints[edge / 2].next[edge % 2];
        action(edge / 2);
        edge = next;
    }
}

/// Ends what two bodies do to each other; sensors stay.
void destroy_contacts_between(WorldState& world, std::uint32_t a, std::uint32_t b)
{
    std::uint32_t edge = world.bodies.records[b].first_contact;
    while (edge != null_index)
    {
        const Contact& contact = world.contacts.contacts[edge / 2];
        const std::uint32_t next = contact.next[edge % 2];
        if (!contact.is_sensor && (edge % 2 == 0 ? contact.body_b : contact.body_a) == a) destroy_contact(world, edge / 2);
        edge = next;
    }
}

/// Looks for pairs of a body's shapes anew in the next step.
void seek_pairs(WorldState& world, std::uint32_t body)
{
    if (!world.bodies.records[body].is_enabled) return;
    for (std::uint32_t s = world.bodies.records[body].first_shape; s != null_index; s = world.shapes.records[s].next_of_body)
        world.shapes.mark_changed(s);
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

BodyId id_of(const WorldState& world, std::uint32_t body)
{
    if (body == null_index) return {};
    return {body, world.bodies.slots.generation(body), world.world};
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
    world.events.joint_break.push_back({.joint = {slot, world.joints.slots.generation(slot), world.world},
                                        .body_a = id_of(world, joint.body_a),
                                        .body_b = id_of(world, joint.body_b),
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
    for_each_joint(graph.bodies, graph.joints, body, [&](std::uint32_t joint) { refresh_joint(graph, joint); });
}

void retire_joints_of_body(const BodyStore& bodies, JointStore& joints, std::uint32_t body)
{
    for_each_joint(bodies, joints, body, [&](std::uint32_t joint) { retire_joint(joints, joint); });
}

} // namespace carom::detail
