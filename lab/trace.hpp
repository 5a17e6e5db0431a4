// Reads a trace in the trace-event format, and sums up its zones and its memory.
#pragma once

#include <array>
#include <cstdint>
#include <istream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace carom::lab
{

/// A file that is no trace, or a trace without what is asked for. what() names the remedy.
struct TraceError : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// A complete event: a zone from its begin to its end.
struct TraceZone
{
    std::uint32_t name;   ///< in Trace::names
    std::uint32_t thread; ///< numbered in the order in which they first came
    double start_us;
    double duration_us;
};

struct TracePoint
{
    double time_us;
    double value;
};

struct Trace
{
    std::vector<std::string> names;                        ///< of zones, in the order in which they first came
    std::vector<TraceZone> zones;                          ///< by thread, then by start; of equal starts the longest first
    std::map<std::string, std::vector<TracePoint>> plots;  ///< by name; each by time
    std::map<std::string, std::vector<TracePoint>> memory; ///< bytes in use by pool; each by time
    std::vector<double> frames_us;                         ///< ends of frames, ascending
    std::uint64_t dropped = 0;                             ///< events that the recorder had no room for
};

/// Reads a trace whole, however it is ordered; what it does not know it leaves out. Memory is 24 bytes a zone and 16 a number.
/// @throws TraceError for an empty text, one that is no JSON or breaks off, and JSON that holds no trace events
Trace read_trace(std::istream& text);

/// What all zones of one name have taken.
struct ZoneSummary
{
    std::string name;
    std::size_t count = 0;
    double total_us = 0;
    double self_us = 0; ///< without what zones inside of it took
    double mean_us = 0;
    double median_us = 0;
    double p99_us = 0;
};

/// One a name, the greatest total first; equal ones by name.
std::vector<ZoneSummary> summarize_zones(const Trace& trace);

/// A table of the zones: count, mean, median and 99th percentile in microseconds, share of the zone "step", and share that is its own.
/// Without such a zone, shares are of the time from the first zone's start to the last one's end.
/// @throws TraceError when there is no zone
std::string zone_table(const Trace& trace);

} // namespace carom::lab
