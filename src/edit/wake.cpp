// Waking and putting to sleep, whoever asks for it: an edit, or the stage of a step.
#include "edit/wake.hpp"

#include "dynamics/walks.hpp"
#include "edit/edits.hpp"
#include "solver/rows/graph_colors.hpp"

namespace carom::detail
{

namespace
{

void activate(const WakeGraph& graph, std::uint32_t body)
{
    BodyRecord& record = graph.bodies.records[body];
    record.is_asleep = false;
    graph.bodies.refresh(body);
    graph.bodies.watches[graph.bodies.motion_index[body]].has_woken = true;
    for (const Tie contact : contacts_of(graph.bodies, graph.contacts, body)) graph.contacts.wake(contact.slot);
}

/// The body's contacts leave the solver, and with the last active body the list of those that are looked at.
void deactivate(const WakeGraph& graph, std::uint32_t body)
{
    BodyRecord& record = graph.bodies.records[body];
    graph.bodies.set_velocity(body, {});
    graph.bodies.set_spin(body, 0);
    record.is_asleep = true;
    graph.bodies.refresh(body);
    for (const Tie contact : contacts_of(graph.bodies, graph.contacts, body))
    {
        if (graph.bodies.is_active(contact.other)) continue;
        take_color(contact.slot, graph.contacts, graph.bodies);
        graph.contacts.put_to_sleep(contact.slot);
    }
}

void wake_island(const WakeGraph& graph, std::uint32_t island)
{
    if (graph.islands.is_awake(island)) return;
    graph.islands.mark_awake(island);
    for (const std::uint32_t body : bodies_of(graph.bodies, graph.islands, island)) activate(graph, body);
    for (const std::uint32_t body : bodies_of(graph.bodies, graph.islands, island)) refresh_joints_of_body(graph, body);
}

/// Whether the body disturbs whom it touches: a kinematic one that stands still is about to sleep, and counts as ground.
bool is_stirring(const BodyStore& bodies, std::uint32_t body)
{
    return bodies.is_active(body) && (!is_kinematic(bodies, body) || is_moving(bodies.motions[bodies.motion_index[body]]));
}

/// Whether an edit has put a shape of the ground upon a dynamic body that slept already.
bool is_put_upon(const BodyStore& bodies, const ShapeStore& shapes, std::uint32_t shape, std::uint32_t sleeper, std::uint64_t step_count)
{
    return bodies.is_dynamic(sleeper) && shapes.records[shape].placed_at == step_count &&
           bodies.records[sleeper].put_to_sleep_at != step_count;
}

} // namespace

void put_island_to_sleep(const WakeGraph& graph, std::uint32_t island)
{
    if (!graph.islands.is_awake(island)) return;
    graph.islands.mark_asleep(island);
    for (const std::uint32_t body : bodies_of(graph.bodies, graph.islands, island)) deactivate(graph, body);
    for (const std::uint32_t body : bodies_of(graph.bodies, graph.islands, island)) refresh_joints_of_body(graph, body);
}

bool is_push(const ContactStore& contacts, std::uint32_t contact)
{
    return !contacts.contacts[contact].is_sensor && contacts.manifolds[contact].count > 0;
}

bool is_moving(const BodyMotion& motion) { return motion.v != Vec2{} || motion.w != 0; }

bool is_kinematic(const BodyStore& bodies, std::uint32_t body) { return bodies.records[body].type == BodyType::Kinematic; }

void wake_body(const WakeGraph& graph, std::uint32_t body)
{
    const BodyRecord& record = graph.bodies.records[body];
    if (record.island != null_index)
    {
        wake_island(graph, record.island);
        if (graph.bodies.is_active(body)) graph.bodies.watches[graph.bodies.motion_index[body]].rest_time = 0;
        return;
    }
    if (!record.is_asleep) return;
    activate(graph, body);
    refresh_joints_of_body(graph, body);
}

void put_body_to_sleep(const WakeGraph& graph, std::uint32_t body, std::uint64_t step_count)
{
    const BodyRecord& record = graph.bodies.records[body];
    if (record.island != null_index)
    {
        for (const std::uint32_t each : bodies_of(graph.bodies, graph.islands, record.island))
            graph.bodies.records[each].put_to_sleep_at = step_count;
        return put_island_to_sleep(graph, record.island);
    }
    if (!graph.bodies.is_active(body)) return;
    deactivate(graph, body);
    refresh_joints_of_body(graph, body);
}

bool is_felt(const BodyStore& bodies, const ShapeStore& shapes, const Contact& contact, std::uint64_t step_count)
{
    if (is_stirring(bodies, contact.body_a) || is_stirring(bodies, contact.body_b)) return true;
    if (bodies.is_dynamic(contact.body_a) && bodies.is_dynamic(contact.body_b)) return false;
    return is_put_upon(bodies, shapes, contact.shape_a, contact.body_b, step_count) ||
           is_put_upon(bodies, shapes, contact.shape_b, contact.body_a, step_count);
}

void wake_all(const WakeGraph& graph)
{
    for (std::uint32_t island = 0; island < graph.islands.size(); ++island)
    {
        if (!graph.islands.is_live(island)) continue;
        wake_island(graph, island);
        for (const std::uint32_t body : bodies_of(graph.bodies, graph.islands, island))
            graph.bodies.watches[graph.bodies.motion_index[body]].rest_time = 0;
    }
}

void wake_with_neighbors(const WakeGraph& graph, std::uint32_t body)
{
    const bool was_awake = graph.bodies.is_active(body) && graph.bodies.records[body].island != null_index;
    wake_body(graph, body);
    if (was_awake) return; // and so was its island
    for (const Tie contact : contacts_of(graph.bodies, graph.contacts, body))
        if (is_push(graph.contacts, contact.slot)) wake_body(graph, contact.other);
    for (const Tie joint : joints_of(graph.bodies, graph.joints, body))
        if (joint.other != null_index) wake_body(graph, joint.other);
}

void review_contacts(WorldState& world, std::uint32_t body)
{
    for (const Tie contact : contacts_of(world.bodies, world.contacts, body)) world.contacts.wake(contact.slot);
    world.must_review = true;
}

void refresh_island(BodyStore& bodies, IslandStore& islands, std::uint32_t body)
{
    const BodyRecord& record = bodies.records[body];
    const bool should_have = record.is_enabled && record.type == BodyType::Dynamic;
    if (should_have && record.island == null_index) islands.add(body, bodies);
    if (!should_have && record.island != null_index) islands.remove(body, bodies);
}

} // namespace carom::detail
