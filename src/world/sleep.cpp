// The rules of sleep.
//
// A body sleeps with its whole island. A kinematic body is not in one: it sleeps while its velocity is zero, and while it moves, whatever it
// touches or is joined to stays awake.
#include "world/sleep.hpp"

#include "world/edits.hpp"

#include <algorithm>

namespace carom::detail
{

namespace
{

template <class Action>
void for_each_contact(const WorldState& world, std::uint32_t body, Action&& action)
{
    for (std::uint32_t edge = world.bodies.records[body].first_contact; edge != null_index;)
    {
        const Contact& contact = world.contacts.contacts[edge / 2];
        const std::uint32_t next = contact.next[edge % 2];
        action(edge / 2, edge % 2 == 0 ? contact.body_b : contact.body_a);
        edge = next;
    }
}

template <class Action>
void for_each_joined(const WorldState& world, std::uint32_t body, Action&& action)
{
    for (std::uint32_t edge = world.bodies.records[body].first_joint; edge != null_index;
         edge = world.joints.joints[edge / 2].next[edge % 2])
    {
        const Joint& joint = world.joints.joints[edge / 2];
        const std::uint32_t other = edge % 2 == 0 ? joint.body_b : joint.body_a;
        if (other != null_index) action(other);
    }
}

/// Bodies that push each other: a contact between them has points.
bool is_push(const WorldState& world, std::uint32_t contact)
{
    return !world.contacts.contacts[contact].is_sensor && world.contacts.manifolds[contact].count > 0;
}

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

template <class Action>
void for_each_of_island(const WorldState& world, std::uint32_t island, Action&& action)
{
    for (std::uint32_t body = world.islands[island].first_body; body != null_index; body = world.bodies.records[body].next_in_island)
        action(body);
}

void wake_island(WorldState& world, std::uint32_t island)
{
    if (world.islands.is_awake(island)) return;
    world.islands.mark_awake(island);
    for_each_of_island(world, island, [&](std::uint32_t body) { activate(world, body); });
    for_each_of_island(world, island, [&](std::uint32_t body) { refresh_joints_of_body(world, body); });
}

void put_island_to_sleep(WorldState& world, std::uint32_t island)
{
    if (!world.islands.is_awake(island)) return;
    world.islands.mark_asleep(island);
    for_each_of_island(world, island, [&](std::uint32_t body) { deactivate(world, body); });
    for_each_of_island(world, island, [&](std::uint32_t body) { refresh_joints_of_body(world, body); });
}

bool is_moving(const BodyMotion& motion) { return motion.v != Vec2{} || motion.w != 0; }

bool is_kinematic(const WorldState& world, std::uint32_t body) { return world.bodies.records[body].type == BodyType::Kinematic; }

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

/// Keeps awake what a moving kinematic body touches or is joined to.
void disturb_neighbors(WorldState& world, std::uint32_t body)
{
    const auto disturb = [&](std::uint32_t other)
    {
        if (const std::uint32_t island = world.bodies.records[other].island; island != null_index) world.islands[island].is_restless = true;
    };
    for_each_contact(world, body, [&](std::uint32_t contact, std::uint32_t other)
    {
        if (is_push(world, contact)) disturb(other);
    });
    for_each_joined(world, body, disturb);
}

void note_asleep(WorldState& world, std::uint32_t body)
{
    world.events.fell_asleep.push_back({body, world.bodies.slots.generation(body), world.world});
}

/// Kinematic bodies that stand still go at once; the others disturb their neighbours.
void visit_kinematic_bodies(WorldState& world)
{
    for (std::size_t i = world.bodies.motions.size(); i-- > 1;)
    {
        const std::uint32_t body = world.bodies.motions[i].slot;
        if (world.bodies.watches[i].island != null_index || !is_kinematic(world, body)) continue;
        if (is_moving(world.bodies.motions[i]))
        {
            disturb_neighbors(world, body);
            continue;
        }
        deactivate(world, body);
        refresh_joints_of_body(world, body);
        note_asleep(world, body);
    }
}

bool has_n_body_field(const FieldStore& fields)
{
    for (std::uint32_t slot = 0; slot < fields.slots.size(); ++slot)
        if (fields.slots.is_live(slot) && std::holds_alternative<NBodyField>(fields.fields[slot])) return true;
    return false;
}

void note_woken(WorldState& world)
{
    for (std::size_t i = 1; i < world.bodies.motions.size(); ++i)
    {
        BodyWatch& watch = world.bodies.watches[i];
        if (!watch.has_woken) continue;
        watch.has_woken = false;
        const std::uint32_t body = world.bodies.motions[i].slot;
        world.events.woke.push_back({body, world.bodies.slots.generation(body), world.world});
    }
    std::sort(world.events.woke.begin(), world.events.woke.end());
}

/// Contacts that were looked at once after an edit, though none of their bodies is active.
void dismiss_reviewed(WorldState& world)
{
    if (!world.must_review) return;
    world.must_review = false;
    for (std::size_t i = world.contacts.awake.size(); i-- > 0;)
    {
        const std::uint32_t contact = world.contacts.awake[i];
        const Contact& pair = world.contacts.contacts[contact];
        if (!world.bodies.is_active(pair.body_a) && !world.bodies.is_active(pair.body_b)) world.contacts.put_to_sleep(contact);
    }
}

/// The awake island with the body that has been slow for longest, among those that may have come apart; null_index when there is none. Taking one
/// apart a step is enough, and bounds the cost.
std::uint32_t island_to_split(const WorldState& world)
{
    float longest = world.sleep.time;
    std::uint32_t best = null_index;
    for (std::size_t i = 1; i < world.bodies.motions.size(); ++i)
    {
        const BodyWatch& watch = world.bodies.watches[i];
        if (watch.island == null_index || watch.rest_time < longest || !world.islands[watch.island].lost_links) continue;
        if (best != null_index && (watch.rest_time == longest && best <= watch.island)) continue;
        longest = watch.rest_time;
        best = watch.island;
    }
    return best;
}

} // namespace

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

void put_islands_to_sleep(WorldState& world)
{
    note_woken(world);
    dismiss_reviewed(world);
    visit_kinematic_bodies(world);
    if (!world.sleep.is_enabled || has_n_body_field(world.fields)) return;

    if (const std::uint32_t island = island_to_split(world); island != null_index)
        world.islands.split(island, world.bodies, world.contacts, world.joints);
    for (std::size_t i = 1; i < world.bodies.motions.size(); ++i)
    {
        const BodyWatch& watch = world.bodies.watches[i];
        if (watch.island != null_index && watch.rest_time < world.sleep.time) world.islands[watch.island].is_restless = true;
    }
    for (std::size_t i = world.islands.awake().size(); i-- > 0;)
    {
        const std::uint32_t island = world.islands.awake()[i];
        if (world.islands[island].is_restless)
        {
            world.islands[island].is_restless = false;
            continue;
        }
        put_island_to_sleep(world, island);
        for_each_of_island(world, island, [&](std::uint32_t body) { note_asleep(world, body); });
    }
    std::sort(world.events.fell_asleep.begin(), world.events.fell_asleep.end());
}

} // namespace carom::detail
