// What a step tells of its time, and that telling changes nothing.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <numeric>

namespace carom
{

namespace
{

double sum_of(const StepReport& report) { return std::accumulate(report.stage_seconds.begin(), report.stage_seconds.end(), 0.0); }

World two_boxes(bool stage_times)
{
    World world({.stage_times = stage_times});
    world.create_body({.type = BodyType::Static}, box(20, 1));
    for (const float y : {1.0f, 2.1f}) world.create_body({.position = {0, y}}, box(1, 1));
    return world;
}

} // namespace

TEST(StageTimes, add_up_to_the_time_of_the_step)
{
    World world = two_boxes(true);
    for (int i = 0; i < 20; ++i)
    {
        const StepReport report = world.step(dt);
        EXPECT_GT(report.seconds, 0);
        EXPECT_GT(sum_of(report), 0.2 * report.seconds);
        EXPECT_LE(sum_of(report), report.seconds * (1 + 1e-9));
    }
}

TEST(StageTimes, are_zero_where_nobody_asked_and_change_nothing)
{
    World with = two_boxes(true);
    World without = two_boxes(false);
    for (int i = 0; i < 60; ++i)
    {
        with.step(dt);
        const StepReport report = without.step(dt);
        EXPECT_EQ(report.seconds, 0);
        EXPECT_EQ(sum_of(report), 0);
    }
    EXPECT_EQ(with.hash(), without.hash());
    EXPECT_EQ(without.copy().step(dt).seconds, 0) << "a copy is as its original";
}

namespace
{

/// Counts the stages that it is shown.
struct Counter final : StepProbe
{
    void after_stage(const StepMoment&, const StepView&) override { ++stages; }
    int stages = 0;
};

} // namespace

/// A world at rest leaves out the stages that would find nothing to do. A probe sees them all the same, and the state does not show which it was.
TEST(StageTimes, at_rest_the_state_goes_on_to_the_same_bits_with_a_probe_and_without)
{
    World plain = two_boxes(true);
    World probed = two_boxes(true);
    Counter counter;
    for (int i = 0; i < 400; ++i)
    {
        plain.step(dt, 4 + i / 300);
        probed.step(dt, 4 + i / 300, i > 300 ? &counter : nullptr);
    }
    ASSERT_EQ(plain.awake_body_count(), 0);
    EXPECT_GT(counter.stages, 99 * 20);
    EXPECT_EQ(plain.hash(), probed.hash());
    // And it wakes as it would.
    for (World* world : {&plain, &probed})
    {
        world->body(world->bodies().back()).apply_impulse({3, 0}, {0, 2});
        for (int i = 0; i < 30; ++i) world->step(dt);
    }
    EXPECT_EQ(plain.hash(), probed.hash());
}

} // namespace carom
