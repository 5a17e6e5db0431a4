// Adds and removes contacts and keeps the lists of each body's contacts.
#include "dynamics/contact_store.hpp"

#include "dynamics/body_store.hpp"
#include "dynamics/edge_list.hpp"
#include "memory/make_room.hpp"

namespace carom::detail
{

namespace
{

/// The bodies' counts of what they lie on, with a contact more, or less.
void count_ground(const Contact& pair, BodyStore& bodies, std::uint32_t change)
{
    const bool is_dynamic_a = bodies.is_dynamic(pair.body_a);
    if (pair.is_sensor || is_dynamic_a == bodies.is_dynamic(pair.body_b)) return;
    bodies.records[is_dynamic_a ? pair.body_a : pair.body_b].ground_contacts += change;
}

} // namespace

std::uint32_t ContactStore::create(const Contact& pair, BodyStore& bodies)
{
    make_room(contacts, contacts.size() + 1);
    make_room(manifolds, contacts.size() + 1);
    make_room(results, contacts.size() + 1);
    make_room(memories, contacts.size() + 1);
    make_room(face_pairs, contacts.size() + 1);
    make_room(awake, contacts.size() + 1);
    make_room(awake_pairs, contacts.size() + 1);
    make_room(awake_states, contacts.size() + 1);
    const std::uint32_t slot = slots.acquire();
    if (slot == contacts.size())
    {
        contacts.emplace_back();
        manifolds.emplace_back();
        results.emplace_back();
        memories.emplace_back();
        face_pairs.emplace_back();
    }
    contacts[slot] = pair;
    contacts[slot].is_live = true;
    contacts[slot].search = search_;
    contacts[slot].place_in_awake = null_index;
    manifolds[slot] = {};
    wake(slot);
    memories[slot] = {};
    count_ground(pair, bodies, 1);
    link_edge(contacts, 2 * slot, bodies.records[pair.body_a].first_contact);
    link_edge(contacts, 2 * slot + 1, bodies.records[pair.body_b].first_contact);
    return slot;
}

void ContactStore::destroy(std::uint32_t slot, BodyStore& bodies)
{
    count_ground(contacts[slot], bodies, ~std::uint32_t{0}); // one less
    unlink_edge(contacts, 2 * slot, bodies.records[contacts[slot].body_a].first_contact);
    unlink_edge(contacts, 2 * slot + 1, bodies.records[contacts[slot].body_b].first_contact);
    put_to_sleep(slot);
    contacts[slot].is_live = false;
    slots.release(slot);
}

void ContactStore::wake(std::uint32_t slot)
{
    if (contacts[slot].place_in_awake != null_index) return;
    contacts[slot].place_in_awake = static_cast<std::uint32_t>(awake.size());
    awake.push_back(slot);
    awake_pairs.push_back({contacts[slot].shape_a, contacts[slot].shape_b & 0x7fffffffu, 0});
    awake_states.push_back({.bucket = bucket_of(contacts[slot].color, manifolds[slot].count)});
}

void ContactStore::put_to_sleep(std::uint32_t slot)
{
    const std::uint32_t place = contacts[slot].place_in_awake;
    if (place == null_index) return;
    const std::uint32_t last = awake.back();
    awake[place] = last;
    contacts[last].place_in_awake = place;
    awake.pop_back();
    awake_pairs[place] = awake_pairs.back();
    awake_pairs.pop_back();
    awake_states[place] = awake_states.back();
    awake_states.pop_back();
    contacts[slot].place_in_awake = null_index;
}

void ContactStore::refresh_bucket(std::uint32_t slot)
{
    const Contact& contact = contacts[slot];
    if (contact.place_in_awake != null_index) awake_states[contact.place_in_awake].bucket = bucket_of(contact.color, manifolds[slot].count);
}

void ContactStore::shrink()
{
    slots.drop_tail();
    cut(contacts, slots.size());
    cut(manifolds, slots.size());
    cut(results, slots.size());
    cut(memories, slots.size());
    cut(face_pairs, slots.size());
    cut(awake, awake.size());
    cut(awake_pairs, awake_pairs.size());
    cut(awake_states, awake_states.size());
    make_room_to_wake();
}

void ContactStore::make_room_to_wake()
{
    make_room(awake, contacts.size());
    make_room(awake_pairs, contacts.size());
    make_room(awake_states, contacts.size());
}

void ContactStore::reserve(std::size_t count)
{
    slots.reserve(count);
    contacts.reserve(count);
    manifolds.reserve(count);
    results.reserve(count);
    memories.reserve(count);
    face_pairs.reserve(count);
    awake.reserve(count);
    awake_pairs.reserve(count);
    awake_states.reserve(count);
}

} // namespace carom::detail
