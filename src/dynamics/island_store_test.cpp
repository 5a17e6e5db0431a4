// Islands against a plain union of what the links connect.
#include "dynamics/island_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace carom::detail
{

namespace
{

/// Bodies linked by joints, which need no shapes.
struct Linked
{
    explicit Linked(std::size_t count)
    {
        islands.make_room_for(count);
        for (std::size_t i = 0; i < count; ++i) islands.add(bodies.create({}), bodies);
    }

    void link(std::uint32_t a, std::uint32_t b)
    {
        Joint joint;
        joint.body_a = a;
        joint.body_b = b;
        links[{a, b}] = joints.create(joint, bodies);
        joints.activate(links[{a, b}]);
        islands.link(a, b, bodies);
    }

    void unlink(std::uint32_t a, std::uint32_t b)
    {
        joints.deactivate(links[{a, b}]);
        joints.destroy(links[{a, b}], bodies);
        links.erase({a, b});
        islands.unlink(a, b, bodies);
    }

    void split_all()
    {
        const std::vector<std::uint32_t> awake(islands.awake().begin(), islands.awake().end());
        for (const std::uint32_t island : awake)
            if (islands[island].lost_links) islands.split(island, bodies, contacts, joints);
    }

    /// Every list is whole, and two bodies are in one island where the links say so.
    void expect_valid(bool is_exact)
    {
        std::vector<std::uint32_t> group(bodies.records.size());
        for (std::uint32_t i = 0; i < group.size(); ++i) group[i] = i;
        for (std::size_t round = 0; round < group.size(); ++round)
            for (const auto& [pair, joint] : links)
                group[pair.first] = group[pair.second] = std::min(group[pair.first], group[pair.second]);
        std::map<std::uint32_t, std::set<std::uint32_t>> islands_of_group;
        std::map<std::uint32_t, std::set<std::uint32_t>> groups_of_island;
        for (std::uint32_t i = 0; i < group.size(); ++i)
        {
            islands_of_group[group[i]].insert(bodies.records[i].island);
            groups_of_island[bodies.records[i].island].insert(group[i]);
            ASSERT_EQ(bodies.watches[bodies.motion_index[i]].island, bodies.records[i].island);
        }
        for (const auto& [g, set] : islands_of_group)
        {
            ASSERT_EQ(set.size(), 1u) << "linked bodies are in one island";
        }
        for (const auto& [island, set] : groups_of_island)
        {
            ASSERT_TRUE(set.size() == 1 || !is_exact) << "and others in another";
        }

        std::size_t seen = 0;
        for (const std::uint32_t island : islands.awake())
        {
            std::uint32_t count = 0;
            std::uint32_t last = null_index;
            for (std::uint32_t b = islands[island].first_body; b != null_index; b = bodies.records[b].next_in_island)
            {
                ASSERT_EQ(bodies.records[b].island, island);
                ASSERT_EQ(bodies.records[b].previous_in_island, last);
                last = b;
                ++count;
            }
            ASSERT_EQ(islands[island].last_body, last);
            ASSERT_EQ(islands[island].body_count, count);
            seen += count;
        }
        ASSERT_EQ(seen, bodies.records.size());
        ASSERT_EQ(static_cast<std::size_t>(islands.count()), islands.awake().size());
    }

    /// For each body the lowest one in its island.
    std::vector<std::uint32_t> groups() const
    {
        std::vector<std::uint32_t> lowest(bodies.records.size());
        for (std::uint32_t body = 0; body < lowest.size(); ++body)
        {
            lowest[body] = 0;
            while (bodies.records[lowest[body]].island != bodies.records[body].island) ++lowest[body];
        }
        return lowest;
    }

    BodyStore bodies{*std::pmr::new_delete_resource()};
    ContactStore contacts{*std::pmr::new_delete_resource()};
    JointStore joints{*std::pmr::new_delete_resource()};
    IslandStore islands{*std::pmr::new_delete_resource()};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> links;
};

} // namespace

TEST(IslandStore, MergesAtOnceAndComesApartWhenAsked)
{
    Linked world(4);
    EXPECT_EQ(world.islands.count(), 4);
    world.link(0, 1);
    world.link(2, 3);
    world.link(1, 2);
    EXPECT_EQ(world.islands.count(), 1);
    world.unlink(1, 2);
    EXPECT_EQ(world.islands.count(), 1);
    world.split_all();
    EXPECT_EQ(world.islands.count(), 2);
    world.expect_valid(true);
}

TEST(IslandStore, FollowsRandomHistories)
{
    std::mt19937 engine(5);
    Linked world(60);
    for (int round = 0; round < 400; ++round)
    {
        const auto a = static_cast<std::uint32_t>(engine() % 60);
        const auto b = static_cast<std::uint32_t>(engine() % 60);
        if (a < b && !world.links.contains({a, b}) && engine() % 2 == 0) world.link(a, b);
        if (!world.links.empty() && engine() % 2 == 0)
        {
            const auto victim = std::next(world.links.begin(), static_cast<std::ptrdiff_t>(engine() % world.links.size()))->first;
            world.unlink(victim.first, victim.second);
        }
        if (round % 7 == 0) world.split_all();
        world.expect_valid(round % 7 == 0);
        if (testing::Test::HasFatalFailure()) return;
    }
}

/// Every order of six links, one of which closes a ring, and both orders of the bodies in each.
TEST(IslandStore, the_order_of_links_does_not_show_in_the_islands)
{
    using Link = std::pair<std::uint32_t, std::uint32_t>;
    std::vector<Link> links = {{0, 1}, {0, 2}, {1, 2}, {2, 6}, {3, 5}, {4, 5}};
    const std::vector<std::uint32_t> linked = {0, 0, 0, 3, 3, 3, 0, 7};
    const std::vector<std::uint32_t> cut = {0, 0, 0, 3, 3, 3, 6, 7}; // without 2-6; the ring holds without 0-1
    for (const bool is_swapped : {false, true})
    {
        do
        {
            Linked world(8);
            for (const auto& [a, b] : links) is_swapped ? world.link(b, a) : world.link(a, b);
            ASSERT_EQ(world.groups(), linked);
            ASSERT_EQ(world.islands.count(), 3);
            for (const auto& [a, b] : {Link{2, 6}, Link{0, 1}}) is_swapped ? world.unlink(b, a) : world.unlink(a, b);
            world.split_all();
            ASSERT_EQ(world.groups(), cut);
            ASSERT_EQ(world.islands.count(), 4);
        } while (std::next_permutation(links.begin(), links.end()));
    }
}

TEST(IslandStore, an_island_sleeps_and_wakes_as_a_whole)
{
    Linked world(3);
    world.link(0, 1);
    world.islands.remove(2, world.bodies);
    EXPECT_EQ(world.islands.count(), 1);
    world.islands.mark_asleep(world.bodies.records[0].island);
    EXPECT_TRUE(world.islands.awake().empty());
    EXPECT_FALSE(world.islands.is_awake(world.bodies.records[1].island));
    world.islands.mark_awake(world.bodies.records[0].island);
    EXPECT_EQ(world.islands.awake().size(), 1u);
    EXPECT_TRUE(world.islands.is_awake(world.bodies.records[1].island));
}

} // namespace carom::detail
