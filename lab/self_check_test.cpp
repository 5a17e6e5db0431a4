#include "lab/self_check.hpp"

#include <gtest/gtest.h>

namespace carom::lab
{

namespace
{

Comparison with_ratio(double ratio, Verdict verdict)
{
    Comparison c;
    c.ratio = ratio;
    c.interval = {ratio - 0.01, ratio + 0.01};
    c.verdict = verdict;
    return c;
}

SelfCheck check_of(int tries, int alarms, const Comparison& planted)
{
    SelfCheck check;
    check.plan.slowdown = 0.05;
    for (int i = 0; i < tries; ++i) check.same.push_back(with_ratio(1, i < alarms ? Verdict::Faster : Verdict::None));
    check.planted = planted;
    return check;
}

} // namespace

TEST(SelfCheck, passes_with_one_false_alarm_in_twenty_and_what_was_planted_found)
{
    const Comparison found = with_ratio(1.052, Verdict::Slower);
    EXPECT_TRUE(check_of(20, 1, found).is_passed());
    EXPECT_FALSE(check_of(20, 2, found).is_passed());
    EXPECT_TRUE(check_of(40, 2, found).is_passed());
    EXPECT_FALSE(check_of(20, 0, with_ratio(1.05, Verdict::None)).is_passed());
    EXPECT_FALSE(check_of(20, 0, with_ratio(1.5, Verdict::Slower)).is_passed()) << "it is not the one that was planted";
    EXPECT_NE(self_check_text(check_of(20, 3, found)).find("a difference in 3 of 20 tries"), std::string::npos);
}

TEST(SelfCheck, tells_when_the_program_fails)
{
    SelfCheckPlan plan{.scene = {.scene = "none", .what = "", .bodies = 0, .steps = 1, .threads = 1, .file = "/nowhere.json"},
                       .tries = 1,
                       .runs = 4,
                       .carom = "carom-no-such-program",
                       .scratch = std::filesystem::path(testing::TempDir()) / "carom_self_check_test"};
    EXPECT_THROW(run_self_check(plan), std::runtime_error);
}

} // namespace carom::lab
