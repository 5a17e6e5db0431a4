// Waking and putting to sleep, whoever asks for it: an edit, or the stage of a step.
#include "edit/wake.hpp"

#include "edit/edits.hpp"
#include "solver/rows/graph_colors.hpp"
#include "state/walks.hpp"

namespace carom::detail
{

namespace
{

void activate(WorldState& world, std::uint32_t body)
{
    BodyRecord& record = world.bodies.records[body];
    record.is_asleep = false;
    world.bodies.refresh(body);
    world.bodies.watches[world.bodies.motion_index[body]].has_woken = true;
    for_each_contact(world, body, [&](std::uint32_t contact, std::uint32_t) { world.contacts.wake(contact); });
}

/// The body's contacts leave the solver, and with the last active body the list of those that are looked at.
void deactivate(WorldState& world, std::uint32_t body)
{
    BodyRecord& record = world.bodies.records[body];
    world.bodies.set_velocity(body, {});
    world.bodies.set_spin(body, 0);
    record.is_asleep = true;
    world.bodies.refresh(body);
    for_each_contact(world, body, [&](std::uint32_t contact, std::uint32_t other)
    {
        if (world.bodies.is_active(other)) return;
        take_color(contact, world.contacts, world.bodies);
        world.contacts.put_to_sleep(contact);
    });
}

void wake_island(WorldState& world, std::uint32_t island)
{
    if (world.islands.is_awake(island)) return;
    world.islands.mark_awake(island);
    for_each_of_island(world, island, [&](std::uint32_t body) { activate(world, body); });
    for_each_of_island(world, island, [&](std::uint32_t body) { refresh_joints_of_body(world, body); });
}

/// Whether the body disturbs whom it touches: a kinematic one that stands still is about to sleep, and counts as ground.
bool is_stirring(const WorldState& world, std::uint32_t body)
{
    return world.bodies.is_active(body) && (!is_kinematic(world, body) || is_moving(world.bodies.motions[world.bodies.motion_index[body]]));
}

/// Whether an edit has put a shape of the ground upon a dynamic body that slept already.
bool is_put_upon(const WorldState& world, std::uint32_t shape, std::uint32_t sleeper)
{
    return world.bodies.is_dynamic(sleeper) && world.shapes.records[shape].placed_at == world.step_count &&
           world.bodies.records[sleeper].put_to_sleep_at != world.step_count;
}

} // namespace

void put_island_to_sleep(WorldState& world, std::uint32_t island)
{
    if (!world.islands.is_awake(island)) return;
    world.islands.mark_asleep(island);
    for_each_of_island(world, island, [&](std::uint32_t body) { deactivate(world, body); });
    for_each_of_island(world, island, [&](std::uint32_t body) { refresh_joints_of_body(world, body); });
}

bool is_push(const WorldState& world, std::uint32_t contact)
{
    return !world.contacts.contacts[contact].is_sensor && world.contacts.manifolds[contact].count > 0;
}

bool is_moving(const BodyMotion& motion) { return motion.v != Vec2{} || motion.w != 0; }

bool is_kinematic(const WorldState& world, std::uint32_t body) { return world.bodies.records[body].type == BodyType::Kinematic; }

void wake_body(WorldState& world, std::uint32_t body)
{
    const BodyRecord& record = world.bodies.records[body];
    if (record.island != null_index)
    {
        wake_island(world, record.island);
        if (world.bodies.is_active(body)) world.bodies.watches[world.bodies.motion_index[body]].rest_time = 0;
        return;
    }
    if (!record.is_asleep) return;
    activate(world, body);
    refresh_joints_of_body(world, body);
}

void put_body_to_sleep(WorldState& world, std::uint32_t body)
{
    const BodyRecord& record = world.bodies.records[body];
    if (record.island != null_index)
    {
        for_each_of_island(world, record.island,
                           [&](std::uint32_t each) { world.bodies.records[each].put_to_sleep_at = world.step_count; });
        return put_island_to_sleep(world, record.island);
    }
    if (!world.bodies.is_active(body)) return;
    deactivate(world, body);
    refresh_joints_of_body(world, body);
}

bool is_felt(const WorldState& world, const Contact& contact)
{
    if (is_stirring(world, contact.body_a) || is_stirring(world, contact.body_b)) return true;
    if (world.bodies.is_dynamic(contact.body_a) && world.bodies.is_dynamic(contact.body_b)) return false;
    return is_put_upon(world, contact.shape_a, contact.body_b) || is_put_upon(world, contact.shape_b, contact.body_a);
}

void wake_all(WorldState& world)
{
    for (std::uint32_t island = 0; island < world.islands.size(); ++island)
    {
        if (!world.islands.is_live(island)) continue;
        wake_island(world, island);
        for_each_of_island(world, island, [&](std::uint32_t body) { world.bodies.watches[world.bodies.motion_index[body]].rest_time = 0; });
    }
}

void wake_with_neighbors(WorldState& world, std::uint32_t body)
{
    const bool was_awake = world.bodies.is_active(body) && world.bodies.records[body].island != null_index;
    wake_body(world, body);
    if (was_awake) return; // and so was its island
    for_each_contact(world, body, [&](std::uint32_t contact, std::uint32_t other)
    {
        if (is_push(world, contact)) wake_body(world, other);
    });
    for_each_joined(world, body, [&](std::uint32_t other) { wake_body(world, other); });
}

void review_contacts(WorldState& world, std::uint32_t body)
{
    for_each_contact(world, body, [&](std::uint32_t contact, std::uint32_t) { world.contacts.wake(contact); });
    world.must_review = true;
}

void refresh_island(WorldState& world, std::uint32_t body)
{
    const BodyRecord& record = world.bodies.records[body];
    const bool should_have = record.is_enabled && record.type == BodyType::Dynamic;
    if (should_have && record.island == null_index) world.islands.add(body, world.bodies);
    if (!should_have && record.island != null_index) world.islands.remove(body, world.bodies);
}

} // namespace carom::detail
