// Plans experiments, tells how they go, and writes reports.
#include "cli/lab_command.hpp"

#include "cli/errors.hpp"
#include "cli/pending_file.hpp"
#include "cli/progress.hpp"
#include "cli/render.hpp"
#include "lab/engines.hpp"
#include "lab/history.hpp"
#include "lab/own_run.hpp"
#include "lab/plots.hpp"
#include "lab/report.hpp"
#include "lab/scene_file/reader.hpp"
#include "lab/scene_file/writer.hpp"
#include "lab/self_check.hpp"
#include "lab/suites.hpp"
#include "scenes/scene.hpp"
#include "scenes/text.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace carom::cli
{

namespace
{

using std::filesystem::path;

constexpr scenes::Viewport frame_size{640, 360}; // of the pictures whose drawing is measured

std::vector<std::string> parts_of(const std::string& list)
{
    std::vector<std::string> parts;
    std::istringstream in(list);
    for (std::string part; std::getline(in, part, ',');)
        if (!part.empty()) parts.push_back(part);
    return parts;
}

std::vector<int> threads_of(const std::string& list)
{
    constexpr int most = 256;
    std::vector<int> threads;
    for (const std::string& part : parts_of(list))
    {
        int number = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
        if (error != std::errc{} || end != part.data() + part.size() || number < 1 || number > most)
            throw BadUsage("--threads: \"" + part + "\" does not fit; give numbers from 1 to " + std::to_string(most) + ", as 1,2");
        threads.push_back(number);
    }
    if (threads.empty()) throw BadUsage("--threads: is empty; give numbers, as 1,2");
    return threads;
}

/// This program.
path own_program()
{
    std::error_code error;
    const path program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (error) throw Failure("can't find out where this program is: " + error.message());
    return program;
}

std::vector<lab::Engine> engines_of(const std::string& list, const path& peers)
{
    try
    {
        return lab::find_engines(parts_of(list), own_program(), peers);
    }
    catch (const std::invalid_argument& error)
    {
        throw BadUsage(std::string("--engines: ") + error.what());
    }
}

/// Writes the suite's scenes into a folder, where every engine reads them.
std::vector<lab::PlannedCase> plan_cases(const lab::Suite& suite, const std::vector<int>& threads, const path& folder)
{
    std::filesystem::create_directories(folder);
    std::vector<lab::PlannedCase> cases;
    for (const lab::SuiteScene& scene : suite.scenes)
    {
        const lab::SceneFile file = scene.make();
        const path name = folder / (scene.name + ".json");
        lab::write_scene_file(name, file);
        for (const int count : threads)
            cases.push_back({.suite = scene.scene->suite,
                             .scene = scene.name,
                             .what = file.description,
                             .bodies = lab::body_count(file),
                             .steps = file.steps,
                             .threads = count,
                             .samples = scene.samples(),
                             .file = name});
    }
    return cases;
}

/// Tells on a terminal how an experiment goes.
std::function<void(const lab::Progress&)> teller(const Surroundings& surroundings)
{
    return [&surroundings](const lab::Progress& progress)
    {
        if (!surroundings.err_is_terminal) return;
        surroundings.err << "\r\033[K" << progress.done + 1 << " of " << progress.total << ": " << progress.now;
        if (progress.done > 0) surroundings.err << ", " << duration_text(progress.seconds_left) << " left";
        surroundings.err << std::flush;
    };
}

void wipe_line(const Surroundings& surroundings)
{
    if (surroundings.err_is_terminal) surroundings.err << "\r\033[K" << std::flush;
}

/// Keeps what is finished in `folder`, so that an experiment that is ended leaves the scenes that it has done.
lab::Results measure(const lab::Plan& plan, const lab::Suite& suite, const path& folder, const Surroundings& surroundings)
{
    const auto evaluate = [&](const lab::PlannedCase& one, const lab::EngineRun& run)
    { return lab::quality_of(lab::read_scene_file(one.file), run.samples, suite.traits_of(one.scene)); };
    const auto keep = [&](const lab::Results& part) { lab::write_results(part, folder); };
    lab::Results results = lab::run_experiment(plan, evaluate, teller(surroundings), keep);
    wipe_line(surroundings);
    lab::write_results(results, folder);
    return results;
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

void write_text(const path& file, const std::string& text)
{
    PendingFile pending("--out", file.string());
    std::ofstream(pending.temporary()) << text;
    pending.commit();
}

/// A report as Markdown, with the plots that it shows in a folder beside it.
void write_markdown(const lab::Report& report, const lab::Plots& plots, const path& file, const std::string& plot_folder)
{
    const path folder = file.parent_path() / plot_folder;
    std::filesystem::create_directories(folder);
    for (const lab::Plot& plot : plots.drawn)
        if (plot.kind != lab::PlotKind::Curve) write_text(folder / plot.file, plot.svg);
    write_text(file, report_markdown(report, plots, plot_folder));
}

void write_report(const lab::Report& report, const lab::Plots& plots, const path& folder)
{
    write_markdown(report, plots, folder / "report.md", "plots");
    write_text(folder / "report.html", report_html(report, plots));
    write_text(folder / "report.json", report_json(report));
}

} // namespace

void lab_run_command(const LabRunRequest& request, const Surroundings& surroundings)
{
    const lab::Suite suite = suite_of(request.suite, request.scenes);
    const path out = request.out;
    const path peers = request.peers.empty() ? own_program().parent_path() / ".." / ".." / "peers" / "bin" : path(request.peers);
    lab::Plan plan{.suite = suite.name,
                   .cases = {},
                   .engines = engines_of(request.engines, peers.lexically_normal()),
                   .runs = request.runs,
                   .scratch = out / "scratch",
                   .is_interrupted = surroundings.is_interrupted};
    plan.cases = plan_cases(suite, threads_of(request.threads), out / "scenes");
    const lab::Results results = measure(plan, suite, out, surroundings);
    const lab::Report report = lab::evaluate(results);
    write_report(report, draw_plots(report, out / "scratch"), out);
    surroundings.out << report_text(report) << "\n" << (out / "report.html").string() << "\n";
}

void lab_report_command(const LabReportRequest& request, const Surroundings& surroundings)
{
    if (!request.markdown.empty() && path(request.markdown).extension() != ".md")
        throw BadUsage("--markdown: \"" + request.markdown + "\" is no name of a text; give one that ends in .md");
    const lab::Results results = results_in(request.folder);
    const lab::Report report = lab::evaluate(results, request.base);
    if (request.is_json)
    {
        surroundings.out << report_json(report);
        return;
    }
    const path folder = request.folder;
    const lab::Plots plots = draw_plots(report, folder / "scratch");
    write_report(report, plots, folder);
    if (!request.markdown.empty()) write_markdown(report, plots, request.markdown, path(request.markdown).stem().string());
    surroundings.out << report_text(report) << "\n" << (path(request.folder) / "report.html").string() << "\n";
}

void lab_compare_command(const LabCompareRequest& request, const Surroundings& surroundings)
{
    std::error_code ignored;
    const bool are_folders = std::filesystem::is_directory(request.a, ignored) && std::filesystem::is_directory(request.b, ignored);
    if (are_folders)
    {
        surroundings.out << lab::compare_text(results_in(request.a), results_in(request.b));
        return;
    }
    for (const std::string& program : {request.a, request.b})
        if (!std::filesystem::is_regular_file(program, ignored))
            throw BadUsage("\"" + program + "\" is neither a folder of results nor a program; give two of one kind");
    if (request.out.empty()) throw BadUsage("--out is missing: programs are measured, and their results go into a folder");
    const lab::Suite suite = suite_of(request.suite, request.scenes);
    const path out = request.out;
    lab::Plan plan{.suite = suite.name,
                   .cases = {},
                   .engines = {},
                   .runs = request.runs,
                   .scratch = out / "scratch",
                   .is_interrupted = surroundings.is_interrupted};
    plan.engines = {{.name = "A", .command = {request.a, "lab", "step"}, .missing = ""},
                    {.name = "B", .command = {request.b, "lab", "step"}, .missing = ""}};
    plan.cases = plan_cases(suite, {1}, out / "scenes");
    const lab::Results results = measure(plan, suite, out, surroundings);
    const lab::Report report = lab::evaluate(results, "A");
    write_report(report, draw_plots(report, out / "scratch"), out);
    surroundings.out << "A: " << request.a << "\nB: " << request.b << "\n" << report_text(report);
}

void lab_history_command(const LabHistoryRequest& request, const Surroundings& surroundings)
{
    const path out = request.out;
    const lab::HistoryPlan plan{.size = request.size,
                                .steps = request.steps,
                                .runs = request.runs,
                                .carom = own_program(),
                                .scratch = out / "scratch",
                                .is_interrupted = surroundings.is_interrupted};
    const lab::History history = lab::run_history(plan, teller(surroundings));
    wipe_line(surroundings);
    const std::string text = history_text(history);
    write_text(out / "history.txt", text);
    write_text(out / "history.md", history_markdown(history));
    write_text(out / "history.json", history_json(history));
    surroundings.out << text;
}

void lab_self_check_command(const LabSelfCheckRequest& request, const Surroundings& surroundings)
{
    const path out = request.out;
    const lab::Suite one = suite_of(request.suite, request.scene);
    if (one.scenes.size() != 1)
        throw BadUsage("--scene: \"" + request.scene + "\" names " + std::to_string(one.scenes.size()) + "; give one");
    const lab::SelfCheckPlan plan{.scene = plan_cases(one, {1}, out / "scenes").front(),
                                  .tries = request.tries,
                                  .runs = request.runs,
                                  .slowdown = request.slowdown,
                                  .carom = own_program(),
                                  .scratch = out / "scratch",
                                  .is_interrupted = surroundings.is_interrupted};
    const lab::SelfCheck check = lab::run_self_check(plan, teller(surroundings));
    wipe_line(surroundings);
    write_text(out / "selfcheck.txt", self_check_text(check));
    surroundings.out << self_check_text(check);
    if (!check.is_passed()) throw Failure("the self-check failed");
}

void lab_step_command(const LabStepRequest& request)
{
    const std::optional<BroadPhaseType> type = broad_phase_named(request.broad_phase);
    if (!type)
        throw BadUsage("--broadphase: \"" + request.broad_phase + "\" is not known; " +
                       scenes::suggestion(request.broad_phase, scenes::broad_phase_names()));
    const lab::SceneFile file = lab::read_scene_file(request.scene);
    lab::OwnRunOptions options{.threads = request.threads, .samples = request.samples, .broad_phase = *type, .slowdown = request.slowdown};
    std::optional<Canvas> canvas;
    if (request.draws)
    {
        canvas.emplace(frame_size, Quality::Quick);
        options.draw = [&canvas](const scenes::DrawList& list, const scenes::Camera& camera) { canvas->draw(list, camera); };
    }
    write_text(request.out, to_json(lab::run_carom(file, request.scene, options)));
}

} // namespace carom::cli
