// Whether the laboratory can be trusted on this machine: the same program against itself must show no difference, and against itself slowed down the
// one that was planted.
#pragma once

#include "lab/comparison.hpp"
#include "lab/experiment.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace carom::lab
{

struct SelfCheckPlan
{
    PlannedCase scene;
    int tries = 20;                ///< comparisons of the program with itself
    int runs = 10;                 ///< of each side in a comparison
    double slowdown = 0.05;        ///< that is planted: the share by which every step takes longer
    std::filesystem::path carom;   ///< the program
    std::filesystem::path scratch; ///< a folder
    std::function<bool()> is_interrupted = {};
};

struct SelfCheck
{
    Origin origin;
    SelfCheckPlan plan;
    std::vector<Comparison> same; ///< of each try
    Comparison planted;           ///< the slowed one as B

    int false_alarms() const;
    /// At most one false alarm in 20 tries, and the planted slowdown found.
    bool is_passed() const;
};

/// @throws std::runtime_error when a run fails, or the plan is interrupted
SelfCheck run_self_check(const SelfCheckPlan& plan, const std::function<void(const Progress&)>& tell = {});

std::string self_check_text(const SelfCheck& check);

} // namespace carom::lab
