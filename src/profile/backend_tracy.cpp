// The back end `tracy`: hands everything to the Tracy client. The only file that knows it.
#include "profile/backend.hpp"

#include <bit>
#include <cmath>
#include <cstddef>
#include <tracy/TracyC.h>

namespace carom
{

namespace profile
{

namespace
{

// Tracy keeps the address of a zone's site, and reads it as its own type.
using TracySite = ___tracy_source_location_data;
static_assert(sizeof(ZoneSite) == sizeof(TracySite) && alignof(ZoneSite) == alignof(TracySite));
static_assert(offsetof(ZoneSite, name) == offsetof(TracySite, name) && offsetof(ZoneSite, function) == offsetof(TracySite, function));
static_assert(offsetof(ZoneSite, file) == offsetof(TracySite, file) && offsetof(ZoneSite, line) == offsetof(TracySite, line));
static_assert(offsetof(ZoneSite, color) == offsetof(TracySite, color));
static_assert(sizeof(TracyCZoneCtx) == sizeof(std::uint64_t));

} // namespace

std::uint64_t begin_zone(const ZoneSite& site)
{
    return std::bit_cast<std::uint64_t>(___tracy_emit_zone_begin(reinterpret_cast<const TracySite*>(&site), 1));
}

void end_zone(const ZoneSite&, std::uint64_t token) { ___tracy_emit_zone_end(std::bit_cast<TracyCZoneCtx>(token)); }

// Tracy reads a clock of its own.
std::uint64_t begin_zone_at(const ZoneSite& site, std::chrono::steady_clock::time_point) { return begin_zone(site); }
void end_zone_at(const ZoneSite& site, std::uint64_t token, std::chrono::steady_clock::time_point) { end_zone(site, token); }

void mark_frame() { ___tracy_emit_frame_mark(nullptr); }

void plot(const char* name, double value)
{
    if (std::isfinite(value)) ___tracy_emit_plot(name, value);
}

void allocated(const void* pointer, std::size_t bytes, const char* pool) { ___tracy_emit_memory_alloc_named(pointer, bytes, 0, pool); }

void freed(const void* pointer, const char* pool) { ___tracy_emit_memory_free_named(pointer, 0, pool); }

void name_thread(const char* name) { ___tracy_set_thread_name(name); }

} // namespace profile

Profiler profiler() { return Profiler::Tracy; }

TraceResult start_trace(const TraceOptions&) { return {.problem = profile::no_chrome_back_end}; }

TraceResult write_trace(const std::string&) { return {.problem = profile::no_chrome_back_end}; }

} // namespace carom
