// Which islands have come to rest.
#include "step/sleep.hpp"

#include "dynamics/ids.hpp"
#include "dynamics/walks.hpp"
#include "edit/wake.hpp"

#include <algorithm>

namespace carom::detail
{

namespace
{

/// Keeps awake what a moving kinematic body touches or is joined to.
void disturb_neighbors(const WakeGraph& graph, std::uint32_t body)
{
    const auto disturb = [&](std::uint32_t other)
    {
        if (const std::uint32_t island = graph.bodies.records[other].island; island != null_index) graph.islands[island].is_restless = true;
    };
    for (const Tie contact : contacts_of(graph.bodies, graph.contacts, body))
        if (is_push(graph.contacts, contact.slot)) disturb(contact.other);
    for (const Tie joint : joints_of(graph.bodies, graph.joints, body))
        if (joint.other != null_index) disturb(joint.other);
}

/// Kinematic bodies that stand still go at once; the others disturb their neighbours.
void visit_kinematic_bodies(const WakeGraph& graph, EventBuffers& events, const SleepMoment& now)
{
    for (std::size_t i = graph.bodies.motions.size(); i-- > 1;)
    {
        const std::uint32_t body = graph.bodies.motions[i].slot;
        if (graph.bodies.watches[i].island != null_index || !is_kinematic(graph.bodies, body)) continue;
        if (is_moving(graph.bodies.motions[i]))
        {
            disturb_neighbors(graph, body);
            continue;
        }
        put_body_to_sleep(graph, body, now.step_count);
        events.fell_asleep.push_back(id_of<BodyId>(graph.bodies, body, now.world));
    }
}

bool has_n_body_field(const FieldStore& fields)
{
    for (std::uint32_t slot = 0; slot < fields.slots.size(); ++slot)
        if (fields.slots.is_live(slot) && std::holds_alternative<NBodyField>(fields.fields[slot])) return true;
    return false;
}

void note_woken(BodyStore& bodies, EventBuffers& events, std::uint32_t world)
{
    for (std::size_t i = 1; i < bodies.motions.size(); ++i)
    {
        BodyWatch& watch = bodies.watches[i];
        if (!watch.has_woken) continue;
        watch.has_woken = false;
        events.woke.push_back(id_of<BodyId>(bodies, bodies.motions[i].slot, world));
    }
    std::sort(events.woke.begin(), events.woke.end());
}

/// Contacts that were looked at once after an edit, though none of their bodies is active.
void dismiss_reviewed(ContactStore& contacts, const BodyStore& bodies)
{
    for (std::size_t i = contacts.awake.size(); i-- > 0;)
    {
        const std::uint32_t contact = contacts.awake[i];
        const Contact& pair = contacts.contacts[contact];
        if (!bodies.is_active(pair.body_a) && !bodies.is_active(pair.body_b)) contacts.put_to_sleep(contact);
    }
}

/// The awake island with the body that has been slow for longest, among those that may have come apart; null_index when there is none. Taking one
/// apart a step is enough, and bounds the cost.
std::uint32_t island_to_split(const BodyStore& bodies, const IslandStore& islands, float sleep_time)
{
    float longest = sleep_time;
    std::uint32_t best = null_index;
    for (std::size_t i = 1; i < bodies.motions.size(); ++i)
    {
        const BodyWatch& watch = bodies.watches[i];
        if (watch.island == null_index || watch.rest_time < longest || !islands[watch.island].lost_links) continue;
        if (best != null_index && (watch.rest_time == longest && best <= watch.island)) continue;
        longest = watch.rest_time;
        best = watch.island;
    }
    return best;
}

} // namespace

bool lets_sleep(const SleepTuning& tuning, const FieldStore& fields) { return tuning.is_enabled && !has_n_body_field(fields); }

void put_islands_to_sleep(const WakeGraph& graph, EventBuffers& events, const SleepMoment& now)
{
    auto& [bodies, contacts, joints, islands] = graph;
    note_woken(bodies, events, now.world);
    if (now.must_review) dismiss_reviewed(contacts, bodies);
    visit_kinematic_bodies(graph, events, now);
    if (!now.is_allowed) return;

    if (const std::uint32_t island = island_to_split(bodies, islands, now.rest_time); island != null_index)
        islands.split(island, bodies, contacts, joints);
    for (std::size_t i = 1; i < bodies.motions.size(); ++i)
    {
        const BodyWatch& watch = bodies.watches[i];
        if (watch.island != null_index && watch.rest_time < now.rest_time) islands[watch.island].is_restless = true;
    }
    for (std::size_t i = islands.awake().size(); i-- > 0;)
    {
        const std::uint32_t island = islands.awake()[i];
        if (islands[island].is_restless)
        {
            islands[island].is_restless = false;
            continue;
        }
        put_island_to_sleep(graph, island);
        for (const std::uint32_t body : bodies_of(bodies, islands, island))
            events.fell_asleep.push_back(id_of<BodyId>(bodies, body, now.world));
    }
    std::sort(events.fell_asleep.begin(), events.fell_asleep.end());
}

} // namespace carom::detail
