// The story of the engine that Carom began as, measured again: from every pair to a tree, each change with the tests that its author made and those
// that he should have made.
#pragma once

#include "lab/comparison.hpp"
#include "lab/experiment.hpp"

#include <carom/broad_phase.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace carom::lab
{

/// One version of the search for pairs. A frame is a step and the drawing of its picture.
struct Chapter
{
    std::string name;
    std::string what; ///< a sentence
    BroadPhaseType broad_phase = BroadPhaseType::Tree;
    std::vector<std::vector<double>> frames_ms = {}; ///< of each run every frame [ms]
    std::vector<double> frame_ms = {};               ///< of each run the mean of its frames [ms]
    std::vector<double> step_ms = {};                ///< of each run the mean of its steps [ms]
    std::vector<double> find_pairs_ms = {};          ///< of each run the mean of a step's search for pairs [ms]
    double pairs_tested = 0;                         ///< mean of a step
    double memory_bytes = 0;                         ///< the most that the world held
    double allocations = 0;                          ///< of a step, once the world is warm
};

struct History
{
    Origin origin;
    std::string scene;
    int steps = 0;
    double seconds = 0; ///< of simulated time
    int runs = 0;
    std::vector<Chapter> chapters; ///< from the first version to the last
};

struct HistoryPlan
{
    int size = 500;  ///< circles, and as many boxes
    int steps = 600; ///< ten seconds at 60 Hz
    int runs = 5;
    std::filesystem::path carom;   ///< the program
    std::filesystem::path scratch; ///< a folder
    std::function<bool()> is_interrupted = {};
};

/// @throws std::runtime_error when a run fails, or the plan is interrupted
History run_history(const HistoryPlan& plan, const std::function<void(const Progress&)>& tell = {});

/// What a version changed over the one before it.
struct Change
{
    TTest frames_of_one_run; ///< Student's, as the author did it, though frames of one run are correlated
    Comparison frames;       ///< of runs
    Comparison steps;        ///< of runs: the physics alone
};
/// @param after from 1: the number of the later version
Change change_to(const History& history, std::size_t after);

/// The author's test between two runs of one version, where there is nothing to find.
struct FalseAlarms
{
    int pairs = 0; ///< of runs, over all versions
    int found = 0; ///< pairs in which it tells of a difference, with p < 0.05
};
FalseAlarms false_alarms(const History& history);

/// The table of versions, what they are, and the tests between neighbours.
std::string history_text(const History& history);
std::string history_markdown(const History& history);
/// The same, with every frame.
std::string history_json(const History& history);

} // namespace carom::lab
