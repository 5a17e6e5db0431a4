// Measures a step and its stages into its report, and marks both as zones for the profiler. One reading of the clock serves both.
#pragma once

#include "profile/backend.hpp"

#include <carom/report.hpp>

#include <chrono>

namespace carom::detail
{

const profile::ZoneSite& zone_site_of(Stage stage);
const profile::ZoneSite& zone_site_of_step();

/// Adds the time of its life to a number of seconds; a zone of the same life when there is a profiler.
class TimedZone
{
public:
    using Clock = std::chrono::steady_clock;

    TimedZone(const TimedZone&) = delete;
    TimedZone& operator=(const TimedZone&) = delete;

protected:
#ifdef CAROM_PROFILER_ON
    TimedZone(double& seconds, const profile::ZoneSite& site)
        : seconds_(seconds),
          start_(Clock::now()),
          site_(site),
          token_(profile::begin_zone_at(site, start_))
    {
    }
    ~TimedZone()
    {
        const Clock::time_point now = Clock::now();
        seconds_ += std::chrono::duration<double>(now - start_).count();
        profile::end_zone_at(site_, token_, now);
    }
#else
    TimedZone(double& seconds, const profile::ZoneSite&) : seconds_(seconds), start_(Clock::now()) {}
    ~TimedZone() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
#endif

private:
    double& seconds_;
    Clock::time_point start_;
#ifdef CAROM_PROFILER_ON
    const profile::ZoneSite& site_;
    std::uint64_t token_;
#endif
};

/// A stage. There are several of one stage in a step: one a substep.
class StageTimer : TimedZone
{
public:
    StageTimer(StepReport& report, Stage stage) : TimedZone(report.stage_seconds[static_cast<std::size_t>(stage)], zone_site_of(stage)) {}
};

/// The whole step.
class StepTimer : TimedZone
{
public:
    explicit StepTimer(StepReport& report) : TimedZone(report.seconds, zone_site_of_step()) {}
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
