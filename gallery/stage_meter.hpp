// What the last steps took, by stage, and what they took before the broad phase was switched.
#pragma once

#include "gallery/history.hpp"

#include <carom/broad_phase.hpp>
#include <carom/report.hpp>

#include <array>
#include <optional>

namespace carom::gallery
{

/// Means over the last steps.
struct StepMeans
{
    BroadPhaseType broad_phase = BroadPhaseType::Tree;
    int steps = 0; ///< that they are over
    double step_ms = 0;
    std::array<double, stage_count> stage_ms = {};
    double pairs_tested = 0;
    double pairs_found = 0;
    double nodes = 0;
};

class StageMeter
{
public:
    /// Steps over which means are taken: enough to be calm, few enough to follow what happens.
    static constexpr int window = 120;

    /// Adds a step.
    /// @param broad_phase by which it was made
    void add(const StepReport& report, BroadPhaseType broad_phase);
    /// Forgets all, for another scene.
    void clear();

    const StepMeans& now() const { return now_; }
    /// Means from just before the last switch of the broad phase.
    const std::optional<StepMeans>& before() const { return before_; }
    const StepReport& latest() const { return latest_; } ///< its list of quarantined bodies is empty
    const History& step_ms() const { return step_ms_; }
    const History& stage_ms(Stage stage) const { return stage_history_[static_cast<std::size_t>(stage)]; }
    const History& bytes() const { return bytes_; } ///< of the whole world
    const History& bytes(MemoryCategory category) const { return category_bytes_[static_cast<std::size_t>(category)]; }

private:
    StepMeans now_;
    std::optional<StepMeans> before_;
    StepReport latest_;
    History step_ms_;
    std::array<History, stage_count> stage_history_;
    History bytes_;
    std::array<History, memory_category_count> category_bytes_;
    bool is_first_ = true; ///< since the switch or the start
};

} // namespace carom::gallery
