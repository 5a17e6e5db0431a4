// The table of blocks against an ordered map.
#include "profile/block_table.hpp"
#include "profile/pool_totals.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace carom::profile
{

namespace
{

const void* address(std::uintptr_t n) { return reinterpret_cast<const void*>(n); }

struct Look
{
    std::string pool;
    std::size_t bytes;
    std::size_t peak_bytes;
    friend bool operator==(const Look&, const Look&) = default;
};

std::vector<Look> look(PoolTotals& pools)
{
    std::vector<Look> changes;
    pools.look([&](const PoolTotals::Change& change) { changes.push_back({change.pool, change.bytes, change.peak_bytes}); });
    return changes;
}

} // namespace

TEST(BlockTable, an_empty_one_holds_nothing)
{
    BlockTable table;
    EXPECT_FALSE(table.remove(address(16)));
    EXPECT_FALSE(table.remove(nullptr));
}

TEST(BlockTable, gives_back_what_was_put_in_whatever_the_order)
{
    std::mt19937 random(7);
    BlockTable table;
    std::map<const void*, std::size_t> expected;
    for (int i = 0; i < 200000; ++i)
    {
        // Few addresses, so that they come and go often and crowd each other.
        const void* const pointer = address(16 * (1 + random() % 3000));
        const auto known = expected.find(pointer);
        const auto removed = table.remove(pointer);
        ASSERT_EQ(removed.has_value(), known != expected.end());
        if (removed)
        {
            ASSERT_EQ(removed->bytes, known->second);
            expected.erase(known);
        }
        else
        {
            const std::size_t bytes = random() % 1000;
            ASSERT_TRUE(table.insert({pointer, bytes, 3}));
            expected[pointer] = bytes;
        }
        ASSERT_EQ(table.size(), expected.size());
    }
    for (const auto& [pointer, bytes] : expected) ASSERT_EQ(table.remove(pointer)->bytes, bytes);
    EXPECT_EQ(table.size(), 0u);
}

TEST(PoolTotals, tells_what_is_in_use_and_what_was_at_most)
{
    PoolTotals pools;
    pools.add(address(16), 100, "a");
    pools.add(address(32), 50, "b");
    pools.add(address(48), 30, std::string("a").c_str()); // another text of the same name
    pools.remove(address(16));
    EXPECT_EQ(look(pools), (std::vector<Look>{{"a", 30, 130}, {"b", 50, 50}}));
    EXPECT_TRUE(look(pools).empty()); // nothing has changed since
    pools.remove(address(32));
    EXPECT_EQ(look(pools), (std::vector<Look>{{"b", 0, 50}}));
    pools.mark_all_changed();
    EXPECT_EQ(look(pools), (std::vector<Look>{{"a", 30, 30}, {"b", 0, 0}}));
}

TEST(PoolTotals, an_address_that_comes_twice_counts_once_and_an_unknown_one_not_at_all)
{
    PoolTotals pools;
    pools.add(address(16), 100, "a");
    pools.add(address(16), 40, "b");
    pools.remove(address(64));
    pools.add(nullptr, 7, "a");
    EXPECT_EQ(look(pools), (std::vector<Look>{{"a", 0, 100}, {"b", 40, 40}}));
}

TEST(PoolTotals, a_name_may_go_and_may_be_long)
{
    PoolTotals pools;
    std::string name(100, 'x');
    pools.add(address(16), 1, name.c_str());
    pools.add(address(32), 1, name.c_str());
    std::fill(name.begin(), name.end(), 'y');
    EXPECT_EQ(look(pools), (std::vector<Look>{{std::string(63, 'x'), 2, 2}}));
}

TEST(PoolTotals, the_last_pool_takes_in_all_that_come_after)
{
    PoolTotals pools;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < PoolTotals::max_pools + 10; ++i) names.push_back("pool " + std::to_string(i));
    for (std::size_t i = 0; i < names.size(); ++i) pools.add(address(16 * (i + 1)), 1, names[i].c_str());
    const std::vector<Look> changes = look(pools);
    ASSERT_EQ(changes.size(), PoolTotals::max_pools);
    EXPECT_EQ(changes.back(), (Look{"other pools", 11, 11}));
}

} // namespace carom::profile
