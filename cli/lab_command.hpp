// `carom lab`: measures engines against each other.
#pragma once

#include "cli/program.hpp"

#include <string>
#include <vector>

namespace carom::cli
{

struct LabRunRequest
{
    std::string suite = "quick";
    std::string scenes;        ///< names with commas between; empty for all of the suite
    std::string engines;       ///< names with commas between; empty for those of lab::default_engines
    std::string threads = "1"; ///< numbers with commas between
    int runs = 5;
    std::string out;      ///< a folder
    std::string peers;    ///< the folder of the peers' programs; empty for the one beside this build
    bool resumes = false; ///< keeps what is finished in `out` and would be measured alike
};

struct LabReportRequest
{
    std::string folder;
    std::string base = "carom";
    bool is_json = false;
    std::string markdown; ///< a further file for the text; its plots go into a folder beside it, of its name without the ending
};

struct LabCompareRequest
{
    std::string a; ///< a folder of results, or a `carom` program; empty when instruction sets are compared
    std::string b;
    std::string simd;            ///< instruction sets to compare, names with commas between; the first one is the base
    std::string suite = "quick"; ///< of what is measured
    std::string scenes;          ///< of what is measured: names with commas between; empty for all of the suite
    int runs = 10;               ///< of what is measured
    std::string out;             ///< of what is measured: where the results go
};

struct LabHistoryRequest
{
    int size = 500; ///< circles, and as many boxes
    int steps = 600;
    int runs = 5;
    std::string out; ///< a folder
};

struct LabSelfCheckRequest
{
    std::string suite = "quick";
    std::string scene = "mixed_200"; ///< of that suite
    int tries = 20;
    int runs = 10;
    double slowdown = 0.05;
    std::string out; ///< a folder
};

struct LabStepRequest
{
    std::string scene; ///< a scene file
    int threads = 1;
    int samples = 10;
    std::string broad_phase = "Tree";
    std::string simd = "best"; ///< an instruction set
    bool draws = false;        ///< the picture after each step
    double slowdown = 0;       ///< share of a step's time
    std::string out;           ///< a file
};

// All throw BadUsage and Failure.
void lab_run_command(const LabRunRequest& request, const Surroundings& surroundings);
void lab_report_command(const LabReportRequest& request, const Surroundings& surroundings);
void lab_compare_command(const LabCompareRequest& request, const Surroundings& surroundings);
void lab_history_command(const LabHistoryRequest& request, const Surroundings& surroundings);
/// @throws Failure when the laboratory can't be trusted
void lab_self_check_command(const LabSelfCheckRequest& request, const Surroundings& surroundings);
/// Carom as an engine: what lab/engine_run.hpp tells of programs.
void lab_step_command(const LabStepRequest& request, const Surroundings& surroundings);

} // namespace carom::cli
