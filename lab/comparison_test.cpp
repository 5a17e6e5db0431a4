#include "lab/comparison.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace carom::lab
{

namespace
{

const std::vector<double> first = {20.1, 22.3, 19.8, 21.0, 23.4, 20.7};
const std::vector<double> second = {24.9, 23.1, 26.2, 22.8, 25.5};

/// Times of runs on a machine that drifts and now and then stumbles.
std::vector<double> runs(std::mt19937_64& random, int count, double mean, const std::vector<double>& drift)
{
    std::normal_distribution<double> noise(0, 0.012);
    std::uniform_real_distribution<double> chance;
    std::vector<double> times;
    for (int i = 0; i < count; ++i)
    {
        const double stumble = chance(random) < 0.05 ? 0.15 : 0;
        times.push_back(mean * (1 + noise(random) + stumble + drift[static_cast<std::size_t>(i)]));
    }
    return times;
}

std::vector<double> drift_of(std::mt19937_64& random, int count)
{
    std::normal_distribution<double> wander(0, 0.02);
    std::vector<double> drift;
    double now = 0;
    for (int i = 0; i < count; ++i) drift.push_back(now += 0.3 * wander(random));
    return drift;
}

} // namespace

// The references are from SciPy 1.10: ttest_ind with equal_var true and false, mannwhitneyu with method exact and asymptotic.
TEST(Comparison, t_tests_agree_with_a_reference)
{
    const TTest student = student_t_test(first, second);
    EXPECT_NEAR(student.t, 3.791345, 1e-6);
    EXPECT_NEAR(student.p, 0.004273814, 1e-8);
    EXPECT_EQ(student.degrees_of_freedom, 9);
    const TTest welch = welch_t_test(first, second);
    EXPECT_NEAR(welch.t, 3.761433, 1e-6);
    EXPECT_NEAR(welch.p, 0.005129411, 1e-8);
    EXPECT_NEAR(welch.degrees_of_freedom, 8.341729, 1e-6);
    EXPECT_TRUE(welch.interval.contains(welch.difference));
    EXPECT_FALSE(welch.interval.contains(0));
}

TEST(Comparison, rank_tests_agree_with_a_reference)
{
    const RankTest exact = mann_whitney(first, second);
    EXPECT_EQ(exact.u, 2);
    EXPECT_NEAR(exact.p, 0.017316017, 1e-9);
    const std::vector<double> tied_a = {1, 2, 2, 3, 4, 4, 5};
    const std::vector<double> tied_b = {2, 4, 5, 5, 6, 7, 7, 8};
    const RankTest tied = mann_whitney(tied_a, tied_b);
    EXPECT_EQ(tied.u, 8);
    EXPECT_NEAR(tied.p, 0.022410041, 1e-8);
}

TEST(Comparison, finds_no_difference_between_equals_in_at_least_19_of_20_tries)
{
    std::mt19937_64 random(7);
    int found = 0;
    constexpr int tries = 400;
    for (int i = 0; i < tries; ++i)
    {
        const std::vector<double> drift = drift_of(random, 12);
        const std::vector<double> a = runs(random, 12, 3, drift);
        const std::vector<double> b = runs(random, 12, 3, drift);
        found += compare(a, b, {.resamples = 500}).verdict != Verdict::None ? 1 : 0;
    }
    EXPECT_LE(found, tries / 20);
}

TEST(Comparison, finds_a_slowdown_of_5_percent)
{
    std::mt19937_64 random(8);
    int found = 0;
    constexpr int tries = 200;
    for (int i = 0; i < tries; ++i)
    {
        const std::vector<double> drift = drift_of(random, 16);
        const std::vector<double> a = runs(random, 16, 3, drift);
        const std::vector<double> b = runs(random, 16, 3.15, drift);
        found += compare(a, b, {.resamples = 500}).verdict == Verdict::Slower ? 1 : 0;
    }
    EXPECT_GE(found, tries * 9 / 10);
}

TEST(Comparison, an_interval_holds_the_true_ratio_as_often_as_it_says)
{
    std::mt19937_64 random(9);
    const std::vector<double> calm(20, 0);
    int held = 0;
    constexpr int tries = 300;
    for (int i = 0; i < tries; ++i)
    {
        const std::vector<double> a = runs(random, 20, 2, calm);
        const std::vector<double> b = runs(random, 20, 3, calm);
        held += compare(a, b, {.resamples = 500}).interval.contains(1.5) ? 1 : 0;
    }
    EXPECT_GE(held, tries * 9 / 10);
}

TEST(Comparison, a_difference_below_the_threshold_is_none)
{
    std::vector<double> a;
    std::vector<double> b;
    for (int i = 0; i < 20; ++i)
    {
        a.push_back(1 + 1e-4 * i);
        b.push_back(1.01 + 1e-4 * i);
    }
    EXPECT_LT(compare(a, b).mann_whitney_p, 0.001);
    EXPECT_EQ(compare(a, b).verdict, Verdict::None);
    EXPECT_EQ(compare(a, b, {.threshold = 0.005}).verdict, Verdict::Slower);
}

TEST(Comparison, warns_of_a_noisy_machine)
{
    std::vector<double> calm;
    std::vector<double> wild;
    for (int i = 0; i < 20; ++i)
    {
        calm.push_back(1 + 1e-3 * (i % 5));
        wild.push_back(1 + 0.3 * (i % 2));
    }
    EXPECT_FALSE(compare(calm, calm).is_noisy);
    EXPECT_TRUE(compare(calm, wild).is_noisy);
}

TEST(Comparison, refuses_what_can_not_be_compared)
{
    const std::vector<double> one = {1};
    const std::vector<double> bad = {1, NAN, 2};
    const std::vector<double> zero = {1, 0, 2};
    EXPECT_THROW(compare(one, first), std::invalid_argument);
    EXPECT_THROW(compare(first, bad), std::invalid_argument);
    EXPECT_THROW(compare(zero, first), std::invalid_argument);
    EXPECT_THROW(student_t_test(one, first), std::invalid_argument);
}

TEST(Comparison, of_times_without_any_spread)
{
    const std::vector<double> a(5, 2.0);
    const std::vector<double> b(5, 3.0);
    EXPECT_EQ(compare(a, a).verdict, Verdict::None);
    EXPECT_EQ(compare(a, b).verdict, Verdict::Slower);
    EXPECT_EQ(student_t_test(a, b).p, 0);
}

TEST(Comparison, means_of_ratios_are_geometric)
{
    const std::vector<double> ratios = {0.5, 2};
    EXPECT_NEAR(geometric_mean(ratios), 1, 1e-12);
}

} // namespace carom::lab
