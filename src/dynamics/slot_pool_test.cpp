#include "dynamics/slot_pool.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace carom::detail
{

TEST(SlotPool, hands_out_dense_indices)
{
    SlotPool pool(*std::pmr::get_default_resource());
    EXPECT_EQ(pool.acquire(), 0u);
    EXPECT_EQ(pool.acquire(), 1u);
    EXPECT_EQ(pool.acquire(), 2u);
    EXPECT_EQ(pool.size(), 3u);
    EXPECT_EQ(pool.live_count(), 3);
}

TEST(SlotPool, a_place_used_again_has_a_new_generation)
{
    SlotPool pool(*std::pmr::get_default_resource());
    const std::uint32_t first = pool.acquire();
    const std::uint32_t generation = pool.generation(first);
    pool.release(first);
    EXPECT_FALSE(pool.is_live(first, generation));
    EXPECT_EQ(pool.acquire(), first);
    EXPECT_FALSE(pool.is_live(first, generation));
    EXPECT_TRUE(pool.is_live(first, pool.generation(first)));
}

TEST(SlotPool, the_last_freed_comes_first)
{
    SlotPool pool(*std::pmr::get_default_resource());
    for (int i = 0; i < 4; ++i) pool.acquire();
    pool.release(1);
    pool.release(3);
    EXPECT_EQ(pool.acquire(), 3u);
    EXPECT_EQ(pool.acquire(), 1u);
    EXPECT_EQ(pool.acquire(), 4u);
}

TEST(SlotPool, dropping_the_tail_keeps_the_order_of_the_other_free_places)
{
    SlotPool pool(*std::pmr::get_default_resource());
    for (int i = 0; i < 8; ++i) pool.acquire();
    for (const std::uint32_t place : {1u, 6u, 3u, 7u, 0u, 5u}) pool.release(place);
    pool.drop_tail();
    EXPECT_EQ(pool.size(), 5u) << "2 and 4 are in use";
    EXPECT_EQ(pool.live_count(), 2);
    EXPECT_EQ(pool.acquire(), 0u);
    EXPECT_EQ(pool.acquire(), 3u);
    EXPECT_EQ(pool.acquire(), 1u);
    EXPECT_EQ(pool.acquire(), 5u) << "a new one";
}

TEST(SlotPool, no_id_from_before_the_drop_names_anything_after_it)
{
    SlotPool pool(*std::pmr::get_default_resource());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> old_ids;
    for (int round = 0; round < 5; ++round)
    {
        for (int i = 0; i < 10 + 3 * round; ++i)
        {
            const std::uint32_t place = pool.acquire();
            for (const auto& [index, generation] : old_ids) ASSERT_FALSE(index == place && generation == pool.generation(place)) << round;
            old_ids.emplace_back(place, pool.generation(place));
        }
        for (const auto& [index, generation] : old_ids)
            if (pool.is_live(index, generation)) pool.release(index);
        pool.drop_tail();
        EXPECT_EQ(pool.size(), 0u);
        for (const auto& [index, generation] : old_ids)
        {
            EXPECT_FALSE(pool.is_live(index, generation));
            EXPECT_TRUE(pool.was_live(index, generation));
        }
    }
    EXPECT_FALSE(pool.was_live(0, pool.dropped_generation() + 1)) << "that one is yet to come";
}

TEST(SlotPool, an_index_out_of_range_is_not_live)
{
    SlotPool pool(*std::pmr::get_default_resource());
    EXPECT_FALSE(pool.is_live(0));
    EXPECT_FALSE(pool.is_live(null_index, 1));
}

} // namespace carom::detail
