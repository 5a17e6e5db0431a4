// Takes events one by one as the parser meets them, so that a large trace is never in memory as JSON.
#include "lab/trace.hpp"

#include "lab/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace carom::lab
{

using nlohmann::json;

namespace
{

constexpr const char* zone_of_step = "step";
constexpr std::string_view before_pool = "memory: "; // in the names of counters of memory

/// Adds events to a trace.
class Collector
{
public:
    explicit Collector(Trace& trace) : trace_(trace) {}

    std::size_t events() const { return events_; }

    void add(const json& event)
    {
        const std::string phase = text_of(event, "ph");
        if (phase.empty()) return;
        ++events_;
        if (phase == "X") add_zone(event);
        if (phase == "C") add_counters(event);
        if (phase == "i" && text_of(event, "name") == "frame") trace_.frames_us.push_back(number_of(event, "ts"));
    }

private:
    static std::string text_of(const json& event, const char* key)
    {
        const auto value = event.find(key);
        return value != event.end() && value->is_string() ? value->get<std::string>() : std::string();
    }

    /// Most viewers also take numbers in quotes; Carom's recorder writes none.
    double number_of(const json& event, const char* key) const
    {
        const auto value = event.find(key);
        if (value != event.end() && value->is_number()) return value->get<double>();
        throw TraceError("event " + std::to_string(events_) + " of the trace, \"" + text_of(event, "name") + "\", has no number \"" + key +
                         "\"; record the trace anew");
    }

    void add_zone(const json& event)
    {
        const std::string name = text_of(event, "name");
        const auto [place, is_new] = name_index_.try_emplace(name, static_cast<std::uint32_t>(trace_.names.size()));
        if (is_new) trace_.names.push_back(name);
        const double thread = event.contains("tid") ? number_of(event, "tid") : 0;
        const auto thread_index = threads_.try_emplace(thread, static_cast<std::uint32_t>(threads_.size())).first->second;
        trace_.zones.push_back({place->second, thread_index, number_of(event, "ts"), number_of(event, "dur")});
    }

    void add_counters(const json& event)
    {
        const auto arguments = event.find("args");
        if (arguments == event.end() || !arguments->is_object() || arguments->empty()) return;
        const json& value = arguments->begin().value();
        if (!value.is_number()) return;
        const bool is_memory = text_of(event, "cat") == "memory";
        std::string name = text_of(event, "name");
        if (is_memory && name.starts_with(before_pool)) name.erase(0, before_pool.size());
        (is_memory ? trace_.memory : trace_.plots)[name].push_back({number_of(event, "ts"), value.get<double>()});
    }

    Trace& trace_;
    std::size_t events_ = 0;
    std::unordered_map<std::string, std::uint32_t> name_index_; // only looked up
    std::map<double, std::uint32_t> threads_;                   // by what the trace calls them
};

/// By time; those of one moment stay as they are.
void sort(std::vector<TracePoint>& points)
{
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return std::tuple(points[a].time_us, a) < std::tuple(points[b].time_us, b); });
    std::vector<TracePoint> sorted;
    sorted.reserve(points.size());
    for (const std::size_t i : order) sorted.push_back(points[i]);
    points = std::move(sorted);
}

void sort(Trace& trace)
{
    std::sort(trace.zones.begin(), trace.zones.end(), [](const TraceZone& a, const TraceZone& b)
    { return std::tuple(a.thread, a.start_us, -a.duration_us) < std::tuple(b.thread, b.start_us, -b.duration_us); });
    for (auto* counters : {&trace.plots, &trace.memory})
        for (auto& [name, points] : *counters) sort(points);
    std::sort(trace.frames_us.begin(), trace.frames_us.end());
}

/// The time of each zone without the zones inside of it. Zones of a thread are nested, but for the rounding of their times.
std::vector<double> self_times(const Trace& trace)
{
    std::vector<double> self;
    std::vector<std::size_t> open;
    self.reserve(trace.zones.size());
    for (std::size_t i = 0; i < trace.zones.size(); ++i)
    {
        const TraceZone& zone = trace.zones[i];
        self.push_back(zone.duration_us);
        const auto has_ended = [&](std::size_t outer)
        {
            const TraceZone& o = trace.zones[outer];
            return o.thread != zone.thread || o.start_us + o.duration_us < zone.start_us + 0.5 * zone.duration_us;
        };
        while (!open.empty() && has_ended(open.back())) open.pop_back();
        if (!open.empty()) self[open.back()] -= zone.duration_us;
        open.push_back(i);
    }
    return self;
}

