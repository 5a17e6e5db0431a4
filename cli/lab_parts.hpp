// What the commands of `carom lab` share: suites, planned scenes, results, reports, and how an experiment is told.
#pragma once

#include "cli/program.hpp"
#include "lab/experiment.hpp"
#include "lab/plots.hpp"
#include "lab/report.hpp"
#include "lab/suites.hpp"

#include <carom/simd.hpp>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace carom::cli
{

/// "a,b" as a and b; empty parts are left out.
std::vector<std::string> parts_of(const std::string& list);

/// The path of this program.
/// @throws Failure
std::filesystem::path own_program();

/// The instruction set of that name.
/// @throws BadUsage when this machine does not have it, naming those that it has
Simd simd_of(const std::string& name);

/// @param scenes names with commas between; empty for all of the suite
/// @throws BadUsage
lab::Suite suite_of(const std::string& name, const std::string& scenes);

/// Writes the suite's scenes into a folder, where every engine reads them.
/// @throws files::BadTarget, files::CannotWrite
std::vector<lab::PlannedCase> plan_cases(const lab::Suite& suite, const std::vector<int>& threads, const std::filesystem::path& folder);

/// @throws BadUsage
lab::Results results_in(const std::string& folder);

/// Tells on a terminal how an experiment goes.
std::function<void(const lab::Progress&)> teller(const Surroundings& surroundings);
void wipe_line(const Surroundings& surroundings);

/// As Markdown into `file`, with the plots that it shows in the folder `plot_folder` beside it.
/// @throws files::BadTarget, files::CannotWrite
void write_markdown(const lab::Report& report, const lab::Plots& plots, const std::filesystem::path& file, const std::string& plot_folder);

/// As Markdown, HTML and JSON into a folder.
/// @throws files::BadTarget, files::CannotWrite
void write_report(const lab::Report& report, const lab::Plots& plots, const std::filesystem::path& folder);

} // namespace carom::cli
