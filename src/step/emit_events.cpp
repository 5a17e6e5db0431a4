// Tells which contacts and overlaps began, went on and ended.
#include "state/event_buffers.hpp"

#include "dynamics/ids.hpp"
#include "geometry/manifold.hpp"
#include "memory/fetch_lines.hpp"

#include <algorithm>
#include <cmath>

namespace carom::detail
{

namespace
{

/// Speculative points alone are no touch: the surfaces must have met, or the solver must have pushed. What touches goes on touching
/// until the surfaces are clearly apart, so that a body at rest does not flicker.
/// @param slop Tolerances::linear_slop [m]
bool touches(const Contact& contact, const ContactManifold& manifold, const ContactResult& result, float slop)
{
    if (contact.is_sensor) return manifold.count > 0;
    const float apart = contact.is_touching ? slop : 0.0f;
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
        if (result.totals[i].normal > 0 || manifold.separation[i] <= apart) return true;
    return false;
}

/// A sensor contact is one event for each of its two shapes that is a sensor.
void add_sensor_events(const Contact& contact, const ShapeStore& shapes, std::uint32_t world, std::pmr::vector<SensorEvent>& list)
{
    const ShapeId a = shape_id(shapes, contact.shape_a, world);
    const ShapeId b = shape_id(shapes, contact.shape_b, world);
    if (shapes.records[contact.shape_a].is_sensor) list.push_back({.sensor = a, .visitor = b});
    if (shapes.records[contact.shape_b].is_sensor) list.push_back({.sensor = b, .visitor = a});
}

void emit_sensor(Contact& contact, bool touches_now, const ShapeStore& shapes, std::uint32_t world, EventBuffers& events)
{
    if (touches_now && !contact.is_touching)
        add_sensor_events(contact, shapes, world, events.sensor_begin);
    else if (touches_now && contact.wants_persist)
        add_sensor_events(contact, shapes, world, events.sensor_persist);
    else if (!touches_now && contact.is_touching)
        add_sensor_events(contact, shapes, world, events.sensor_end);
    contact.is_touching = touches_now;
}

/// Whether one of its shapes asks for the contact's begin and end.
bool wants_ends(const Contact& contact, const ShapeStore& shapes)
{
    return shapes.records[contact.shape_a].contact_events || shapes.records[contact.shape_b].contact_events;
}

void emit_contact(Contact& contact, const ContactManifold& manifold, const ContactResult& result, bool touches_now,
                  const ShapeStore& shapes, std::uint32_t world, EventBuffers& events)
{
    const auto id_of = [&](std::uint32_t shape) { return shape_id(shapes, shape, world); };
    if (touches_now && !contact.is_touching && wants_ends(contact, shapes))
        events.contact_begin.push_back({id_of(contact.shape_a), id_of(contact.shape_b), public_manifold(manifold, result)});
    else if (touches_now && contact.is_touching && contact.wants_persist)
        events.contact_persist.push_back({id_of(contact.shape_a), id_of(contact.shape_b), public_manifold(manifold, result)});
    else if (!touches_now && contact.is_touching && wants_ends(contact, shapes))
        events.contact_end.push_back({id_of(contact.shape_a), id_of(contact.shape_b), manifold.last.normal, manifold.last.tangent});
    contact.is_touching = touches_now;
}

/// How fast the points met that the solver had to push, and where it was fastest.
struct Impact
{
    float speed = 0;
    std::size_t point = 0;
};

Impact impact_of(int count, const ContactResult& result)
{
    Impact impact;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    {
        const float speed = -result.normal_velocity[i];
        if (result.totals[i].normal > 0 && speed > impact.speed) impact = {speed, i};
    }
    return impact;
}

/// A collision that takes several steps counts once: a contact that was hitting in the step before goes on doing so.
void emit_hit(Contact& contact, const ContactManifold& manifold, const ContactResult& result, const ShapeStore& shapes,
              const ContactRules& rules, EventBuffers& events)
{
    if (!contact.wants_hits) return;
    const Impact impact = impact_of(manifold.count, result);
    const bool is_hitting = impact.speed > rules.hit_speed * shapes.tolerances.length_unit;
    if (is_hitting && !contact.is_hitting)
        events.contact_hit.push_back({shape_id(shapes, contact.shape_a, rules.world), shape_id(shapes, contact.shape_b, rules.world),
                                      position_of(manifold, impact.point), manifold.normal, impact.speed});
    contact.is_hitting = is_hitting;
}

constexpr std::size_t fetched_ahead = 8;

void fetch_ahead(const ContactStore& contacts, std::size_t place)
{
    if (place >= contacts.awake.size() || contacts.awake_states[place].is_quiet) return;
    fetch_lines(contacts.contacts[contacts.awake[place]]);
    fetch_lines(contacts.manifolds[contacts.awake[place]]);
    fetch_lines(contacts.results[contacts.awake[place]]);
}

template <class List>
void sort_contacts(List& list)
{
    std::sort(list.begin(), list.end(),
              [](const auto& l, const auto& r) { return std::pair(l.shape_a, l.shape_b) < std::pair(r.shape_a, r.shape_b); });
}

void sort_sensors(std::pmr::vector<SensorEvent>& list)
{
    std::sort(list.begin(), list.end(),
              [](const SensorEvent& l, const SensorEvent& r) { return std::pair(l.sensor, l.visitor) < std::pair(r.sensor, r.visitor); });
}

} // namespace

ShapeId shape_id(const ShapeStore& shapes, std::uint32_t slot, std::uint32_t world) { return id_of<ShapeId>(shapes, slot, world); }

Manifold public_manifold(const ContactManifold& manifold, const ContactResult& stored)
{
    const ContactResult result = result_of(manifold, stored);
    Manifold shown = {.normal = manifold.normal, .points = {}, .point_count = manifold.count, .rolling_impulse = result.total_rolling};
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
        shown.points[i] = {.position = position_of(manifold, i),
                           .separation = manifold.separation[i],
                           .normal_impulse = result.totals[i].normal,
                           .tangent_impulse = result.totals[i].tangent,
                           .approach_speed = -result.normal_velocity[i],
                           .feature = manifold.features[i]};
    return shown;
}

void note_end(const Contact& contact, const ContactResult& result, const ShapeStore& shapes, std::uint32_t world, EventBuffers& events)
{
    if (!contact.is_touching) return;
    --events.touching;
    if (contact.is_sensor)
    {
        add_sensor_events(contact, shapes, world, events.pending_sensor_end);
        return;
    }
    if (!wants_ends(contact, shapes)) return;
    const ContactImpulse sum = sum_of(result);
    const bool is_finite = std::isfinite(sum.normal) && std::isfinite(sum.tangent); // not what took a body to infinity
    events.pending_contact_end.push_back({shape_id(shapes, contact.shape_a, world), shape_id(shapes, contact.shape_b, world),
                                          is_finite ? sum.normal : 0, is_finite ? sum.tangent : 0});
}

int emit_events(ContactStore& contacts, std::span<const Crossing> crossings, const ShapeStore& shapes, const ContactRules& rules,
                EventBuffers& events)
{
    const std::uint32_t world = rules.world;
    events.contact_end.assign(events.pending_contact_end.begin(), events.pending_contact_end.end());
    events.sensor_end.assign(events.pending_sensor_end.begin(), events.pending_sensor_end.end());
    events.pending_contact_end.clear();
    events.pending_sensor_end.clear();

    for (std::size_t place = 0; place < contacts.awake.size(); ++place)
    {
        fetch_ahead(contacts, place + fetched_ahead);
        if (contacts.awake_states[place].is_quiet) continue;
        const std::uint32_t slot = contacts.awake[place];
        Contact& contact = contacts.contacts[slot];
        const ContactManifold& manifold = contacts.manifolds[slot];
        const ContactResult result = result_of(manifold, contacts.results[slot]);
        const bool touches_now = touches(contact, manifold, result, shapes.tolerances.linear_slop);
        events.touching += (touches_now ? 1 : 0) - (contact.is_touching ? 1 : 0);
        if (contact.is_sensor)
            emit_sensor(contact, touches_now, shapes, world, events);
        else
        {
            emit_contact(contact, manifold, result, touches_now, shapes, world, events);
            emit_hit(contact, manifold, result, shapes, rules, events);
        }
    }

    for (const Crossing& crossing : crossings)
    {
        Contact passing;
        passing.shape_a = crossing.shape_a;
        passing.shape_b = crossing.shape_b;
        add_sensor_events(passing, shapes, world, events.sensor_begin);
        add_sensor_events(passing, shapes, world, events.pending_sensor_end);
    }
    sort_contacts(events.contact_begin);
    sort_contacts(events.contact_persist);
    sort_contacts(events.contact_end);
    sort_contacts(events.contact_hit);
    sort_sensors(events.sensor_begin);
    sort_sensors(events.sensor_persist);
    sort_sensors(events.sensor_end);
    return events.touching;
}

} // namespace carom::detail
