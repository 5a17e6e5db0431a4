#include "dynamics/slot_pool.hpp"

#include <gtest/gtest.h>

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

TEST(SlotPool, an_index_out_of_range_is_not_live)
{
    SlotPool pool(*std::pmr::get_default_resource());
    EXPECT_FALSE(pool.is_live(0));
    EXPECT_FALSE(pool.is_live(null_index, 1));
}

} // namespace carom::detail
