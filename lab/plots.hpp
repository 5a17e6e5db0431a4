// Plots of a report, drawn by gnuplot.
#pragma once

#include "lab/report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace carom::lab
{

struct Plot
{
    std::string title;
    std::string file;        ///< name of a file for it, which no other plot of the report has
    std::string svg;         ///< an element to put into a page, or into a file by itself
    bool is_summary = false; ///< over many scenes
};

struct Plots
{
    std::vector<Plot> drawn;
    std::string problem; ///< why there are none, or fewer; empty when all is well
};

/// Ratios with their intervals, scaling with the number of bodies where scenes come in sizes, and quality, which are summaries; and the time a step over
/// the course of each case.
/// @param scratch a folder for gnuplot's files
Plots draw_plots(const Report& report, const std::filesystem::path& scratch);

} // namespace carom::lab
