// The commands of `carom lab` but those that measure engines: reports, the history, the self-check, one run.
#include "cli/lab_command.hpp"

#include "cli/errors.hpp"
#include "cli/lab_parts.hpp"
#include "cli/outputs.hpp"
#include "cli/render.hpp"
#include "files/folder_lock.hpp"
#include "files/output_file.hpp"
#include "files/temporary.hpp"
#include "files/text.hpp"
#include "lab/history.hpp"
#include "lab/own_run.hpp"
#include "lab/self_check.hpp"
#include "scene_file/reader.hpp"
#include "scenes/scene.hpp"
#include "scenes/text.hpp"

#include <filesystem>
#include <optional>

namespace carom::cli
{

namespace
{

using std::filesystem::path;

constexpr scenes::Viewport frame_size{640, 360}; // of the pictures whose drawing is measured

} // namespace

void lab_report_command(const LabReportRequest& request, const Surroundings& surroundings)
{
    const bool is_printed = files::is_standard_output(request.markdown);
    if (!request.markdown.empty()) files::require_ending("--markdown", request.markdown, ".md");
    const lab::Results results = results_in(request.folder);
    const lab::Report report = lab::evaluate(results, request.base);
    if (request.is_json)
    {
        surroundings.out << report_json(report);
        return;
    }
    const path folder = request.folder;
    const files::ScratchFolder scratch(folder);
    const lab::Plots plots = draw_plots(report, scratch.path());
    write_report(report, plots, folder);
    if (is_printed)
        surroundings.out << report_markdown(report, plots, (folder / "plots").string());
    else if (!request.markdown.empty())
        write_markdown(report, plots, request.markdown, path(request.markdown).stem().string());
    std::ostream& words = is_printed ? surroundings.err : surroundings.out;
    words << files::printable(report_text(report) + "\n" + (folder / "report.html").string() + "\n");
}

void lab_history_command(const LabHistoryRequest& request, const Surroundings& surroundings)
{
    const path out = request.out;
    const files::FolderLock lock("--out", out);
    const files::ScratchFolder scratch(out);
    const lab::HistoryPlan plan{.size = request.size,
                                .steps = request.steps,
                                .runs = request.runs,
                                .carom = own_program(),
                                .scratch = scratch.path(),
                                .is_interrupted = surroundings.is_interrupted};
    const lab::History history = lab::run_history(plan, teller(surroundings));
    wipe_line(surroundings);
    const std::string text = history_text(history);
    files::write_file("--out", out / "history.txt", text);
    files::write_file("--out", out / "history.md", history_markdown(history));
    files::write_file("--out", out / "history.json", history_json(history));
    surroundings.out << files::printable(text);
}

void lab_self_check_command(const LabSelfCheckRequest& request, const Surroundings& surroundings)
{
    const path out = request.out;
    const lab::Suite one = suite_of(request.suite, request.scene);
    if (one.scenes.size() != 1)
        throw BadUsage("--scene: " + files::quoted(request.scene) + " names " + std::to_string(one.scenes.size()) + "; give one");
    const files::FolderLock lock("--out", out);
    const files::ScratchFolder scratch(out);
    const lab::SelfCheckPlan plan{.scene = plan_cases(one, {1}, out / "scenes").front(),
                                  .tries = request.tries,
                                  .runs = request.runs,
                                  .slowdown = request.slowdown,
                                  .carom = own_program(),
                                  .scratch = scratch.path(),
                                  .is_interrupted = surroundings.is_interrupted};
    const lab::SelfCheck check = lab::run_self_check(plan, teller(surroundings));
    wipe_line(surroundings);
    files::write_file("--out", out / "selfcheck.txt", self_check_text(check));
    surroundings.out << files::printable(self_check_text(check));
    if (!check.is_passed()) throw Failure("the self-check failed");
}

void lab_step_command(const LabStepRequest& request, const Surroundings& surroundings)
{
    const std::optional<BroadPhaseType> type = broad_phase_named(request.broad_phase);
    if (!type)
        throw BadUsage("--broadphase: " + files::quoted(request.broad_phase) + " is not known; " +
                       scenes::suggestion(request.broad_phase, scenes::broad_phase_names()));
    const lab::SceneFile file = lab::read_scene_file(request.scene);
    Outputs outputs(surroundings);
    files::OutputFile& out = outputs.open("--out", request.out);
    lab::OwnRunOptions options{.threads = request.threads,
                               .samples = request.samples,
                               .broad_phase = *type,
                               .simd = simd_of(request.simd),
                               .slowdown = request.slowdown};
    std::optional<Canvas> canvas;
    if (request.draws)
    {
        canvas.emplace(frame_size, Quality::Quick);
        options.draw = [&canvas](const scenes::DrawList& list, const scenes::Camera& camera) { canvas->draw(list, camera); };
    }
    out.stream() << to_json(lab::run_carom(file, request.scene, options));
    out.commit();
}

} // namespace carom::cli
