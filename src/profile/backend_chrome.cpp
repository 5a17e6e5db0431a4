// The back end `chrome`: the process's one recorder.
#include "profile/backend.hpp"
#include "profile/chrome_trace.hpp"

#include <cstddef>
#include <new>

namespace carom
{

namespace profile
{

namespace
{

using Clock = ChromeTrace::Clock;

/// Never destroyed, so that events may come until the process ends.
ChromeTrace& recorder()
{
    alignas(ChromeTrace) static std::byte place[sizeof(ChromeTrace)];
    static ChromeTrace* const only = new (place) ChromeTrace;
    return *only;
}

} // namespace

std::uint64_t begin_zone_at(const ZoneSite&, Clock::time_point now) { return static_cast<std::uint64_t>(now.time_since_epoch().count()); }

void end_zone_at(const ZoneSite& site, std::uint64_t token, Clock::time_point now)
{
    recorder().add_zone(site.name, Clock::time_point(Clock::duration(static_cast<Clock::rep>(token))), now);
}

std::uint64_t begin_zone(const ZoneSite& site) { return recorder().is_recording() ? begin_zone_at(site, Clock::now()) : 0; }

void end_zone(const ZoneSite& site, std::uint64_t token)
{
    if (recorder().is_recording()) end_zone_at(site, token, Clock::now());
}

void mark_frame() { recorder().add_frame(); }

void plot(const char* name, double value) { recorder().add_plot(name, value); }

void allocated(const void* pointer, std::size_t bytes, const char* pool) { recorder().add_block(pointer, bytes, pool); }

void freed(const void* pointer, const char*) { recorder().remove_block(pointer); }

void name_thread(const char* name) { recorder().name_thread(name); }

} // namespace profile

Profiler profiler() { return Profiler::Chrome; }

TraceResult start_trace(const TraceOptions& options)
{
    profile::recorder().start(options);
    return {.is_done = true};
}

TraceResult write_trace(const std::string& path) { return profile::recorder().write(path); }

} // namespace carom
