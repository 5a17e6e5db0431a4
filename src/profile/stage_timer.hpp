// Measures a step and its stages into its report, and marks both as zones for the profiler. A reading of the clock serves both, and two stages.
#pragma once

#include "profile/backend.hpp"

#include <carom/report.hpp>

#include <chrono>

namespace carom::detail
{

const profile::ZoneSite& zone_site_of(Stage stage);
const profile::ZoneSite& zone_site_of_step();

/// Tells a report how long the step and its stages take, and the profiler, when there is one, that they are zones. The end of a stage is the start
/// of the next: reading the clock twice for each was two thirds of the step of a world at rest.
class StepClock
{
public:
    using Clock = std::chrono::steady_clock;

    /// @param is_on without, nothing is measured, but for the profiler
    StepClock(StepReport& report, bool is_on) : report_(report), is_on_(is_on), start_(read()), last_(start_)
    {
#ifdef CAROM_PROFILER_ON
        step_token_ = profile::begin_zone_at(zone_site_of_step(), start_);
#endif
    }
    StepClock(const StepClock&) = delete;
    StepClock& operator=(const StepClock&) = delete;
    /// The end of the step.
    ~StepClock()
    {
        const Clock::time_point now = read();
        report_.seconds += std::chrono::duration<double>(now - start_).count();
#ifdef CAROM_PROFILER_ON
        profile::end_zone_at(zone_site_of_step(), step_token_, now);
#endif
    }

    /// What is done between two stages counts for neither.
    void leave_out() { last_ = read(); }

    /// A stage, from where the last one ended to the end of this object's life.
    class Zone
    {
    public:
        Zone(StepClock& clock, Stage stage) : clock_(clock), stage_(stage)
        {
#ifdef CAROM_PROFILER_ON
            token_ = profile::begin_zone_at(zone_site_of(stage), clock.last_);
#endif
        }
        Zone(const Zone&) = delete;
        Zone& operator=(const Zone&) = delete;
        ~Zone()
        {
            const Clock::time_point now = clock_.read();
            clock_.report_.stage_seconds[static_cast<std::size_t>(stage_)] += std::chrono::duration<double>(now - clock_.last_).count();
            clock_.last_ = now;
#ifdef CAROM_PROFILER_ON
            profile::end_zone_at(zone_site_of(stage_), token_, now);
#endif
        }

    private:
        StepClock& clock_;
        Stage stage_;
#ifdef CAROM_PROFILER_ON
        std::uint64_t token_;
#endif
    };

private:
    Clock::time_point read() const
    {
#ifdef CAROM_PROFILER_ON
        return Clock::now();
#else
        return is_on_ ? Clock::now() : Clock::time_point();
#endif
    }

    StepReport& report_;
    bool is_on_;
    Clock::time_point start_;
    Clock::time_point last_;
#ifdef CAROM_PROFILER_ON
    std::uint64_t step_token_;
#endif
};

/// Marks the end of a step and plots what its report counts.
inline void plot_step([[maybe_unused]] const StepReport& report)
{
    CAROM_PLOT("bodies", report.bodies);
    CAROM_PLOT("awake bodies", report.awake_bodies);
    CAROM_PLOT("contacts", report.contacts);
    CAROM_PLOT("pairs", report.pairs);
    CAROM_PLOT("islands awake", report.islands);
    CAROM_PLOT("bytes in use", report.memory.total.bytes);
    CAROM_FRAME;
}

} // namespace carom::detail
