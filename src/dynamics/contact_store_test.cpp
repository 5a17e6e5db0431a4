#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"

#include <gtest/gtest.h>

#include <map>
#include <memory_resource>
#include <random>
#include <set>

namespace carom::detail
{
namespace
{

/// Walks the list of a body both ways.
std::set<std::uint32_t> contacts_of(const ContactStore& contacts, const BodyStore& bodies, std::uint32_t body)
{
    std::set<std::uint32_t> found;
    std::uint32_t before = null_index;
    for (std::uint32_t edge = bodies.records[body].first_contact; edge != null_index;)
    {
        const Contact& contact = contacts.contacts[edge / 2];
        EXPECT_TRUE(contact.is_live);
        EXPECT_EQ(edge % 2 == 0 ? contact.body_a : contact.body_b, body);
        EXPECT_EQ(contact.previous[edge % 2], before);
        EXPECT_TRUE(found.insert(edge / 2).second) << "twice in one list";
        before = edge;
        edge = contact.next[edge % 2];
    }
    return found;
}

TEST(ContactStore, ListsOfBodiesAgreeWithAMapWhateverComesAndGoes)
{
    std::pmr::memory_resource& memory = *std::pmr::new_delete_resource();
    BodyStore bodies(memory);
    ContactStore contacts(memory);
    for (int i = 0; i < 6; ++i) bodies.create({});

    std::mt19937 engine(5);
    std::map<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>> live;
    for (int i = 0; i < 3000; ++i)
    {
        if (live.size() < 4 || (live.size() < 30 && engine() % 2 == 0))
        {
            const std::uint32_t a = static_cast<std::uint32_t>(engine() % 6);
            const std::uint32_t b = (a + 1 + static_cast<std::uint32_t>(engine() % 5)) % 6;
            const std::uint32_t slot = contacts.create({.shape_a = a, .shape_b = b, .body_a = a, .body_b = b}, bodies);
            ASSERT_TRUE(live.emplace(slot, std::pair(a, b)).second);
        }
        else
        {
            const auto victim = std::next(live.begin(), static_cast<std::ptrdiff_t>(engine() % live.size()));
            contacts.destroy(victim->first, bodies);
            EXPECT_FALSE(contacts.contacts[victim->first].is_live);
            live.erase(victim);
        }
        ASSERT_EQ(contacts.awake_pairs.size(), contacts.awake.size());
        for (std::size_t place = 0; place < contacts.awake.size(); ++place)
        {
            ASSERT_EQ(contacts.awake_pairs[place].shape_a, live.at(contacts.awake[place]).first);
            ASSERT_EQ(contacts.awake_pairs[place].shape_b, live.at(contacts.awake[place]).second);
        }
        for (std::uint32_t body = 0; body < 6; ++body)
        {
            std::set<std::uint32_t> expected;
            for (const auto& [slot, pair] : live)
                if (pair.first == body || pair.second == body) expected.insert(slot);
            ASSERT_EQ(contacts_of(contacts, bodies, body), expected);
        }
    }
}

TEST(ContactStore, TheStateOfAnAwakeContactMovesWithIt)
{
    std::pmr::memory_resource& memory = *std::pmr::new_delete_resource();
    BodyStore bodies(memory);
    ContactStore contacts(memory);
    for (int i = 0; i < 4; ++i) bodies.create({});
    for (std::uint32_t i = 0; i < 3; ++i) contacts.create({.shape_a = i, .shape_b = i + 1, .body_a = i, .body_b = i + 1}, bodies);
    for (std::uint32_t slot = 0; slot < 3; ++slot)
    {
        contacts.contacts[slot].color = static_cast<std::uint8_t>(10 + slot);
        contacts.manifolds[slot].count = slot == 1 ? 1 : 2;
        contacts.refresh_bucket(slot);
    }
    const auto bucket = [&](std::uint32_t slot) { return int{contacts.awake_states[contacts.contacts[slot].place_in_awake].bucket}; };
    EXPECT_EQ(bucket(0), 21);
    EXPECT_EQ(bucket(1), 22);
    EXPECT_EQ(bucket(2), 23 + 2);
    contacts.put_to_sleep(0);
    EXPECT_EQ(contacts.awake_states.size(), 2u);
    EXPECT_EQ(bucket(1), 22);
    EXPECT_EQ(bucket(2), 25) << "it has taken the place";
    contacts.contacts[0].color = no_color;
    contacts.refresh_bucket(0); // asleep: nothing to do
    contacts.wake(0);
    EXPECT_EQ(bucket(0), no_bucket);
    contacts.manifolds[1].count = 0;
    contacts.refresh_bucket(1);
    EXPECT_EQ(bucket(1), no_bucket);
}

TEST(ContactStore, AUsedPlaceStartsCold)
{
    std::pmr::memory_resource& memory = *std::pmr::new_delete_resource();
    BodyStore bodies(memory);
    ContactStore contacts(memory);
    for (int i = 0; i < 2; ++i) bodies.create({});
    const Contact pair = {.shape_a = 0, .shape_b = 1, .body_a = 0, .body_b = 1};
    const std::uint32_t slot = contacts.create(pair, bodies);
    contacts.contacts[slot].color = 3;
    contacts.contacts[slot].is_touching = true;
    contacts.manifolds[slot].count = 2;
    contacts.manifolds[slot].carried_impulse = 7;
    contacts.manifolds[slot].has_result = true;
    contacts.memories[slot].result = CollisionMemory::Result::Gap;
    contacts.destroy(slot, bodies);
    ASSERT_EQ(contacts.create(pair, bodies), slot);
    EXPECT_EQ(contacts.contacts[slot].color, no_color);
    EXPECT_FALSE(contacts.contacts[slot].is_touching);
    EXPECT_EQ(contacts.manifolds[slot].count, 0);
    EXPECT_EQ(contacts.manifolds[slot].carried_impulse, 0);
    EXPECT_FALSE(contacts.manifolds[slot].has_result);
    EXPECT_EQ(contacts.memories[slot].result, CollisionMemory::Result::Nothing);
}

} // namespace
} // namespace carom::detail
