// Which islands have come to rest.
#include "step/sleep.hpp"

#include "edit/wake.hpp"
#include "state/walks.hpp"

#include <algorithm>

namespace carom::detail
{

namespace
{

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
        put_body_to_sleep(world, body);
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

bool lets_sleep(const WorldState& world) { return world.sleep.is_enabled && !has_n_body_field(world.fields); }

void put_islands_to_sleep(WorldState& world)
{
    note_woken(world);
    dismiss_reviewed(world);
    visit_kinematic_bodies(world);
    if (!lets_sleep(world)) return;

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