double time_covered(const Trace& trace)
{
    double first = INFINITY;
    double last = -INFINITY;
    for (const TraceZone& zone : trace.zones)
    {
        first = std::min(first, zone.start_us);
        last = std::max(last, zone.start_us + zone.duration_us);
    }
    return last - first;
}

template <class... Values>
std::string formatted(const char* format, Values... values)
{
    std::array<char, 256> buffer;
    std::snprintf(buffer.data(), buffer.size(), format, values...);
    return buffer.data();
}

} // namespace

Trace read_trace(std::istream& text)
{
    Trace trace;
    Collector collector(trace);
    // An event is an element of an array that is the whole text or the member "traceEvents" of the object that is the whole text. What
    // has been looked at is dropped.
    bool is_array = false;
    std::string key;
    const auto look = [&](int depth, json::parse_event_t event, json& parsed)
    {
        using Event = json::parse_event_t;
        if (depth == 0 && event == Event::array_start) is_array = true;
        if (depth == 1 && !is_array && event == Event::key) key = parsed.get<std::string>();
        const bool is_event = event == Event::object_end && depth == (is_array ? 1 : 2) && (is_array || key == "traceEvents");
        if (is_event) collector.add(parsed);
        return !is_event;
    };
    try
    {
        if (text.peek() == std::istream::traits_type::eof()) throw TraceError("the file is empty; record a trace into it");
        const json rest = json::parse(text, look);
        const json::json_pointer dropped("/otherData/dropped_events");
        if (rest.is_object() && rest.contains(dropped) && rest[dropped].is_number_unsigned()) trace.dropped = rest[dropped];
    }
    catch (const json::exception& error)
    {
        throw TraceError("not a whole JSON text: " + std::string(error.what()) + "; record the trace anew");
    }
    if (collector.events() == 0) throw TraceError("JSON without trace events; give a file that `carom run SCENE --trace FILE` wrote");
    sort(trace);
    return trace;
}

std::vector<ZoneSummary> summarize_zones(const Trace& trace)
{
    const std::vector<double> self = self_times(trace);
    std::vector<ZoneSummary> summaries(trace.names.size());
    std::vector<std::vector<double>> times(trace.names.size());
    for (std::size_t i = 0; i < trace.zones.size(); ++i)
    {
        times[trace.zones[i].name].push_back(trace.zones[i].duration_us);
        summaries[trace.zones[i].name].self_us += self[i];
    }
    for (std::size_t i = 0; i < summaries.size(); ++i)
    {
        const Summary summary = summarize(times[i]);
        ZoneSummary& zone = summaries[i];
        zone.name = trace.names[i];
        zone.count = times[i].size();
        zone.total_us = std::accumulate(times[i].begin(), times[i].end(), 0.0);
        zone.mean_us = summary.mean;
        zone.median_us = summary.median;
        zone.p99_us = summary.p99;
    }
    std::sort(summaries.begin(), summaries.end(),
              [](const ZoneSummary& a, const ZoneSummary& b) { return std::tuple(-a.total_us, a.name) < std::tuple(-b.total_us, b.name); });
    return summaries;
}

std::string zone_table(const Trace& trace)
{
    if (trace.zones.empty()) throw TraceError("the trace holds no zone; record one of a program that steps a world");
    const std::vector<ZoneSummary> zones = summarize_zones(trace);
    const auto step = std::find_if(zones.begin(), zones.end(), [](const ZoneSummary& zone) { return zone.name == zone_of_step; });
    const double whole = step != zones.end() ? step->total_us : time_covered(trace);
    const double percent = whole > 0 ? 100 / whole : 0;
    std::string text = formatted("%-22s %9s %10s %10s %10s %7s %7s\n", "zone", "count", "mean us", "median", "p99",
                                 step != zones.end() ? "of step" : "of time", "its own");
    for (const ZoneSummary& zone : zones)
        text += formatted("%-22.60s %9zu %10.3f %10.3f %10.3f %6.1f%% %6.1f%%\n", zone.name.c_str(), zone.count, zone.mean_us,
                          zone.median_us, zone.p99_us, percent * zone.total_us, percent * zone.self_us);
    return text;
}

} // namespace carom::lab
