// What a run of the laboratory leaves behind, as plain data and as JSON.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace carom::lab
{

/// Where and from what the measurements come.
struct Origin
{
    std::string date;      ///< "2026-03-21 14:05", local
    std::string processor; ///< as it calls itself
    int cores = 0;         ///< that the program may use
    std::string system;    ///< name and version of the operating system
    std::string compiler;
    std::string flags;
    std::string commit; ///< of Carom's repository, with a + when something was changed since; empty when there is none
    std::string version;
};

/// What became of an engine on a scene.
enum class Outcome
{
    Done,
    Missing, ///< it is not installed
    CanNot,  ///< it lacks something that the scene needs
    Failed   ///< it crashed, hung, or gave nonsense
};

/// One engine on one scene with one number of threads.
struct EngineResult
{
    std::string engine;
    std::string version;
    Outcome outcome = Outcome::Done;
    std::string reason;                   ///< why it is not done
    std::vector<std::string> differences; ///< in which its settings are not those of the others
    /// Of each run the mean time a step, in the order of the rounds: the engine's step, what the scene's events ask for before it, and its rays [ms].
    std::vector<double> run_ms;
    double event_ms = 0;              ///< the share of the events, median over the runs [ms]
    double ray_ms = 0;                ///< the share of the rays
    std::optional<int> ray_hits = {}; ///< rays that met something after the last step
    std::vector<double> curve_ms;     ///< time a step over the course of the run: means of equal parts, medians over the runs [ms]
    /// By name, each with its unit in it: "deepest_penetration_m", ...
    std::map<std::string, double> quality;
};

/// What ran as an engine.
struct EngineProgram
{
    std::string name;
    std::string fingerprint; ///< of the program's bytes; empty when it is not installed
};

struct CaseResult
{
    std::string suite = {}; ///< that the scene belongs to, also when it was measured as part of another one
    std::string scene;
    std::string what;
    int bodies = 0; ///< that the file holds
    int steps = 0;
    int threads = 1;
    std::vector<EngineResult> engines;
    std::string fingerprint = {}; ///< of the scene file; empty in results of older versions

    const EngineResult* find(const std::string& engine) const;
};

struct Results
{
    Origin origin;
    std::string suite;
    int runs = 0; ///< rounds that were asked for
    std::vector<CaseResult> cases;
    std::vector<EngineProgram> engines = {}; ///< in the order in which they were asked for; empty in results of older versions
};

/// Why the results are no measurement: the scenes on which some engine failed and none was done, with the reasons, or that no engine was
/// done on any. Empty when they are one.
std::string lack_of(const Results& results);

/// "done", "missing", "can't", "failed".
std::string name_of(Outcome outcome);

std::string to_json(const Results& results);
/// @throws std::runtime_error saying what is wrong with the text
Results results_from_json(const std::string& text);

/// Of the file of results in its folder.
inline constexpr const char* results_file_name = "results.json";

/// @throws std::runtime_error naming the file
void write_results(const Results& results, const std::filesystem::path& folder);
/// Reads what write_results wrote into a folder.
Results read_results(const std::filesystem::path& folder);

/// Of this machine and this build.
Origin origin_here();

} // namespace carom::lab
