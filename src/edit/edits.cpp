// Keeps the stores, the broad phase, the pairs and the colours consistent while bodies and shapes come, go and change.
#include "edit/edits.hpp"

#include "dynamics/finalize_bodies.hpp"
#include "dynamics/find_pairs.hpp"
#include "dynamics/mix_materials.hpp"
#include "dynamics/walks.hpp"
#include "edit/wake.hpp"
#include "geometry/bounds.hpp"
#include "geometry/extent.hpp"
#include "geometry/mass.hpp"
#include "memory/make_room.hpp"
#include "solver/rows/graph_colors.hpp"

#include <algorithm>
#include <limits>

namespace carom::detail
{

namespace
{

ProxyKind kind_of(const WorldState& world, std::uint32_t body)
{
    return world.bodies.records[body].type == BodyType::Static ? ProxyKind::Static : ProxyKind::Moving;
}

/// A shape has a proxy while its body is enabled.
void insert_proxy(WorldState& world, std::uint32_t shape)
{
    const std::uint32_t body = world.shapes.records[shape].body;
    ShapeBounds& bounds = world.shapes.bounds[shape];
    bounds.tight = detail::bounds_of(world.shapes.geometry[shape], world.bodies.poses[body].transform);
    bounds.fat = fattened(bounds.tight, {}, world.shapes.tolerances.max_bounds_margin);
    world.broad_phase->insert(shape, bounds.fat, kind_of(world, body));
    world.shapes.mark_changed(shape);
    world.shapes.records[shape].placed_at = world.step_count;
    world.must_review = true;
}

void remove_proxy(WorldState& world, std::uint32_t shape)
{
    world.broad_phase->remove(shape);
    world.shapes.unmark_moved(shape);
}

void link_shape(WorldState& world, std::uint32_t body, std::uint32_t shape)
{
    BodyRecord& record = world.bodies.records[body];
    world.shapes.records[shape].previous_of_body = record.last_shape;
    if (record.last_shape != null_index)
        world.shapes.records[record.last_shape].next_of_body = shape;
    else
        record.first_shape = shape;
    record.last_shape = shape;
    ++record.shape_count;
}

void unlink_shape(WorldState& world, std::uint32_t body, std::uint32_t shape)
{
    BodyRecord& record = world.bodies.records[body];
    const std::uint32_t previous = world.shapes.records[shape].previous_of_body;
    const std::uint32_t next = world.shapes.records[shape].next_of_body;
    (previous != null_index ? world.shapes.records[previous].next_of_body : record.first_shape) = next;
    (next != null_index ? world.shapes.records[next].previous_of_body : record.last_shape) = previous;
    --record.shape_count;
}

} // namespace

namespace
{

/// Room for the bodies to come in all lists that edits and steps put bodies on.
void make_room_for_bodies(WorldState& world, std::size_t count)
{
    world.islands.make_room_for(count);
    make_room(world.events.fell_asleep, count);
    make_room(world.events.woke, count);
}

} // namespace

std::uint32_t create_body(WorldState& world, const BodyDef& def)
{
    make_room_for_bodies(world, world.bodies.records.size() + 1);
    const std::uint32_t body = world.bodies.create(def);
    refresh_island(world.bodies, world.islands, body);
    return body;
}

void reserve_for_edits(WorldState& world)
{
    make_room_for_bodies(world, world.bodies.records.size());
    world.bodies.make_room();
    world.shapes.make_room();
    world.contacts.make_room_to_wake();
    make_room(world.events.joint_break, world.joints.joints.size());
}

void shrink(WorldState& world)
{
    world.bodies.shrink();
    world.shapes.shrink();
    world.chains.shrink();
    world.contacts.shrink();
    world.joints.shrink();
    world.islands.shrink(world.bodies.records.size());
    world.fields.slots.drop_tail();
    cut(world.fields.fields, world.fields.slots.size());
    world.pairs.shrink();
    set_broad_phase(world, world.broad_phase->type(), world.broad_phase_options);

    world.events.shrink();
    cut(world.quarantined, 0);
    cut(world.quarantine_reasons, 0);
    world.joint_solver = JointSolver(world.memory_for(MemoryCategory::Solver));
    world.field_forces = FieldForces(world.memory_for(MemoryCategory::Solver));
    world.arena.release();
    reserve_for_edits(world);
}

std::uint32_t create_shape(WorldState& world, std::uint32_t body, const Geometry& geometry, const ShapeDef& def)
{
    const std::uint32_t shape = world.shapes.create(body, geometry, def);
    // From here on `geometry` may dangle: it may have been a shape's of this world, and the store has grown.
    const Geometry& stored = world.shapes.geometry[shape];
    Rollback without_proxy([&] { world.shapes.destroy(shape); });
    if (world.bodies.records[body].is_enabled)
        insert_proxy(world, shape);
    else
        world.shapes.bounds[shape].tight = detail::bounds_of(stored, world.bodies.poses[body].transform);
    without_proxy.dismiss();

    link_shape(world, body, shape);
    if (world.bodies.records[body].shape_count == 2) // it is no longer alone
        for (const Tie contact : contacts_of(world.bodies, world.contacts, body))
            world.contacts.contacts[contact.slot].neighborhood = Neighborhood::Unknown;
    MassData& mass = world.bodies.records[body].shapes_mass;
    mass = combined(mass, mass_from(stored, def.density));
    wake_body(world, body);
    world.bodies.refresh_mass(body);
    refresh_extent(world, body);
    return shape;
}

void destroy_shape(WorldState& world, std::uint32_t shape)
{
    const std::uint32_t body = world.shapes.records[shape].body;
    wake_body(world, body);
    remove_shape(world, shape);
    refresh_mass(world, body);
}

void remove_shape(WorldState& world, std::uint32_t shape)
{
    const std::uint32_t body = world.shapes.records[shape].body;
    destroy_contacts_of_shape(world, shape);
    if (world.bodies.records[body].is_enabled) remove_proxy(world, shape);
    unlink_shape(world, body, shape);
    world.shapes.destroy(shape);
}

void destroy_body(WorldState& world, std::uint32_t body)
{
    wake_with_neighbors(world, body);
    while (world.bodies.records[body].first_joint != null_index) destroy_joint(world, world.bodies.records[body].first_joint / 2);
    destroy_contacts_of_body(world, body);
    const bool has_proxies = world.bodies.records[body].is_enabled;
    for (const std::uint32_t shape : shapes_of(world.bodies, world.shapes, body))
    {
        if (has_proxies) remove_proxy(world, shape);
        const std::uint32_t chain = world.shapes.records[shape].chain;
        if (chain != null_index && world.chains.records[chain].first_shape == shape) world.chains.destroy(chain);
        world.shapes.destroy(shape);
    }
    if (world.bodies.records[body].island != null_index) world.islands.remove(body, world.bodies);
    world.bodies.destroy(body);
}

void end_contact(const WakeGraph& graph, ShapeStore& shapes, PairSet& pairs, EventBuffers& events, std::uint32_t world,
                 std::uint32_t contact)
{
    const Contact& pair = graph.contacts.contacts[contact];
    const ContactManifold& manifold = graph.contacts.manifolds[contact];
    note_end(pair, result_of(manifold, graph.contacts.results[contact]), shapes, world, events);
    if (!pair.is_sensor && manifold.count > 0)
    {
        wake_body(graph, pair.body_a);
        wake_body(graph, pair.body_b);
        graph.islands.unlink(pair.body_a, pair.body_b, graph.bodies);
    }
    take_color(contact, graph.contacts, graph.bodies);
    if (overlaps(shapes.searched[pair.shape_a], shapes.searched[pair.shape_b])) shapes.forget_search(pair.shape_a); // of one is enough
    pairs.erase({pair.shape_a, pair.shape_b});
    graph.contacts.destroy(contact, graph.bodies);
}

void destroy_contact(WorldState& world, std::uint32_t contact)
{
    end_contact(world, world.shapes, world.pairs, world.events, world.world, contact);
}

void destroy_contacts_of_body(WorldState& world, std::uint32_t body)
{
    while (world.bodies.records[body].first_contact != null_index) destroy_contact(world, world.bodies.records[body].first_contact / 2);
}

void destroy_contacts_of_shape(WorldState& world, std::uint32_t shape)
{
    for_each_contact_of_shape(world, shape, [&](std::uint32_t contact) { destroy_contact(world, contact); });
}

void mix_again(WorldState& world, std::uint32_t contact)
{
    const HooksGuard guard(world);
    Contact& pair = world.contacts.contacts[contact];
    world.contacts.manifolds[contact].surface = mix_materials(pair, world.shapes, world.rules);
    pair.is_disabled = false;
}

void mix_all_again(WorldState& world)
{
    for (std::uint32_t slot = 0; slot < world.contacts.slots.size(); ++slot)
        if (world.contacts.contacts[slot].is_live) mix_again(world, slot);
}

void set_material(WorldState& world, std::uint32_t shape, const Material& material)
{
    world.shapes.records[shape].material = material;
    wake_with_neighbors(world, world.shapes.records[shape].body);
    for_each_contact_of_shape(world, shape, [&](std::uint32_t contact) { mix_again(world, contact); });
}

void set_filter(WorldState& world, std::uint32_t shape, const Filter& filter)
{
    ShapeRecord& record = world.shapes.records[shape];
    if (record.filter == filter) return;
    record.filter = filter;
    record.placed_at = world.step_count;
    wake_with_neighbors(world, record.body);
    world.must_review = true;
    for_each_contact_of_shape(world, shape, [&](std::uint32_t slot)
    {
        const Contact& contact = world.contacts.contacts[slot];
        if (!judge_pair(world.shapes, world.bodies, world.joints, {contact.shape_a, contact.shape_b}).makes_contact)
            destroy_contact(world, slot);
    });
    if (world.bodies.records[record.body].is_enabled) world.shapes.mark_changed(shape);
}

void set_body_type(WorldState& world, std::uint32_t body, BodyType type)
{
    if (world.bodies.records[body].type == type) return;
    wake_with_neighbors(world, body);
    destroy_contacts_of_body(world, body);
    retire_joints_of_body(world.bodies, world.joints, body);
    world.bodies.records[body].type = type;
    world.bodies.records[body].is_asleep = false;
    refresh_mass(world, body);
    refresh_island(world.bodies, world.islands, body);
    refresh_joints_of_body(world, body);
    if (world.bodies.records[body].is_enabled)
        for (const std::uint32_t shape : shapes_of(world.bodies, world.shapes, body)) renew_proxy(world, shape);
}

void set_body_enabled(WorldState& world, std::uint32_t body, bool is_enabled)
{
    if (world.bodies.records[body].is_enabled == is_enabled) return;
    wake_with_neighbors(world, body);
    destroy_contacts_of_body(world, body);
    world.bodies.records[body].is_enabled = is_enabled;
    world.bodies.records[body].is_asleep = false;
    world.bodies.refresh(body);
    refresh_island(world.bodies, world.islands, body);
    refresh_joints_of_body(world, body);
    for (const std::uint32_t shape : shapes_of(world.bodies, world.shapes, body))
        is_enabled ? insert_proxy(world, shape) : remove_proxy(world, shape);
}

void set_body_transform(WorldState& world, std::uint32_t body, const Transform& transform)
{
    wake_with_neighbors(world, body);
    review_contacts(world, body);
    world.bodies.set_transform(body, transform);
    for (const std::uint32_t shape : shapes_of(world.bodies, world.shapes, body)) world.shapes.records[shape].placed_at = world.step_count;
    if (world.bodies.records[body].is_enabled)
        refresh_bounds(body, world.bodies, world.shapes, *world.broad_phase, {});
    else
        for (const std::uint32_t shape : shapes_of(world.bodies, world.shapes, body))
            world.shapes.bounds[shape].tight = detail::bounds_of(world.shapes.geometry[shape], transform);
}

void refresh_mass(WorldState& world, std::uint32_t body)
{
    MassData sum;
    for (const std::uint32_t shape : shapes_of(world.bodies, world.shapes, body))
        sum = combined(sum, mass_from(world.shapes.geometry[shape], world.shapes.records[shape].density));
    world.bodies.records[body].shapes_mass = sum;
    world.bodies.refresh_mass(body);
    refresh_extent(world, body);
}

void refresh_extent(WorldState& world, std::uint32_t body)
{
    BodyRecord& record = world.bodies.records[body];
    if (record.type == BodyType::Static) return; // nobody asks, and a ground may have many shapes
    record.inner_radius = record.first_shape == null_index ? 0 : std::numeric_limits<float>::max();
    record.outer_radius = 0;
    for (const std::uint32_t shape : shapes_of(world.bodies, world.shapes, body))
    {
        record.inner_radius = std::min(record.inner_radius, inner_radius(world.shapes.geometry[shape]));
        record.outer_radius =
            std::max(record.outer_radius, outer_radius(world.shapes.geometry[shape], world.bodies.poses[body].local_center));
    }
    world.bodies.refresh(body);
}

void renew_proxy(WorldState& world, std::uint32_t shape)
{
    remove_proxy(world, shape);
    insert_proxy(world, shape);
}

void set_broad_phase(WorldState& world, BroadPhaseType type, const BroadPhaseOptions& options)
{
    BroadPhasePtr next = make_broad_phase(type, options, world.memory_for(MemoryCategory::BroadPhase));
    for (std::uint32_t shape = 0; shape < world.shapes.slots.size(); ++shape)
    {
        if (!world.shapes.slots.is_live(shape)) continue;
        const std::uint32_t body = world.shapes.records[shape].body;
        if (world.bodies.records[body].is_enabled) next->insert(shape, world.shapes.bounds[shape].fat, kind_of(world, body));
    }
    world.broad_phase = std::move(next);
    world.broad_phase_options = options;
}

} // namespace carom::detail
