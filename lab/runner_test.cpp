// A run equals stepping by hand, and measures the world alone.
#include "lab/runner.hpp"

#include "scenes/registry.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace carom::lab
{

TEST(Runner, equals_stepping_by_hand)
{
    const auto scene = scenes::make_scene("collisions", {{"circles", 100}, {"boxes", 100}});
    const RunResult result = run(*scene, {.steps = 120});

    const auto by_hand = scenes::make_scene("collisions", {{"circles", 100}, {"boxes", 100}});
    std::uint64_t begun = 0;
    for (int i = 0; i < 120; ++i)
    {
        by_hand->step();
        begun += by_hand->world().events().contact_begin.size();
    }
    EXPECT_EQ(result.steps, 120);
    EXPECT_EQ(result.hash, by_hand->world().hash());
    EXPECT_EQ(result.events.contact_begin, begun);
    EXPECT_EQ(result.last.bodies, 201);
    EXPECT_EQ(result.quarantined, 0u);
}

TEST(Runner, stages_add_up_to_less_than_the_step)
{
    const auto scene = scenes::make_scene("gravity");
    const RunResult result = run(*scene, {.steps = 60});
    const double stages = std::accumulate(result.stage_ms.begin(), result.stage_ms.end(), 0.0);
    EXPECT_GT(stages, 0);
    EXPECT_LE(stages, 1.0001 * result.step_ms.mean);
    EXPECT_LE(result.step_ms.median, result.step_ms.p99);
    EXPECT_LE(result.step_ms.p99, result.step_ms.max);
}

TEST(Runner, calls_before_and_after_every_step)
{
    const auto scene = scenes::make_scene("triggers");
    int before = 0;
    int after = 0;
    run(*scene, {.steps = 10,
                 .before_step =
                     [&](scenes::Scene& s, int step)
    {
        EXPECT_EQ(step, before++);
        EXPECT_EQ(s.world().step_count(), static_cast<std::uint64_t>(step));
    },
                 .after_step = [&](const scenes::Scene& s, int step)
    {
        EXPECT_EQ(step, after++);
        EXPECT_EQ(s.world().step_count(), static_cast<std::uint64_t>(step) + 1);
    }});
    EXPECT_EQ(before, 10);
    EXPECT_EQ(after, 10);
}

TEST(Runner, counts_allocations_of_the_worlds_steps_in_the_second_half)
{
    const auto scene = scenes::make_scene("triggers");
    std::uint64_t readings = 0;
    // Two readings a step, one before and one after: each step seems to allocate once, and the caller's code not at all.
    const RunResult result = run(*scene, {.steps = 7, .heap_allocations = [&] { return readings++; }});
    EXPECT_EQ(result.heap_allocations_per_step, 1);
    EXPECT_EQ(readings, 14u);
}

} // namespace carom::lab
