// Runs engines on scenes, in turns, and gathers what they tell.
#pragma once

#include "lab/engine_run.hpp"
#include "lab/results.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace carom::lab
{

/// A program that takes the arguments of lab/engine_run.hpp.
struct Engine
{
    std::string name;
    std::vector<std::string> command; ///< the program and what stands before the scene's file; empty when it is not installed
    std::string missing;              ///< how to get it, when it is not installed
};

struct PlannedCase
{
    std::string suite = {}; ///< that the scene belongs to
    std::string scene;
    std::string what;
    int bodies = 0;
    int steps = 0;
    int threads = 1;
    int samples = 10; ///< moments at which engines tell where the bodies are
    std::filesystem::path file;
    std::string fingerprint = {}; ///< of the file
};

struct Plan
{
    std::string suite;
    std::vector<PlannedCase> cases;
    std::vector<Engine> engines;
    std::vector<CaseResult> finished = {};     ///< cases that were measured before and are not measured again
    int runs = 5;                              ///< rounds: in each every engine runs once
    double most_seconds = 600;                 ///< that a run may take
    std::filesystem::path scratch = {};        ///< a folder for the engines' results
    std::function<bool()> is_interrupted = {}; ///< asked again and again during a run, which is ended when it says so
    /// Sees every good run; may be empty.
    std::function<void(const Engine&, const EngineRun&)> on_run = {};
};

/// Where an experiment stands.
struct Progress
{
    int done = 0; ///< runs
    int total = 0;
    double seconds_left = 0; ///< guessed from those that are done; 0 before the first
    std::string now;         ///< "pyramid, carom, run 2 of 5"
};

/// Names and values of what a run was good or bad at, from its samples.
using Evaluator = std::function<std::map<std::string, double>(const PlannedCase&, const EngineRun&)>;

/// The engines with the fingerprints of their programs.
std::vector<EngineProgram> programs_of(const std::vector<Engine>& engines);

/// Rounds over the engines, in another order each time. An engine that fails or can't is not asked again for that case; the others go on. The
/// evaluator sees the last good run of each engine.
/// @param tell      called before every run; what it throws ends the experiment
/// @throws std::runtime_error when the plan is interrupted
/// @param keep_part called with all that is finished, after every case but the last
Results run_experiment(const Plan& plan, const Evaluator& evaluate, const std::function<void(const Progress&)>& tell = {},
                       const std::function<void(const Results&)>& keep_part = {});

} // namespace carom::lab
