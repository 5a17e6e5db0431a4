#include "gallery/stage_meter.hpp"

#include <gtest/gtest.h>

namespace carom::gallery
{

namespace
{

StepReport report_of(double milliseconds, std::size_t pairs_tested)
{
    StepReport report;
    report.seconds = 1e-3 * milliseconds;
    report.stage_seconds[0] = 0.5e-3 * milliseconds;
    report.broad_phase.pairs_tested = pairs_tested;
    return report;
}

} // namespace

TEST(StageMeter, keeps_what_was_before_a_switch)
{
    StageMeter meter;
    for (int i = 0; i < 50; ++i) meter.add(report_of(4, 1000), BroadPhaseType::BruteForce);
    EXPECT_FALSE(meter.before());
    for (int i = 0; i < 50; ++i) meter.add(report_of(1, 30), BroadPhaseType::Tree);
    ASSERT_TRUE(meter.before());
    EXPECT_EQ(meter.before()->broad_phase, BroadPhaseType::BruteForce);
    EXPECT_NEAR(meter.before()->step_ms, 4, 1e-9);
    EXPECT_NEAR(meter.before()->pairs_tested, 1000, 1e-9);
    EXPECT_NEAR(meter.now().step_ms, 1, 1e-9);
    EXPECT_NEAR(meter.now().stage_ms[0], 0.5, 1e-9);
    EXPECT_EQ(meter.now().broad_phase, BroadPhaseType::Tree);
    meter.clear();
    EXPECT_FALSE(meter.before());
    EXPECT_EQ(meter.step_ms().size(), 0u);
}

TEST(StageMeter, leaves_out_the_step_that_builds_the_structure)
{
    StageMeter meter;
    meter.add(report_of(100, 0), BroadPhaseType::Tree);
    meter.add(report_of(1, 0), BroadPhaseType::Tree);
    EXPECT_NEAR(meter.now().step_ms, 1, 1e-9);
    EXPECT_EQ(meter.step_ms().largest(), 100);
}

TEST(StageMeter, follows_what_changes)
{
    StageMeter meter;
    for (int i = 0; i < 1000; ++i) meter.add(report_of(1, 0), BroadPhaseType::Tree);
    for (int i = 0; i < 5 * StageMeter::window; ++i) meter.add(report_of(2, 0), BroadPhaseType::Tree);
    EXPECT_NEAR(meter.now().step_ms, 2, 0.02);
    EXPECT_EQ(meter.now().steps, StageMeter::window);
}

TEST(History, forgets_the_oldest)
{
    History history;
    for (int i = 0; i < 1000; ++i) history.add(i);
    EXPECT_EQ(history.size(), History::capacity);
    EXPECT_EQ(history[0], 1000 - History::capacity);
    EXPECT_EQ(history.latest(), 999);
    EXPECT_EQ(history.largest(), 999);
}

} // namespace carom::gallery
