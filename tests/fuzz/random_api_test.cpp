// 100,000 random calls: nothing crashes, every bad one is refused with a complete message and changes nothing, every good one is accepted.
#include "tests/fuzz/random_api.hpp"

#include <gtest/gtest.h>

#include <iostream>

namespace carom::fuzz
{

class RandomCalls : public testing::TestWithParam<int>
{
};

TEST_P(RandomCalls, never_crash_and_are_refused_just_when_they_are_bad)
{
    RandomApi api(static_cast<std::uint64_t>(GetParam()));
    while (api.tally().calls < 12500 && !HasFailure()) api.call();
    const Tally tally = api.tally();
    std::cout << tally.calls << " calls, " << tally.refused << " refused, of which " << tally.during_step << " during a step and "
              << tally.stale << " on what was gone, " << tally.doubtful << " that might be either, " << tally.quarantined
              << " bodies quarantined, up to " << tally.most_bodies << " bodies and " << tally.most_joints << " joints, " << tally.breaks
              << " of which broke\n";
    EXPECT_GT(tally.refused, 500);
    EXPECT_GT(tally.during_step, 0);
    EXPECT_GT(tally.stale, 100);
    EXPECT_LT(tally.doubtful, tally.calls / 20) << "the test should know what is right";
    EXPECT_GT(tally.most_bodies, 50);
    EXPECT_GT(tally.most_chains, 10);
    EXPECT_GT(tally.hook_calls, 500);
    EXPECT_GT(tally.probe_refused, 20);
    EXPECT_GT(tally.most_joints, 20);
    EXPECT_GT(tally.breaks, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCalls, testing::Range(1, 9));

} // namespace carom::fuzz
