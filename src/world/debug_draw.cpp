// Walks a world for a visitor.
#include "world/world_state.hpp"

namespace carom
{

namespace
{

void draw_shapes(const detail::WorldState& world, DebugDraw& visitor)
{
    const detail::ShapeStore& shapes = world.shapes;
    for (std::uint32_t slot = 0; slot < shapes.slots.size(); ++slot)
    {
        if (!shapes.slots.is_live(slot)) continue;
        const std::uint32_t body = shapes.records[slot].body;
        const ShapeId id = detail::shape_id(shapes, slot, world.world);
        visitor.shape(id, {body, world.bodies.slots.generation(body), world.world}, shapes.geometry[slot],
                      world.bodies.poses[body].transform);
        if (world.bodies.records[body].is_enabled) visitor.bounds(id, shapes.bounds[slot].tight, shapes.bounds[slot].fat);
    }
}

void draw_contacts(const detail::WorldState& world, DebugDraw& visitor)
{
    for (std::uint32_t slot = 0; slot < world.contacts.slots.size(); ++slot)
    {
        const detail::Contact& contact = world.contacts.contacts[slot];
        const detail::ContactManifold& manifold = world.contacts.manifolds[slot];
        if (!contact.is_live || contact.is_sensor || manifold.count == 0) continue;
        visitor.contact(detail::shape_id(world.shapes, contact.shape_a, world.world),
                        detail::shape_id(world.shapes, contact.shape_b, world.world), detail::public_manifold(manifold));
    }
}

} // namespace

void World::debug_draw(DebugDraw& visitor) const
{
    const detail::WorldState& world = state("debug_draw");
    std::vector<detail::BroadPhaseNode> nodes;
    world.broad_phase->list_nodes(nodes);
    for (const detail::BroadPhaseNode& node : nodes) visitor.broad_phase_node(node.bounds, node.depth);

    draw_shapes(world, visitor);
    for (std::uint32_t slot = 0; slot < world.bodies.slots.size(); ++slot)
        if (world.bodies.slots.is_live(slot))
            visitor.center_of_mass({slot, world.bodies.slots.generation(slot), world.world}, world.bodies.poses[slot].center);
    draw_contacts(world, visitor);
}

} // namespace carom
