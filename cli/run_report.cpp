// The JSON object and the table of a run.
#include "cli/run_report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#ifndef CAROM_BUILD_TYPE // the build gives its own name for it
#ifdef NDEBUG
#define CAROM_BUILD_TYPE "Release"
#else
#define CAROM_BUILD_TYPE "Debug"
#endif
#endif

namespace carom::cli
{

using nlohmann::ordered_json;

namespace
{

struct NamedCount
{
    const char* name;
    std::uint64_t count;
};

std::array<NamedCount, 6> named_counts(const lab::EventCounts& events)
{
    return {{{"contact_begin", events.contact_begin},
             {"contact_persist", events.contact_persist},
             {"contact_end", events.contact_end},
             {"sensor_begin", events.sensor_begin},
             {"sensor_persist", events.sensor_persist},
             {"sensor_end", events.sensor_end}}};
}

template <class... Values>
std::string formatted(const char* format, Values... values)
{
    std::array<char, 256> buffer;
    std::snprintf(buffer.data(), buffer.size(), format, values...);
    return buffer.data();
}

std::string bytes_text(std::size_t bytes)
{
    const auto size = static_cast<double>(bytes);
    if (bytes < 10 * 1024) return std::to_string(bytes) + " bytes";
    return bytes < 10 * 1024 * 1024 ? formatted("%.1f KiB", size / 1024) : formatted("%.1f MiB", size / (1024 * 1024));
}

std::string parameter_lines(const scenes::Scene& scene)
{
    std::string lines;
    for (const scenes::ParameterInfo& info : scene.parameters().infos())
    {
        const scenes::ParameterValue& value = scene.parameters().value(info.name);
        if (value == info.initial) continue;
        lines += formatted("  %-22s %s %s\n", info.name.c_str(), scenes::to_text(value).c_str(), info.unit.c_str());
    }
    return lines.empty() ? "" : "\nparameters that are not at their default\n" + lines;
}

std::string event_lines(const lab::EventCounts& events)
{
    std::string lines;
    for (const NamedCount& event : named_counts(events))
    {
        if (event.count > 0) lines += formatted("  %-22s %12llu\n", event.name, static_cast<unsigned long long>(event.count));
    }
    return lines.empty() ? "" : "\nevents in the whole run\n" + lines;
}

/// The stages with their share of the step, as bars.
std::string stage_lines(const lab::RunResult& result)
{
    std::string lines = formatted("\n%-24s %12s %7s\n", "stage", "mean ms", "share");
    for (std::size_t i = 0; i < stage_count; ++i)
    {
        const double share = result.step_ms.mean > 0 ? result.stage_ms[i] / result.step_ms.mean : 0;
        const auto bar = static_cast<std::size_t>(std::clamp(40 * share, 0.0, 40.0));
        const std::string name(name_of(static_cast<Stage>(i)));
        lines += formatted("  %-22s %12.4f %6.1f%%  %s\n", name.c_str(), result.stage_ms[i], 100 * share, std::string(bar, '#').c_str());
    }
    return lines;
}

} // namespace

std::string compiler_name()
{
#if defined(__clang__)
    return formatted("clang %d.%d.%d", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
    return formatted("gcc %d.%d.%d", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
    return "unknown";
#endif
}

std::string build_type() { return CAROM_BUILD_TYPE; }

std::string hash_text(std::uint64_t hash) { return formatted("%016llx", static_cast<unsigned long long>(hash)); }

ordered_json run_json(const scenes::Scene& scene, const lab::RunResult& result)
{
    ordered_json json;
    json["scene"] = scene.info().name;
    for (const auto& [name, value] : scene.parameters().values())
        std::visit([&, &key = name](const auto& plain) { json["parameters"][key] = plain; }, value);
    json["seed"] = scene.seed();
    json["steps"] = result.steps;
    json["broad_phase"] = name_of(scene.world().broad_phase());
    const BroadPhaseStats& search = result.last.broad_phase;
    json["broad_phase_stats"] = {{"pairs_tested", search.pairs_tested}, {"pairs_found", search.pairs_found}, {"nodes", search.nodes}};
    json["bodies"] = result.last.bodies;
    json["shapes"] = result.last.shapes;
    json["pairs"] = result.last.pairs;
    json["contacts"] = result.last.contacts;
    for (const NamedCount& event : named_counts(result.events)) json["events"][event.name] = event.count;
    json["quarantined"] = result.quarantined;
    json["contact_hertz"] = result.last.contact_hertz;
    json["too_long_steps"] = result.too_long_steps;
    json["step_ms"] = {
        {"mean", result.step_ms.mean}, {"median", result.step_ms.median}, {"p99", result.step_ms.p99}, {"max", result.step_ms.max}};
    for (std::size_t i = 0; i < stage_count; ++i) json["stage_ms"][std::string(name_of(static_cast<Stage>(i)))] = result.stage_ms[i];
    json["hash"] = hash_text(result.hash);
    json["memory"] = {{"bytes", result.last.memory.total.bytes},
                      {"peak_bytes", result.last.memory.total.peak_bytes},
                      {"heap_allocations_per_step", result.heap_allocations_per_step}};
    for (std::size_t i = 0; i < memory_category_count; ++i)
    {
        const MemoryStats& part = result.last.memory.categories[i];
        json["memory"]["categories"][std::string(name_of(static_cast<MemoryCategory>(i)))] = {{"bytes", part.bytes},
                                                                                              {"peak_bytes", part.peak_bytes}};
    }
    json["version"] = CAROM_VERSION;
    json["compiler"] = compiler_name();
    json["build_type"] = build_type();
    return json;
}

std::string run_table(const scenes::Scene& scene, const lab::RunResult& result)
{
    const lab::Summary& step = result.step_ms;
    const std::string broad_phase(name_of(scene.world().broad_phase()));
    const std::string rate = scenes::to_text(scene.parameters().value("step_rate"));
    std::string text = scene.info().name + ": " + scene.info().title + "\n";
    text += formatted("  %d steps at %s Hz, seed %llu, broad phase %s\n", result.steps, rate.c_str(),
                      static_cast<unsigned long long>(scene.seed()), broad_phase.c_str());
    text += "  carom " CAROM_VERSION ", " + compiler_name() + ", " + build_type() + "\n";
    text += parameter_lines(scene);
    text += formatted("\nat the end\n  %-22s %12d\n  %-22s %12d\n", "bodies", result.last.bodies, "shapes", result.last.shapes);
    text += formatted("  %-22s %12d\n  %-22s %12d\n", "pairs", result.last.pairs, "contacts", result.last.contacts);
    if (result.quarantined > 0) text += formatted("  %-22s %12llu\n", "quarantined", static_cast<unsigned long long>(result.quarantined));
    if (result.too_long_steps > 0)
        text += formatted("  %-22s %12d  contacts are softer than tuned: piles may sink; raise substeps or step_rate\n", "too long steps",
                          result.too_long_steps);
    text += event_lines(result.events);
    text += formatted("\n%-24s %12s %12s %12s %12s\n", "time of a step", "mean ms", "median", "p99", "max");
    text += formatted("  %-22s %12.4f %12.4f %12.4f %12.4f\n", "step", step.mean, step.median, step.p99, step.max);
    text += stage_lines(result);
    text += "\nmemory\n";
    text += formatted("  %-22s %s, at most %s\n", "of the world", bytes_text(result.last.memory.total.bytes).c_str(),
                      bytes_text(result.last.memory.total.peak_bytes).c_str());
    for (std::size_t i = 0; i < memory_category_count; ++i)
    {
        const MemoryStats& part = result.last.memory.categories[i];
        if (part.peak_bytes == 0) continue;
        text += formatted("    %-20s %s, at most %s\n", std::string(name_of(static_cast<MemoryCategory>(i))).c_str(),
                          bytes_text(part.bytes).c_str(), bytes_text(part.peak_bytes).c_str());
    }
    text += formatted("  %-22s %g\n", "heap allocations/step", result.heap_allocations_per_step);
    text += "\nhash of the world        " + hash_text(result.hash) + "\n";
    return text;
}

} // namespace carom::cli
