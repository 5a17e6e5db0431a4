// What results mean: ratios with intervals, quality beside time, and means over scenes; as text, Markdown, HTML and JSON.
#pragma once

#include "lab/comparison.hpp"
#include "lab/results.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carom::lab
{

/// A measure of quality. Less is better for all of them.
struct Metric
{
    const char* name;  ///< in EngineResult::quality
    const char* label; ///< for people, with the unit
    double floor;      ///< below this nobody minds
};
std::span<const Metric> metrics();

/// An engine on a case, set against the base.
struct ReportRow
{
    const EngineResult* result = nullptr;
    double median_ms = 0;                 ///< a step
    std::optional<Comparison> comparison; ///< with the base as A, so that its ratio is how many times faster the base is
    std::vector<std::string> worse_in;    ///< metrics in which this engine is clearly worse than the base
    std::vector<std::string> better_in;   ///< in which the base is
};

struct ReportCase
{
    const CaseResult* result = nullptr;
    std::vector<ReportRow> rows; ///< in the order of the engines
};

struct Plots; // lab/plots.hpp

/// Over all cases of a suite that both finished.
struct ReportMean
{
    std::string suite; ///< "all" for the scenes of every suite
    std::string engine;
    int threads = 1;
    int cases = 0;
    double ratio = 1; ///< geometric mean of how many times faster the base is
};

struct Report
{
    const Results* results = nullptr;
    std::string base;
    std::vector<ReportCase> cases;
    std::vector<ReportMean> means;
    bool is_noisy = false; ///< some runs of one engine differ by much
};

/// @param results must outlive the report
/// @param base the engine that others are set against
Report evaluate(const Results& results, const std::string& base = "carom", const ComparisonOptions& options = {});

std::string report_text(const Report& report);
/// @param plots those of curves are left out: they are too many
/// @param plot_folder where their files are, as seen from the text's file
std::string report_markdown(const Report& report, const Plots& plots, const std::string& plot_folder);
/// By scene, threads and engine: the median time a step, the base's speed as a ratio with its interval, quality, and the geometric means.
std::string report_json(const Report& report);
/// One page that needs nothing else.
std::string report_html(const Report& report, const Plots& plots);

/// Two results of the same suite, engine by engine: A is the older.
std::string compare_text(const Results& a, const Results& b, const ComparisonOptions& options = {});

} // namespace carom::lab
