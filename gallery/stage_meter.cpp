// Takes means over steps.
#include "gallery/stage_meter.hpp"

#include <algorithm>
#include <utility>

namespace carom::gallery
{

namespace
{

constexpr double ms = 1000; // in a second

void blend(double& mean, double value, double share) { mean += share * (value - mean); }

} // namespace

void StageMeter::add(const StepReport& report, BroadPhaseType broad_phase)
{
    latest_ = report;
    latest_.quarantined = {}; // it lies in the world
    latest_.quarantine_reasons = {};
    step_ms_.add(ms * report.seconds);
    for (std::size_t i = 0; i < stage_count; ++i) stage_history_[i].add(ms * report.stage_seconds[i]);
    bytes_.add(static_cast<double>(report.memory.total.bytes));
    for (std::size_t i = 0; i < memory_category_count; ++i) category_bytes_[i].add(static_cast<double>(report.memory.categories[i].bytes));

    if (broad_phase != now_.broad_phase && now_.steps > 0)
    {
        before_ = now_;
        now_ = {};
        is_first_ = true;
    }
    now_.broad_phase = broad_phase;
    // The first step builds the structure: it says nothing about those that follow.
    if (std::exchange(is_first_, false)) return;
    now_.steps = std::min(now_.steps + 1, window);
    const double share = 1.0 / now_.steps;
    blend(now_.step_ms, ms * report.seconds, share);
    for (std::size_t i = 0; i < stage_count; ++i) blend(now_.stage_ms[i], ms * report.stage_seconds[i], share);
    blend(now_.pairs_tested, static_cast<double>(report.broad_phase.pairs_tested), share);
    blend(now_.pairs_found, static_cast<double>(report.broad_phase.pairs_found), share);
    blend(now_.nodes, static_cast<double>(report.broad_phase.nodes), share);
}

void StageMeter::clear() { *this = {}; }

} // namespace carom::gallery
