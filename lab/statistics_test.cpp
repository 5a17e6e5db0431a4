// Quantiles and summaries of known lists.
#include "lab/statistics.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace carom::lab
{

TEST(Statistics, quantiles_lie_between_the_numbers)
{
    const std::vector<double> sorted = {1, 2, 3, 4, 10};
    EXPECT_EQ(quantile(sorted, 0), 1);
    EXPECT_EQ(quantile(sorted, 0.5), 3);
    EXPECT_EQ(quantile(sorted, 0.625), 3.5);
    EXPECT_EQ(quantile(sorted, 1), 10);
}

TEST(Statistics, summarizes_in_any_order)
{
    std::vector<double> values;
    for (int i = 100; i >= 0; --i) values.push_back(i);
    const Summary summary = summarize(values);
    EXPECT_EQ(summary.mean, 50);
    EXPECT_EQ(summary.median, 50);
    EXPECT_EQ(summary.p99, 99);
    EXPECT_EQ(summary.max, 100);
}

TEST(Statistics, summarizes_one_and_none)
{
    const std::vector<double> one = {3};
    EXPECT_EQ(summarize(one).p99, 3);
    EXPECT_EQ(summarize({}).max, 0);
}

} // namespace carom::lab
