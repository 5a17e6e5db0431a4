// Reads the options of `carom lab` and its parts.
#include "cli/lab_options.hpp"

#include "cli/lab_command.hpp"
#include "lab/suites.hpp"
#include "scenes/scene.hpp"
#include "scenes/text.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace carom::cli
{

namespace
{

constexpr int fewest_runs = 4; // fewer can't be told apart with a confidence of 95%, whatever they are
constexpr int most_runs = 1000;

std::string suite_notes()
{
    std::string notes = "Suites:\n";
    for (const lab::Suite& suite : lab::suites())
        notes += "  " + suite.name + std::string(10 - std::min<std::size_t>(suite.name.size(), 9), ' ') + suite.what + "\n";
    return notes +
           "\nEngines: carom; its peers box2d3, rapier and box2d2, which `./dev peers` builds; box2d3-source, which\n"
           "`./dev peers box2d3 --source DIR` builds from a checkout of Box2D; and origin, which is carom with the quadtree of\n"
           "the engine that it began as. Every engine steps the same scene files, in turns; ratios are between medians of runs, with\n"
           "bootstrap intervals.";
}

void add_scenes(CLI::App& command, std::string& scenes)
{
    command.add_option("--scenes", scenes, "Some scenes of the suite alone")->type_name("A,B,...");
}

void add_runs(CLI::App& command, int& runs, const std::string& what)
{
    command.add_option("--runs", runs, what)->type_name("N")->check(CLI::Range(fewest_runs, most_runs))->capture_default_str();
}

void add_run(CLI::App& lab, const Surroundings& surroundings)
{
    CLI::App* const command = lab.add_subcommand("run", "Measure engines on a suite of scenes, and write a report");
    const auto request = std::make_shared<LabRunRequest>();
    command->add_option("suite", request->suite, "The scenes")->capture_default_str();
    add_scenes(*command, request->scenes);
    command->add_option("--engines", request->engines, "Who takes part; by default all but box2d3-source, which does where it is built")
        ->type_name("A,B,...");
    command->add_option("--threads", request->threads, "Numbers of threads to offer, one after the other")
        ->type_name("N,M,...")
        ->capture_default_str();
    add_runs(*command, request->runs, "How often each engine runs each scene");
    command->add_option("--out", request->out, "Folder for results and reports")->type_name("DIR")->required();
    command->add_option("--peers", request->peers, "Folder of the peers' programs; by default build/peers/bin")->type_name("DIR");
    command->add_flag("--resume", request->resumes, "Keep what DIR holds of the same build, machine and settings, and measure the rest");
    command->footer(suite_notes());
    command->callback([request, &surroundings] { lab_run_command(*request, surroundings); });
}

void add_report(CLI::App& lab, const Surroundings& surroundings)
{
    CLI::App* const command = lab.add_subcommand("report", "Report on results that `carom lab run` left, as text, Markdown, HTML and JSON");
    const auto request = std::make_shared<LabReportRequest>();
    command->add_option("folder", request->folder, "Where the results are")->type_name("DIR")->required();
    command->add_option("--base", request->base, "The engine that the others are set against")->type_name("NAME")->capture_default_str();
    CLI::Option* const json = command->add_flag("--json", request->is_json, "Print one JSON object, and write nothing");
    command->add_option("--markdown", request->markdown, "Write the text to this file too, and its plots into a folder beside it")
        ->type_name("FILE.md")
        ->excludes(json);
    command->callback([request, &surroundings] { lab_report_command(*request, surroundings); });
}

void add_compare(CLI::App& lab, const Surroundings& surroundings)
{
    CLI::App* const command = lab.add_subcommand(
        "compare", "Tell whether B is faster or slower than A: two folders of results, two builds of carom, or instruction sets");
    const auto request = std::make_shared<LabCompareRequest>();
    command->add_option("a", request->a, "A folder of results, or a `carom` program")->type_name("A");
    command->add_option("b", request->b, "The same kind")->type_name("B");
    command->add_option("--simd", request->simd, "Compare instruction sets instead, as sse2,avx2; the first one is the base")
        ->type_name("X,Y,...");
    command->add_option("--suite", request->suite, "The scenes on which is measured")->capture_default_str();
    add_scenes(*command, request->scenes);
    add_runs(*command, request->runs, "How often each side runs each scene");
    command->add_option("--out", request->out, "Folder for the results of what is measured")->type_name("DIR");
    command->callback([request, &surroundings] { lab_compare_command(*request, surroundings); });
}

void add_history(CLI::App& lab, const Surroundings& surroundings)
{
    CLI::App* const command = lab.add_subcommand(
        "history", "Measure the collision scene with every broad phase, from every pair to the tree, with the tests between them");
    const auto request = std::make_shared<LabHistoryRequest>();
    command->add_option("--size", request->size, "Circles, and as many boxes")
        ->type_name("N")
        ->check(CLI::Range(1, 20'000))
        ->capture_default_str();
    command->add_option("--steps", request->steps, "Steps of a run; 600 are ten seconds")
        ->type_name("N")
        ->check(CLI::Range(2, 1'000'000))
        ->capture_default_str();
    add_runs(*command, request->runs, "How often each version runs");
    command->add_option("--out", request->out, "Folder for the table and what it is made from")->type_name("DIR")->required();
    command->callback([request, &surroundings] { lab_history_command(*request, surroundings); });
}

void add_self_check(CLI::App& lab, const Surroundings& surroundings)
{
    CLI::App* const command = lab.add_subcommand(
        "selfcheck", "Tell whether measurements can be trusted here: no difference between equals, and a planted slowdown is found");
    const auto request = std::make_shared<LabSelfCheckRequest>();
    command->add_option("--suite", request->suite, "Where the scene is from")->capture_default_str();
    command->add_option("--scene", request->scene, "What is measured")->capture_default_str();
    command->add_option("--tries", request->tries, "Comparisons of the program with itself")
        ->type_name("N")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    add_runs(*command, request->runs, "Runs of each side in a comparison");
    command->add_option("--slowdown", request->slowdown, "The share by which the planted one is slower")
        ->type_name("SHARE")
        ->check(CLI::Range(0.001, 10.0))
        ->capture_default_str();
    command->add_option("--out", request->out, "Folder for the table and the scene")->type_name("DIR")->required();
    command->callback([request, &surroundings] { lab_self_check_command(*request, surroundings); });
}

void add_step(CLI::App& lab, const Surroundings& surroundings)
{
    CLI::App* const command = lab.add_subcommand("step", "Step a scene file as one of the engines: for programs");
    const auto request = std::make_shared<LabStepRequest>();
    command->add_option("scene", request->scene, "The scene file")->type_name("SCENE.json")->required();
    command->add_option("--threads", request->threads, "Threads to use at most")
        ->type_name("N")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command->add_option("--samples", request->samples, "Moments at which to write where the bodies are")
        ->type_name("K")
        ->check(CLI::Range(1, 100'000))
        ->capture_default_str();
    command->add_option("--broadphase", request->broad_phase, scenes::joined(scenes::broad_phase_names()))
        ->type_name("NAME")
        ->capture_default_str();
    command->add_option("--simd", request->simd, "Instruction set of the solver")->type_name("NAME")->capture_default_str();
    command->add_flag("--draw", request->draws, "Draw the picture after each step, and tell what that takes");
    command->add_option("--slowdown", request->slowdown, "Makes every step take longer by this share of its time, to try what is found")
        ->type_name("SHARE")
        ->check(CLI::Range(0.0, 10.0))
        ->capture_default_str();
    command->add_option("--out", request->out, "The file to write; - is standard output")->type_name("RESULT.json")->required();
    command->callback([request, &surroundings] { lab_step_command(*request, surroundings); });
}

} // namespace

void add_lab_command(CLI::App& app, const Surroundings& surroundings)
{
    CLI::App* const lab = app.add_subcommand("lab", "Measure Carom against other engines, and one build against another");
    lab->require_subcommand(1);
    add_run(*lab, surroundings);
    add_report(*lab, surroundings);
    add_compare(*lab, surroundings);
    add_history(*lab, surroundings);
    add_self_check(*lab, surroundings);
    add_step(*lab, surroundings);
}

} // namespace carom::cli
