// Plots of a report, drawn by gnuplot.
#pragma once

#include "lab/report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace carom::lab
{

enum class PlotKind
{
    Ratio,   ///< how many times faster the base is than an engine, scene by scene, with intervals
    Scaling, ///< time over the number of bodies, where scenes come in sizes
    Quality, ///< a metric, scene by scene
    Curve    ///< time a step over the course of a run: one for each case
};

struct Plot
{
    PlotKind kind = PlotKind::Curve;
    std::string title;
    std::string file; ///< name of a file for it, which no other plot of the report has
    std::string svg;  ///< an element to put into a page, or into a file by itself
};

struct Plots
{
    std::vector<Plot> drawn;
    std::string problem; ///< why there are none, or fewer; empty when all is well
};

/// All that a report has something for, by kind.
/// @param scratch a folder for gnuplot's files
Plots draw_plots(const Report& report, const std::filesystem::path& scratch);

} // namespace carom::lab
