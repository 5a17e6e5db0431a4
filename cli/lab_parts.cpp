// Reads lists, plans scenes, and writes reports.
#include "cli/lab_parts.hpp"

#include "cli/errors.hpp"
#include "cli/progress.hpp"
#include "files/output_file.hpp"
#include "files/text.hpp"
#include "lab/fingerprint.hpp"
#include "scene_file/writer.hpp"

#include <optional>
#include <sstream>
#include <stdexcept>

namespace carom::cli
{

using std::filesystem::path;

std::vector<std::string> parts_of(const std::string& list)
{
    std::vector<std::string> parts;
    std::istringstream in(list);
    for (std::string part; std::getline(in, part, ',');)
        if (!part.empty()) parts.push_back(part);
    return parts;
}

path own_program()
{
    std::error_code error;
    const path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) throw Failure("can't find out where this program is: " + error.message());
    return program;
}

std::vector<lab::PlannedCase> plan_cases(const lab::Suite& suite, const std::vector<int>& threads, const path& folder)
{
    std::filesystem::create_directories(folder);
    std::vector<lab::PlannedCase> cases;
    for (const lab::SuiteScene& scene : suite.scenes)
    {
        const lab::SceneFile file = scene.make();
        const std::string text = lab::scene_file_text(file);
        const path name = folder / (scene.name + ".json");
        files::write_file("--out", name, text);
        for (const int count : threads)
            cases.push_back({.suite = scene.scene->suite,
                             .scene = scene.name,
                             .what = file.description,
                             .bodies = lab::body_count(file),
                             .steps = file.steps,
                             .threads = count,
                             .samples = scene.samples(),
                             .file = name,
                             .fingerprint = lab::fingerprint_of(text)});
    }
    return cases;
}

std::function<void(const lab::Progress&)> teller(const Surroundings& surroundings)
{
    return [&surroundings](const lab::Progress& progress)
    {
        if (!surroundings.err_is_terminal) return;
        surroundings.err << "\r\033[K" << progress.done + 1 << " of " << progress.total << ": " << files::printable(progress.now);
        if (progress.done > 0) surroundings.err << ", " << duration_text(progress.seconds_left) << " left";
        surroundings.err << std::flush;
    };
}

void wipe_line(const Surroundings& surroundings)
{
    if (surroundings.err_is_terminal) surroundings.err << "\r\033[K" << std::flush;
}

Simd simd_of(const std::string& name)
{
    const std::optional<Simd> simd = simd_named(name);
    if (simd && is_available(*simd)) return *simd;
    std::string names;
    for (const Simd one : all_simd)
        if (is_available(one)) names += (names.empty() ? "" : ", ") + std::string(name_of(one));
    throw BadUsage("--simd: " + files::quoted(name) + " is not on this machine; it has " + names);
}

lab::Suite suite_of(const std::string& name, const std::string& scenes)
{
    try
    {
        const lab::Suite& suite = lab::find_suite(name);
        return scenes.empty() ? suite : suite.with_scenes(parts_of(scenes));
    }
    catch (const std::invalid_argument& error)
    {
        throw BadUsage(error.what());
    }
}

lab::Results results_in(const std::string& folder)
{
    try
    {
        return lab::read_results(folder);
    }
    catch (const std::runtime_error& error)
    {
        throw BadUsage(error.what());
    }
}

void write_markdown(const lab::Report& report, const lab::Plots& plots, const path& file, const std::string& plot_folder)
{
    const path folder = file.parent_path() / plot_folder;
    std::filesystem::create_directories(folder);
    for (const lab::Plot& plot : plots.drawn)
        if (plot.kind != lab::PlotKind::Curve) files::write_file("--out", folder / plot.file, plot.svg);
    files::write_file("--out", file, report_markdown(report, plots, plot_folder));
}

void write_report(const lab::Report& report, const lab::Plots& plots, const path& folder)
{
    write_markdown(report, plots, folder / "report.md", "plots");
    files::write_file("--out", folder / "report.html", report_html(report, plots));
    files::write_file("--out", folder / "report.json", report_json(report));
}

} // namespace carom::cli
