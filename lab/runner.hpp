// Runs a scene without a window and measures its world's steps.
#pragma once

#include "lab/statistics.hpp"
#include "scenes/scene.hpp"

#include <carom/report.hpp>

#include <array>
#include <cstdint>
#include <functional>

namespace carom::lab
{

/// What a caller adds to a run. None of it is measured; empty functions are skipped.
struct RunOptions
{
    int steps = 600; ///< >= 1
    /// Before each step, from 0: gives the scene its input.
    std::function<void(scenes::Scene&, int step)> before_step = {};
    /// After each step, from 0: draws the scene, tells of the progress.
    std::function<void(const scenes::Scene&, int step)> after_step = {};
    /// Heap allocations of the process so far. Read around each of the world's steps.
    std::function<std::uint64_t()> heap_allocations = {};
};

/// How often each kind of event happened.
struct EventCounts
{
    std::uint64_t contact_begin = 0;
    std::uint64_t contact_persist = 0;
    std::uint64_t contact_end = 0;
    std::uint64_t sensor_begin = 0;
    std::uint64_t sensor_persist = 0;
    std::uint64_t sensor_end = 0;
};

struct RunResult
{
    int steps = 0;
    Summary step_ms;                               ///< of the world's steps [ms]
    std::array<double, stage_count> stage_ms = {}; ///< mean of each stage [ms]
    StepReport last;                               ///< of the last step; its list of quarantined bodies is empty
    std::uint64_t quarantined = 0;                 ///< bodies that were put aside in the whole run
    int too_long_steps = 0;                        ///< steps that warned of too long substeps
    EventCounts events;                            ///< in the whole run
    std::uint64_t hash = 0;                        ///< of the world at the end
    /// Mean over the second half of the run, when the world no longer grows; 0 when nobody counts.
    double heap_allocations_per_step = 0;
};

RunResult run(scenes::Scene& scene, const RunOptions& options);

} // namespace carom::lab
