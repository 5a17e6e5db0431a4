// Results as JSON, and where they come from.
#include "lab/results.hpp"

#include "files/input_file.hpp"
#include "files/output_file.hpp"
#include "files/text.hpp"
#include "lab/build_info.hpp"
#include "lab/results_json.hpp"

#include <carom/version.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <sys/utsname.h>
#include <thread>

namespace carom::lab
{

using nlohmann::ordered_json;

namespace
{

constexpr int format_version = 1;

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
    ordered_json json = {{"suite", c.suite}, {"scene", c.scene},     {"what", c.what},    {"bodies", c.bodies},
                         {"steps", c.steps}, {"threads", c.threads}, {"engines", engines}};
    if (!c.fingerprint.empty()) json["fingerprint"] = c.fingerprint;
    return json;
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
    c.fingerprint = j.value("fingerprint", "");
    if (c.scene.empty()) throw std::runtime_error("a case does not say of which scene it is");
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

std::string lack_of(const Results& results)
{
    const auto has = [](const CaseResult& one, Outcome outcome)
    {
        const auto is_it = [&](const EngineResult& engine) { return engine.outcome == outcome; };
        return std::any_of(one.engines.begin(), one.engines.end(), is_it);
    };
    std::string lack;
    bool has_any = false;
    for (const CaseResult& one : results.cases)
    {
        const bool is_done = has(one, Outcome::Done);
        has_any = has_any || is_done;
        if (is_done || !has(one, Outcome::Failed)) continue;
        lack += (lack.empty() ? "no engine finished " : "; ") + one.scene;
        for (const EngineResult& engine : one.engines) lack += ", " + engine.engine + ": " + engine.reason;
    }
    return lack.empty() && !has_any ? "no engine finished any scene" : lack;
}

const EngineResult* CaseResult::find(const std::string& engine) const
{
    const auto place = std::find_if(engines.begin(), engines.end(), [&](const EngineResult& e) { return e.engine == engine; });
    return place == engines.end() ? nullptr : &*place;
}

std::string to_json(const Results& results)
{
    ordered_json cases = ordered_json::array();
    for (const CaseResult& one : results.cases) cases.push_back(json_of(one));
    ordered_json programs = ordered_json::array();
    for (const EngineProgram& engine : results.engines) programs.push_back({{"name", engine.name}, {"fingerprint", engine.fingerprint}});
    const ordered_json json = {{"carom_results", format_version},
                               {"origin", json_of(results.origin)},
                               {"suite", results.suite},
                               {"runs", results.runs},
                               {"engines", programs},
                               {"cases", cases}};
    return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n"; // what programs said need not be UTF-8
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
        for (const ordered_json& one : json.value("engines", ordered_json::array()))
            results.engines.push_back({.name = one.at("name"), .fingerprint = one.at("fingerprint")});
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
    if (error) throw std::runtime_error("can't make the folder " + files::quoted(folder) + ": " + error.message());
    files::write_file("", folder / results_file_name, to_json(results));
}

Results read_results(const std::filesystem::path& folder)
{
    const std::filesystem::path file = folder / results_file_name;
    constexpr std::size_t most_bytes = std::size_t{1} << 30;
    std::string text;
    try
    {
        text = files::read_text(file, most_bytes);
    }
    catch (const files::CannotRead& error)
    {
        throw std::runtime_error(std::string(error.what()) + "; `carom lab run --out DIR` writes results");
    }
    try
    {
        return results_from_json(text);
    }
    catch (const std::runtime_error& error)
    {
        throw std::runtime_error(files::quoted(file) + ": " + error.what());
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
