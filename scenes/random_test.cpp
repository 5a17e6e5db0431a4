// The generator against its published sequence, and the ranges of its numbers.
#include "scenes/random.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

TEST(Random, equals_the_published_sequence_of_pcg32)
{
    Random random(42, 54);
    for (const std::uint32_t expected : {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu})
        EXPECT_EQ(random.bits(), expected);
}

TEST(Random, reals_stay_in_their_range_and_average_to_its_middle)
{
    Random random(1);
    double sum = 0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i)
    {
        const float x = random.uniform(-3, 5);
        ASSERT_GE(x, -3);
        ASSERT_LE(x, 5);
        sum += static_cast<double>(x);
    }
    EXPECT_NEAR(sum / count, 1, 0.03); // the mean's standard deviation is 0.0073
}

TEST(Random, integers_reach_both_ends_and_nothing_beyond)
{
    Random random(1);
    int seen[5] = {};
    for (int i = 0; i < 1000; ++i)
    {
        const int x = random.integer(-2, 2);
        ASSERT_GE(x, -2);
        ASSERT_LE(x, 2);
        ++seen[x + 2];
    }
    for (const int count : seen) EXPECT_NEAR(count, 200, 60);
}

TEST(Random, integers_cover_the_whole_range_of_int)
{
    Random random(1);
    bool has_negative = false;
    bool has_positive = false;
    for (int i = 0; i < 100; ++i) (random.integer(INT32_MIN, INT32_MAX) < 0 ? has_negative : has_positive) = true;
    EXPECT_TRUE(has_negative && has_positive);
}

TEST(Random, directions_have_length_one)
{
    Random random(7);
    for (int i = 0; i < 100; ++i) EXPECT_NEAR(length(random.direction()), 1, 1e-5);
}

TEST(Random, streams_of_one_seed_differ)
{
    Random a(1, 1);
    Random b(1, 2);
    EXPECT_NE(a.bits(), b.bits());
}

} // namespace carom::scenes
