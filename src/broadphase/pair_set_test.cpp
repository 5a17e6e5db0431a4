// PairSet against std::set, over many random rounds.
#include "broadphase/pair_set.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace carom::detail
{
namespace
{

TEST(PairSet, StartsEmptyAndNeedsNoMemory)
{
    PairSet set(*std::pmr::null_memory_resource());
    EXPECT_EQ(set.size(), 0u);
    EXPECT_FALSE(set.contains({0, 1}));
    EXPECT_FALSE(set.erase({0, 1}));
}

TEST(PairSet, AgreesWithAnOrderedSet)
{
    std::mt19937 engine(1);
    const auto random = [&engine](ProxyIndex end) { return static_cast<ProxyIndex>(engine() % end); };
    PairSet set(*std::pmr::new_delete_resource());
    std::set<ProxyPair> reference;
    for (int i = 0; i < 200000; ++i)
    {
        const ProxyIndex a = random(60);
        const ProxyPair pair{a, a + 1 + random(40)};
        const bool grows = (i / 20000) % 2 == 0;
        if (random(8) < (grows ? 5u : 3u))
            EXPECT_EQ(set.insert(pair), reference.insert(pair).second);
        else
            EXPECT_EQ(set.erase(pair), reference.erase(pair) == 1);
        ASSERT_EQ(set.size(), reference.size());
    }
    for (ProxyIndex a = 0; a < 60; ++a)
        for (ProxyIndex b = a + 1; b < 101; ++b) EXPECT_EQ(set.contains({a, b}), reference.count({a, b}) == 1);
}

TEST(PairSet, HoldsTheLargestIndices)
{
    PairSet set(*std::pmr::new_delete_resource());
    EXPECT_TRUE(set.insert({0xfffffffeu, 0xffffffffu}));
    EXPECT_TRUE(set.insert({0, 0xffffffffu}));
    EXPECT_FALSE(set.insert({0xfffffffeu, 0xffffffffu}));
    EXPECT_TRUE(set.contains({0xfffffffeu, 0xffffffffu}));
    EXPECT_TRUE(set.erase({0xfffffffeu, 0xffffffffu}));
    EXPECT_FALSE(set.contains({0xfffffffeu, 0xffffffffu}));
    EXPECT_EQ(set.size(), 1u);
}

TEST(PairSet, ReservedRoomIsEnough)
{
    alignas(std::max_align_t) std::byte buffer[1 << 16];
    std::pmr::monotonic_buffer_resource once(buffer, sizeof buffer, std::pmr::null_memory_resource());
    PairSet set(once);
    set.reserve(2000);
    for (int round = 0; round < 3; ++round)
    {
        for (ProxyIndex a = 0; a < 2000; ++a) EXPECT_TRUE(set.insert({a, a + 1}));
        EXPECT_EQ(set.size(), 2000u);
        set.clear();
        EXPECT_FALSE(set.contains({5, 6}));
    }
}

} // namespace
} // namespace carom::detail
