// Adds and removes contacts and keeps the lists of each body's contacts.
#include "dynamics/contact_store.hpp"

#include "dynamics/body_store.hpp"
#include "memory/make_room.hpp"

namespace carom::detail
{

std::uint32_t ContactStore::create(const Contact& pair, BodyStore& bodies)
{
    make_room(contacts, contacts.size() + 1);
    make_room(manifolds, contacts.size() + 1);
    make_room(awake, contacts.size() + 1);
    const std::uint32_t slot = slots.acquire();
    if (slot == contacts.size())
    {
        contacts.emplace_back();
        manifolds.emplace_back();
    }
    contacts[slot] = pair;
    contacts[slot].is_live = true;
    contacts[slot].place_in_awake = null_index;
    wake(slot);
    manifolds[slot] = {};
    link(2 * slot, pair.body_a, bodies);
    link(2 * slot + 1, pair.body_b, bodies);
    return slot;
}

void ContactStore::destroy(std::uint32_t slot, BodyStore& bodies)
{
    unlink(2 * slot, contacts[slot].body_a, bodies);
    unlink(2 * slot + 1, contacts[slot].body_b, bodies);
    put_to_sleep(slot);
    contacts[slot].is_live = false;
    slots.release(slot);
}

void ContactStore::wake(std::uint32_t slot)
{
    if (contacts[slot].place_in_awake != null_index) return;
    contacts[slot].place_in_awake = static_cast<std::uint32_t>(awake.size());
    awake.push_back(slot);
}

void ContactStore::put_to_sleep(std::uint32_t slot)
{
    const std::uint32_t place = contacts[slot].place_in_awake;
    if (place == null_index) return;
    const std::uint32_t last = awake.back();
    awake[place] = last;
    contacts[last].place_in_awake = place;
    awake.pop_back();
    contacts[slot].place_in_awake = null_index;
}

void ContactStore::reserve(std::size_t count)
{
    slots.reserve(count);
    contacts.reserve(count);
    manifolds.reserve(count);
    awake.reserve(count);
}

void ContactStore::link(std::uint32_t edge, std::uint32_t body, BodyStore& bodies)
{
    std::uint32_t& first = bodies.records[body].first_contact;
    contacts[edge / 2].previous[edge % 2] = null_index;
    contacts[edge / 2].next[edge % 2] = first;
    if (first != null_index) contacts[first / 2].previous[first % 2] = edge;
    first = edge;
}

void ContactStore::unlink(std::uint32_t edge, std::uint32_t body, BodyStore& bodies)
{
    const std::uint32_t previous = contacts[edge / 2].previous[edge % 2];
    const std::uint32_t next = contacts[edge / 2].next[edge % 2];
    if (previous != null_index)
        contacts[previous / 2].next[previous % 2] = next;
    else
        bodies.records[body].first_contact = next;
    if (next != null_index) contacts[next / 2].previous[next % 2] = previous;
}

} // namespace carom::detail
