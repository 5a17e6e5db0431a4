// Measures the stages of a step into its report.
#pragma once

#include <carom/report.hpp>

#include <chrono>

namespace carom::detail
{

/// Adds the time of its life to one stage.
class StageTimer
{
public:
    using Clock = std::chrono::steady_clock;

    StageTimer(StepReport& report, Stage stage) : seconds_(report.stage_seconds[static_cast<std::size_t>(stage)]), start_(Clock::now()) {}
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;
    ~StageTimer() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }

private:
    double& seconds_;
    Clock::time_point start_;
};

} // namespace carom::detail
