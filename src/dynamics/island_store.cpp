// Lists of bodies that are merged, cut and taken apart.
#include "dynamics/island_store.hpp"

#include "dynamics/walks.hpp"
#include "memory/make_room.hpp"

#include <utility>

namespace carom::detail
{

namespace
{

void set_island(std::uint32_t body, std::uint32_t island, BodyStore& bodies)
{
    bodies.records[body].island = island;
    if (bodies.is_active(body)) bodies.watches[bodies.motion_index[body]].island = island;
}

} // namespace

void IslandStore::make_room_for(std::size_t bodies)
{
    slots_.make_room(bodies);
    make_room(islands_, bodies);
    make_room(awake_, bodies);
    make_room(stack_, bodies);
}

void IslandStore::shrink(std::size_t bodies)
{
    slots_.drop_tail();
    cut(islands_, slots_.size());
    cut(awake_, awake_.size());
    cut(stack_, 0);
    make_room_for(bodies);
}

std::uint32_t IslandStore::create()
{
    const std::uint32_t island = slots_.acquire();
    if (island == islands_.size()) islands_.emplace_back();
    islands_[island] = {};
    mark_awake(island);
    return island;
}

void IslandStore::destroy(std::uint32_t island)
{
    if (is_awake(island)) mark_asleep(island);
    slots_.release(island);
}

void IslandStore::mark_awake(std::uint32_t island)
{
    islands_[island].place_in_awake = static_cast<std::uint32_t>(awake_.size());
    awake_.push_back(island);
}

void IslandStore::mark_asleep(std::uint32_t island)
{
    const std::uint32_t place = std::exchange(islands_[island].place_in_awake, null_index);
    const std::uint32_t last = awake_.back();
    awake_.pop_back();
    if (last == island) return;
    awake_[place] = last;
    islands_[last].place_in_awake = place;
}

void IslandStore::append(std::uint32_t island, std::uint32_t body, BodyStore& bodies)
{
    Island& list = islands_[island];
    BodyRecord& record = bodies.records[body];
    record.previous_in_island = list.last_body;
    record.next_in_island = null_index;
    (list.last_body == null_index ? list.first_body : bodies.records[list.last_body].next_in_island) = body;
    list.last_body = body;
    ++list.body_count;
    set_island(body, island, bodies);
}

void IslandStore::unchain(std::uint32_t island, std::uint32_t body, BodyStore& bodies)
{
    Island& list = islands_[island];
    BodyRecord& record = bodies.records[body];
    (record.previous_in_island == null_index ? list.first_body : bodies.records[record.previous_in_island].next_in_island) =
        record.next_in_island;
    (record.next_in_island == null_index ? list.last_body : bodies.records[record.next_in_island].previous_in_island) =
        record.previous_in_island;
    record.previous_in_island = record.next_in_island = null_index;
    --list.body_count;
    set_island(body, null_index, bodies);
}

void IslandStore::add(std::uint32_t body, BodyStore& bodies) { append(create(), body, bodies); }

void IslandStore::remove(std::uint32_t body, BodyStore& bodies)
{
    const std::uint32_t island = bodies.records[body].island;
    unchain(island, body, bodies);
    if (islands_[island].body_count == 0)
        destroy(island);
    else
        islands_[island].lost_links = true;
}

/// The smaller one is hung behind the larger one.
void IslandStore::link(std::uint32_t a, std::uint32_t b, BodyStore& bodies)
{
    std::uint32_t large = bodies.records[a].island;
    std::uint32_t small = bodies.records[b].island;
    if (large == small) return;
    if (islands_[large].body_count < islands_[small].body_count) std::swap(large, small);
    for (std::uint32_t body = islands_[small].first_body; body != null_index; body = bodies.records[body].next_in_island)
        set_island(body, large, bodies);

    Island& to = islands_[large];
    const Island& from = islands_[small];
    bodies.records[to.last_body].next_in_island = from.first_body;
    bodies.records[from.first_body].previous_in_island = to.last_body;
    to.last_body = from.last_body;
    to.body_count += from.body_count;
    to.lost_links = to.lost_links || from.lost_links;
    destroy(small);
}

void IslandStore::unlink(std::uint32_t a, std::uint32_t b, const BodyStore& bodies)
{
    for (const std::uint32_t body : {a, b})
        if (const std::uint32_t island = bodies.records[body].island; island != null_index) islands_[island].lost_links = true;
}

void IslandStore::split(std::uint32_t island, BodyStore& bodies, const ContactStore& contacts, const JointStore& joints)
{
    islands_[island].lost_links = false;
    // Everything that the first body reaches moves to a new island, until no body is left.
    while (islands_[island].body_count > 0)
    {
        const auto reach = [&](std::uint32_t body, std::uint32_t to)
        {
            unchain(island, body, bodies);
            append(to, body, bodies);
            stack_.push_back(body);
        };
        const std::uint32_t to = create();
        reach(islands_[island].first_body, to);
        while (!stack_.empty())
        {
            const std::uint32_t body = stack_.back();
            stack_.pop_back();
            for (const Tie contact : contacts_of(bodies, contacts, body))
                if (contacts.contacts[contact.slot].color != no_color && bodies.records[contact.other].island == island)
                    reach(contact.other, to);
            for (const Tie joint : joints_of(bodies, joints, body))
                if (joint.other != null_index && joints.joints[joint.slot].is_active() && bodies.records[joint.other].island == island)
                    reach(joint.other, to);
        }
    }
    destroy(island);
}

} // namespace carom::detail
