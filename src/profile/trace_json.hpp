// A recording as a file in the trace-event format.
#pragma once

#include "profile/thread_log.hpp"

#include <cstdint>
#include <span>
#include <string>

namespace carom::profile
{

/// What one thread has recorded.
struct ThreadEvents
{
    std::uint32_t number = 0;
    const char* name = nullptr; ///< or null
    EventList events;
};

/// Writes one JSON object that chrome://tracing and ui.perfetto.dev open: complete events (X) for zones, counters (C) for plots and,
/// in the category "memory", for pools, instants (i) for frames, metadata (M) for names.
/// @param start_ns becomes time 0; earlier zones are left out
/// @return what went wrong, as the system tells it; empty when the whole file is written
std::string write_trace_json(const std::string& path, std::span<const ThreadEvents> threads, std::int64_t start_ns, std::uint64_t dropped);

} // namespace carom::profile
