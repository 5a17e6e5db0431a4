// Steps a scene and adds up what its world's reports and events say.
#include "lab/runner.hpp"

#include <vector>

namespace carom::lab
{

namespace
{

constexpr double ms = 1000; // in a second

/// Counts the allocations of the world's own steps.
class AllocationCounter : public scenes::StepObserver
{
public:
    explicit AllocationCounter(const std::function<std::uint64_t()>& count) : count_(count) {}

    void world_step_begins() override { before_ = count_ ? count_() : 0; }
    void world_step_ended() override { last_step = count_ ? count_() - before_ : 0; }

    std::uint64_t last_step = 0;

private:
    const std::function<std::uint64_t()>& count_;
    std::uint64_t before_ = 0;
};

void add(EventCounts& total, const Events& events)
{
    total.contact_begin += events.contact_begin.size();
    total.contact_persist += events.contact_persist.size();
    total.contact_end += events.contact_end.size();
    total.sensor_begin += events.sensor_begin.size();
    total.sensor_persist += events.sensor_persist.size();
    total.sensor_end += events.sensor_end.size();
}

} // namespace

RunResult run(scenes::Scene& scene, const RunOptions& options)
{
    RunResult result;
    result.steps = options.steps;
    std::vector<double> step_ms;
    step_ms.reserve(static_cast<std::size_t>(options.steps));
    AllocationCounter counter(options.heap_allocations);
    std::uint64_t late_allocations = 0;

    for (int step = 0; step < options.steps; ++step)
    {
        if (options.before_step) options.before_step(scene, step);
        result.last = scene.step(&counter);
        step_ms.push_back(ms * result.last.seconds);
        for (std::size_t i = 0; i < stage_count; ++i) result.stage_ms[i] += ms * result.last.stage_seconds[i] / options.steps;
        if (step >= options.steps / 2) late_allocations += counter.last_step;
        result.quarantined += result.last.quarantined.size();
        result.too_long_steps += result.last.is_too_long;
        add(result.events, scene.world().events());
        if (options.after_step) options.after_step(scene, step);
    }

    result.last.quarantined = {};
    result.last.quarantine_reasons = {};
    result.step_ms = summarize(step_ms);
    result.hash = scene.world().hash();
    result.heap_allocations_per_step = static_cast<double>(late_allocations) / (options.steps - options.steps / 2);
    return result;
}

} // namespace carom::lab
