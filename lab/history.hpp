// The story of the engine that Carom began as, measured again: from every pair to a tree, each step with the tests that its author made and those
// that he should have made.
#pragma once

#include "lab/comparison.hpp"
#include "lab/experiment.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace carom::lab
{

/// One version of the search for pairs.
struct Chapter
{
    std::string name;
    std::vector<double> run_ms;   ///< of each run the mean time a step [ms]
    std::vector<double> frame_ms; ///< of every step of the last run [ms]
    double find_pairs_ms = 0;     ///< mean of a step
    double pairs_tested = 0;      ///< mean of a step
    double memory_bytes = 0;      ///< the most that the world held
    double allocations = 0;       ///< of a step, once the world is warm
};

struct History
{
    Origin origin;
    std::string scene;
    int steps = 0;
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
};

/// @throws std::runtime_error when a run fails
History run_history(const HistoryPlan& plan, const std::function<void(const Progress&)>& tell = {});

/// The table of versions, and between neighbours the tests: Student's t of the frames of one run each, as the author did it, though frames of one run
/// are correlated; and of runs Welch's t, the rank test and the bootstrap.
std::string history_text(const History& history);

} // namespace carom::lab
