// Results as JSON, and where they come from.
#include "lab/results.hpp"

#include "lab/build_info.hpp"
#include "lab/results_json.hpp"

#include <carom/version.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/utsname.h>
#include <thread>

namespace carom::lab
{

using nlohmann::ordered_json;

namespace
{

constexpr int format_version = 1;
constexpr const char* file_name = "results.json";

constexpr std::array outcome_names = {"done", "missing", "can't", "failed"};

Outcome outcome_named(const std::string& name)
{
    const auto place = std::find(outcome_names.begin(), outcome_names.end(), name);
    if (place == outcome_names.end()) throw std::runtime_error("outcome \"" + name + "\" is not known");
    return static_cast<Outcome>(place - outcome_names.begin());
}

ordered_json json_of(const EngineResult& e)
{
    ordered_json json = {{"engine", e.engine},           {"version", e.version}, {"outcome", name_of(e.outcome)}, {"reason", e.reason},
                         {"differences", e.differences}, {"run_ms", e.run_ms},   {"event_ms", e.event_ms},        {"ray_ms", e.ray_ms},
                         {"curve_ms", e.curve_ms},       {"quality", e.quality}};
    if (e.ray_hits) json["ray_hits"] = *e.ray_hits;
    return json;
}

ordered_json json_of(const CaseResult& c)
{
    ordered_json engines = ordered_json::array();
    for (const EngineResult& engine : c.engines) engines.push_back(json_of(engine));
    return {{"suite", c.suite}, {"scene", c.scene},     {"what", c.what},    {"bodies", c.bodies},
            {"steps", c.steps}, {"threads", c.threads}, {"engines", engines}};
}

Origin origin_from(const ordered_json& j)
{
    return {j.at("date"),     j.at("processor"), j.at("cores"),  j.at("system"),
            j.at("compiler"), j.at("flags"),     j.at("commit"), j.at("version")};
}

EngineResult engine_from(const ordered_json& j)
{
    EngineResult e;
    j.at("engine").get_to(e.engine);
    j.at("version").get_to(e.version);
    e.outcome = outcome_named(j.at("outcome"));
    j.at("reason").get_to(e.reason);
    j.at("differences").get_to(e.differences);
    j.at("run_ms").get_to(e.run_ms);
    j.at("event_ms").get_to(e.event_ms);
    j.at("ray_ms").get_to(e.ray_ms);
    if (j.contains("ray_hits")) e.ray_hits = j.at("ray_hits").get<int>();
    j.at("curve_ms").get_to(e.curve_ms);
    j.at("quality").get_to(e.quality);
    return e;
}

CaseResult case_from(const ordered_json& j)
{
    CaseResult c;
    j.at("suite").get_to(c.suite);
    j.at("scene").get_to(c.scene);
    j.at("what").get_to(c.what);
    j.at("bodies").get_to(c.bodies);
    j.at("steps").get_to(c.steps);
    j.at("threads").get_to(c.threads);
    for (const ordered_json& engine : j.at("engines")) c.engines.push_back(engine_from(engine));
    return c;
}

std::string now_text()
{
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm local{};
    localtime_r(&now, &local);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local);
    return text.data();
}

/// What stands after the colon of the first line that begins with `key`.
std::string value_in(const char* file, const std::string& key)
{
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
    {
        const std::size_t colon = line.find(':');
        if (line.starts_with(key) && colon != std::string::npos && colon + 2 <= line.size()) return line.substr(colon + 2);
    }
    return "unknown";
}

std::string system_name()
{
    utsname name{};
    if (::uname(&name) != 0) return "unknown";
    return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

} // namespace

ordered_json json_of(const Origin& o)
{
    return {{"date", o.date},         {"processor", o.processor}, {"cores", o.cores},   {"system", o.system},
            {"compiler", o.compiler}, {"flags", o.flags},         {"commit", o.commit}, {"version", o.version}};
}

std::string name_of(Outcome outcome) { return outcome_names[static_cast<std::size_t>(outcome)]; }

const EngineResult* CaseResult::find(const std::string& engine) const
{
    const auto place = std::find_if(engines.begin(), engines.end(), [&](const EngineResult& e) { return e.engine == engine; });
    return place == engines.end() ? nullptr : &*place;
}

std::string to_json(const Results& results)
{
    ordered_json cases = ordered_json::array();
    for (const CaseResult& one : results.cases) cases.push_back(json_of(one));
    const ordered_json json = {{"carom_results", format_version},
                               {"origin", json_of(results.origin)},
                               {"suite", results.suite},
                               {"runs", results.runs},
                               {"cases", cases}};
    return json.dump(1) + "\n";
}

Results results_from_json(const std::string& text)
{
    try
    {
        const ordered_json json = ordered_json::parse(text);
        if (json.at("carom_results") != format_version)
            throw std::runtime_error("results of format " + json.at("carom_results").dump() + " can't be read; measure anew");
        Results results;
        results.origin = origin_from(json.at("origin"));
        json.at("suite").get_to(results.suite);
        json.at("runs").get_to(results.runs);
        for (const ordered_json& one : json.at("cases")) results.cases.push_back(case_from(one));
        return results;
    }
    catch (const nlohmann::json::exception& error)
    {
        throw std::runtime_error(std::string("these are no results: ") + error.what());
    }
}

void write_results(const Results& results, const std::filesystem::path& folder)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    const std::filesystem::path file = folder / file_name;
    const std::filesystem::path part = file.string() + ".part";
    {
        std::ofstream out(part);
        out << to_json(results);
        if (!out.flush()) throw std::runtime_error("can't write " + part.string());
    }
    std::filesystem::rename(part, file, error);
    if (error) throw std::runtime_error("can't write " + file.string() + ": " + error.message());
}

Results read_results(const std::filesystem::path& folder)
{
    const std::filesystem::path file = folder / file_name;
    std::ifstream in(file);
    if (!in) throw std::runtime_error("there is no " + file.string() + "; `carom lab run --out " + folder.string() + "` makes it");
    std::ostringstream text;
    text << in.rdbuf();
    try
    {
        return results_from_json(text.str());
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error(file.string() + ": " + error.what());
    }
}

Origin origin_here()
{
    return {.date = now_text(),
            .processor = value_in("/proc/cpuinfo", "model name"),
            .cores = static_cast<int>(std::thread::hardware_concurrency()),
            .system = system_name(),
            .compiler = build_info::compiler,
            .flags = build_info::flags,
            .commit = build_info::commit(),
            .version = CAROM_VERSION};
}

} // namespace carom::lab
