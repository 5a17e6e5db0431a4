// Runs the stages of a step: what is around each of them.
#pragma once

#include "profile/stage_timer.hpp"
#include "step/mid_step.hpp"

#include <type_traits>

namespace carom::detail
{

/// Times a stage into the report, then shows the probe what it has left.
class StageRunner
{
public:
    /// @param moment its stage is set by each run
    /// @param probe  null for none
    StageRunner(StepClock& clock, const MidStep& moment, int substeps, StepProbe* probe)
        : clock_(clock),
          moment_(moment),
          substeps_(substeps),
          probe_(probe)
    {
    }

    /// @return what the work returns
    template <class Work>
    auto operator()(Stage stage, int substep, const Work& work)
    {
        const auto timed = [&]
        {
            const StepClock::Zone zone(clock_, stage);
            return work();
        };
        if constexpr (std::is_void_v<std::invoke_result_t<const Work&>>)
        {
            timed();
            if (probe_) show(stage, substep);
        }
        else
        {
            auto result = timed();
            if (probe_) show(stage, substep);
            return result;
        }
    }
    /// A stage outside of the substeps.
    template <class Work>
    auto operator()(Stage stage, const Work& work)
    {
        return (*this)(stage, -1, work);
    }

private:
    void show(Stage stage, int substep)
    {
        moment_.stage = stage;
        probe_->after_stage({stage, substep, substeps_}, moment_.view());
        clock_.leave_out();
    }

    StepClock& clock_;
    MidStep moment_;
    int substeps_;
    StepProbe* probe_;
};

} // namespace carom::detail
