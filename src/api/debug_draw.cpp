// Walks a world for a visitor, between two steps or in the middle of one.
#include "dynamics/ids.hpp"
#include "math/usage_error.hpp"
#include "step/mid_step.hpp"

namespace carom::detail
{

namespace
{

static_assert(DebugContact::overflow == overflow_color);

/// A world and, in the middle of a step, what is not in its stores yet.
struct Picture
{
    const WorldState& world;
    const MidStep* moment = nullptr; ///< null between two steps

    bool is_solving() const { return moment && moment->is_solving(); }
    BodyId body(std::uint32_t slot) const { return id_or_null<BodyId>(world.bodies, slot, world.world); }
    ShapeId shape(std::uint32_t slot) const { return shape_id(world.shapes, slot, world.world); }
};

void draw_nodes(const Picture& picture, DebugDraw& visitor)
{
    std::vector<BroadPhaseNode> nodes;
    picture.world.broad_phase->list_nodes(nodes);
    for (const BroadPhaseNode& node : nodes) visitor.broad_phase_node(node.bounds, node.depth);
}

void draw_shapes(const Picture& picture, DebugDraw& visitor)
{
    const ShapeStore& shapes = picture.world.shapes;
    for (std::uint32_t slot = 0; slot < shapes.slots.size(); ++slot)
    {
        if (!shapes.slots.is_live(slot)) continue;
        const std::uint32_t body = shapes.records[slot].body;
        visitor.shape(picture.shape(slot), picture.body(body), shapes.geometry[slot], picture.world.bodies.pose_now(body).transform);
    }
}

void draw_bounds(const Picture& picture, DebugDraw& visitor)
{
    const ShapeStore& shapes = picture.world.shapes;
    for (std::uint32_t slot = 0; slot < shapes.slots.size(); ++slot)
    {
        if (!shapes.slots.is_live(slot) || !picture.world.bodies.records[shapes.records[slot].body].is_enabled) continue;
        visitor.bounds(picture.shape(slot), shapes.bounds[slot].tight, shapes.bounds[slot].fat);
    }
}

void draw_bodies(const Picture& picture, DebugDraw& visitor)
{
    const BodyStore& bodies = picture.world.bodies;
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot)
    {
        if (!bodies.slots.is_live(slot)) continue;
        const BodyRecord& record = bodies.records[slot];
        const BodyPose pose = bodies.pose_now(slot);
        visitor.body({.id = picture.body(slot),
                      .type = record.type,
                      .transform = pose.transform,
                      .center_of_mass = pose.center,
                      .linear_velocity = bodies.velocity(slot),
                      .angular_velocity = bodies.spin(slot),
                      .is_awake = bodies.is_active(slot),
                      .is_enabled = record.is_enabled,
                      .island = record.island == null_index ? -1 : static_cast<int>(record.island)});
    }
}

void draw_pairs(const Picture& picture, DebugDraw& visitor)
{
    const ContactStore& contacts = picture.world.contacts;
    for (const Contact& contact : contacts.contacts)
        if (contact.is_live) visitor.pair(picture.shape(contact.shape_a), picture.shape(contact.shape_b), contacts.is_new(contact));
}

/// The manifolds of all contacts; in mid-solve with what the rows hold.
void draw_contacts(const Picture& picture, DebugDraw& visitor)
{
    const ContactStore& contacts = picture.world.contacts;
    std::vector<Manifold> manifolds;
    manifolds.reserve(contacts.slots.size());
    for (std::uint32_t slot = 0; slot < contacts.slots.size(); ++slot)
        manifolds.push_back(public_manifold(contacts.manifolds[slot], contacts.results[slot]));
    if (picture.is_solving()) picture.moment->solver.show(picture.world.bodies.motions, manifolds, picture.moment->is_within_substep());
    for (std::uint32_t slot = 0; slot < contacts.slots.size(); ++slot)
    {
        const Contact& contact = contacts.contacts[slot];
        if (!contact.is_live || contact.is_sensor || manifolds[slot].point_count == 0) continue;
        visitor.contact({.shape_a = picture.shape(contact.shape_a),
                         .shape_b = picture.shape(contact.shape_b),
                         .manifold = manifolds[slot],
                         .color = contact.color == no_color ? -1 : int{contact.color},
                         .is_touching = contact.is_touching});
    }
}

Vec2 anchor(const BodyStore& bodies, std::uint32_t body, const Transform& frame)
{
    return body == null_index ? frame.p : bodies.pose_now(body).transform * frame.p;
}

void draw_joints(const Picture& picture, DebugDraw& visitor)
{
    const JointStore& joints = picture.world.joints;
    std::vector<Vec2> forces; // in mid-solve, as the rows have them
    if (picture.is_solving())
    {
        for (const Joint& joint : joints.joints) forces.push_back(joint.force);
        picture.world.joint_solver.show(forces, 1 / picture.moment->dt, picture.moment->is_within_substep());
    }
    for (std::uint32_t slot = 0; slot < joints.slots.size(); ++slot)
    {
        if (!joints.slots.is_live(slot)) continue;
        const Joint& joint = joints.joints[slot];
        const auto* mouse = std::get_if<MouseJoint>(&joint.spec);
        visitor.joint({.id = id_of<JointId>(joints, slot, picture.world.world),
                       .type = static_cast<JointType>(joint.spec.index()),
                       .body_a = picture.body(joint.body_a),
                       .body_b = picture.body(joint.body_b),
                       .anchor_a = mouse ? mouse->target : anchor(picture.world.bodies, joint.body_a, joint.frame_a),
                       .anchor_b = anchor(picture.world.bodies, joint.body_b, joint.frame_b),
                       .force = forces.empty() ? joint.force : forces[slot]});
    }
}

void draw(const Picture& picture, DebugDraw& visitor, DrawPart parts)
{
    const auto bits = static_cast<unsigned>(parts);
    if ((bits & ~static_cast<unsigned>(DrawPart::All)) != 0) usage_error("debug_draw", "parts", bits, "combine values of DrawPart");

    if (includes(parts, DrawPart::BroadPhase)) draw_nodes(picture, visitor);
    if (includes(parts, DrawPart::Shapes)) draw_shapes(picture, visitor);
    if (includes(parts, DrawPart::Bounds)) draw_bounds(picture, visitor);
    if (includes(parts, DrawPart::Bodies)) draw_bodies(picture, visitor);
    if (includes(parts, DrawPart::Pairs)) draw_pairs(picture, visitor);
    if (includes(parts, DrawPart::Contacts)) draw_contacts(picture, visitor);
    if (includes(parts, DrawPart::Joints)) draw_joints(picture, visitor);
}

} // namespace

} // namespace carom::detail

namespace carom
{

void World::debug_draw(DebugDraw& visitor, DrawPart parts) const { detail::draw({state("debug_draw")}, visitor, parts); }

void StepView::debug_draw(DebugDraw& visitor, DrawPart parts) const { detail::draw({moment_->world, moment_}, visitor, parts); }

} // namespace carom
