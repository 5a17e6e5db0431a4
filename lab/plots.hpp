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
    std::string svg; ///< an element to put into a page
};

/// Time a step over the course of each case, scaling with the number of bodies where scenes come in sizes, and ratios with their intervals.
/// @param scratch a folder for gnuplot's files
/// @param problem why there are none, or fewer; empty when all is well
std::vector<Plot> draw_plots(const Report& report, const std::filesystem::path& scratch, std::string& problem);

} // namespace carom::lab
