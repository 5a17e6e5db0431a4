// The options of each command, and which error ends the program with which status.
#include "cli/program.hpp"

#include "cli/errors.hpp"
#include "cli/export_command.hpp"
#include "cli/lab_options.hpp"
#include "cli/run_command.hpp"
#include "cli/scene_list.hpp"
#include "cli/trace_command.hpp"
#include "files/errors.hpp"
#include "files/text.hpp"
#include "lab/scene_file/model.hpp"
#include "scenes/parameters.hpp"
#include "scenes/scene.hpp"
#include "scenes/text.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <carom/version.hpp>
#include <charconv>
#include <nlohmann/json.hpp>

namespace carom::cli
{

namespace
{

const char* const examples = R"(
Examples:
  carom scenes
  carom run collisions --set circles=1000 --set boxes=1000 --still collisions.png
  carom run gravity --steps 600 --animation gravity.mp4
  carom run gravity --trace gravity.json
  carom export large_pyramid pyramid.json
  carom run pyramid.json --still pyramid.png
  carom trace gravity.json --memory memory.png)";

const char* const run_notes = R"(
--input FILE is a JSON array of events, each with the step before which it happens (from 0) and a key, or a
pointer action at a place in the world in metres:
  [{"step": 10, "pointer": "down", "button": "left", "x": 1.0, "y": 2.0},
   {"step": 20, "pointer": "move", "x": 3.0, "y": 2.5},
   {"step": 25, "pointer": "wheel", "wheel": 2, "x": 3.0, "y": 2.5},
   {"step": 40, "key": "b"}]
Actions are down, up, move and wheel; buttons are left, middle and right. `carom scenes` lists each scene's keys.

Times are those of the world's own steps. An animation is drawn in a run of its own and does not slow them down.
A FILE to write may be -, standard output; the table then goes to standard error, and an animation is a WebM.
Exit status: 0 done, 1 failed, 2 bad usage.)";

/// Refuses what is not a whole number from `min` to `max`. CLI11 by itself takes -1 for the largest unsigned number.
CLI::Validator whole_number(std::uint64_t min, std::uint64_t max)
{
    const std::string remedy = "give a whole number from " + std::to_string(min) + " to " + std::to_string(max);
    const auto check = [=](const std::string& text)
    {
        std::uint64_t number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        const bool fits = error == std::errc{} && end == text.data() + text.size() && min <= number && number <= max;
        return fits ? std::string() : "\"" + text + "\" does not fit; " + remedy;
    };
    return {check, "", "whole number"};
}

void add_scenes_command(CLI::App& app, const Surroundings& surroundings)
{
    CLI::App* const command = app.add_subcommand("scenes", "List the scenes with their parameters and controls");
    const auto is_json = std::make_shared<bool>(false);
    command->add_flag("--json", *is_json, "Print one JSON array");
    command->callback([is_json, &surroundings] { surroundings.out << (*is_json ? scenes_json().dump(2) + "\n" : scenes_text()); });
}

/// Those that this machine has, from the narrowest to the widest.
std::string simd_names()
{
    std::vector<std::string> names;
    for (const Simd simd : all_simd)
        if (is_available(simd)) names.emplace_back(name_of(simd));
    return scenes::joined(names);
}

void add_run_command(CLI::App& app, const Surroundings& surroundings)
{
    CLI::App* const command = app.add_subcommand("run", "Run a scene without a window and measure it");
    const auto request = std::make_shared<RunRequest>();
    command->add_option("scene", request->scene, "Name of a scene, of `carom scenes` or `carom export --list`, or a scene file: FILE.json")
        ->required();
    command->add_option("--set", request->settings, "Set a parameter of the scene; may be given again")
        ->type_name("NAME=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--steps", request->steps, "Number of steps; by default 600, or as many as the scene is meant for")
        ->type_name("N")
        ->check(whole_number(1, most_steps));
    command->add_option("--seed", request->seed, "Equal seeds give equal runs; 1 by default")
        ->type_name("S")
        ->check(whole_number(0, UINT64_MAX));
    command->add_option("--broadphase", request->broad_phase, scenes::joined(scenes::broad_phase_names()))->type_name("NAME");
    command
        ->add_option_function<std::string>("--simd",
                                           [request](const std::string& name)
    {
        request->simd = simd_named(name);
        if (!request->simd || !is_available(*request->simd))
            throw CLI::ValidationError("--simd", files::quoted(name) + " is not on this machine; it has " + simd_names());
    }, "Instruction set of the solver: " + simd_names() + "; by default " + std::string(name_of(best_simd())))
        ->type_name("NAME");
    command->add_option("--input", request->input, "Pointer and key events to give to the scene")->type_name("FILE");
    command->add_flag("--json", request->is_json, "Print one JSON object");
    command->add_option("--still", request->still, "Draw the last step into a picture")->type_name("FILE.png");
    command->add_option("--animation", request->animation, "Draw the run into FILE.mp4, .webm or .gif; needs ffmpeg")->type_name("FILE");
    command
        ->add_option("--trace", request->trace, "Record a trace for chrome://tracing and ui.perfetto.dev; needs the CMake preset `trace`")
        ->type_name("FILE.json");
    command->footer(run_notes);
    command->callback([request, &surroundings] { run_command(*request, surroundings); });
}

void add_export_command(CLI::App& app, const Surroundings& surroundings)
{
    CLI::App* const command = app.add_subcommand("export", "Write a scene into a file that other engines can read too");
    const auto request = std::make_shared<ExportRequest>();
    command->add_option("scene", request->scene, "Name of a scene, of `carom scenes` or of --list");
    command->add_option("file", request->file, "The file to write")->type_name("FILE.json");
    command->add_option("--set", request->settings, "Set a parameter of the scene; may be given again")
        ->type_name("NAME=VALUE")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--steps", request->steps, "How long the scene runs; by default 600, or as many steps as it is meant for")
        ->type_name("N")
        ->check(whole_number(1, most_steps));
    command->add_option("--seed", request->seed, "Equal seeds give equal scenes")
        ->type_name("S")
        ->check(whole_number(0, UINT64_MAX))
        ->capture_default_str();
    command->add_flag("--list", request->lists, "List the benchmark scenes of the laboratory, which are made for this");
    command->add_flag("--json", request->is_json, "Print the list as one JSON array");
    command->add_flag("--schema", request->schema, "Print the JSON Schema of scene files");
    command->footer("FILE.json may be -, standard output. docs/scene-files.md tells what is in a scene file.");
    command->callback([request, &surroundings] { export_command(*request, surroundings); });
}

void add_trace_command(CLI::App& app, const Surroundings& surroundings)
{
    CLI::App* const command = app.add_subcommand("trace", "Sum up a trace that `carom run --trace` wrote");
    const auto request = std::make_shared<TraceRequest>();
    command->add_option("trace", request->trace, "The trace: a JSON file in the trace-event format")->required()->type_name("FILE.json");
    command->add_option("--memory", request->memory, "Draw the memory of each pool over time; - is standard output")->type_name("FILE.png");
    command->callback([request, &surroundings] { trace_command(*request, surroundings); });
}

/// CLI11's own words, but for a command that is missing or misnamed, or an option in its place: it calls all of them a missing subcommand.
std::string problem_of(const CLI::ParseError& error, const CLI::App& app, const std::vector<std::string>& arguments)
{
    const bool lacks_command = dynamic_cast<const CLI::RequiredError*>(&error) && app.get_subcommands().empty();
    if (!lacks_command) return error.what();
    if (arguments.empty()) return "a command is missing; give scenes, run, export, trace or lab";
    const std::string& first = arguments.front();
    if (first.starts_with('-'))
        return "there is no option \"" + first + "\" before a command; give scenes, run, export, trace or lab, and its options after it";
    return "there is no command \"" + first + "\"; give scenes, run, export, trace or lab";
}

int report(const Surroundings& surroundings, const std::exception& error, int status)
{
    surroundings.err << "carom: " << files::printable(error.what()) << "\n";
    return status;
}

int run_arguments(const std::vector<std::string>& arguments, const Surroundings& surroundings)
{
    CLI::App app("Carom, a 2D rigid-body physics engine: runs its scenes without a window.", "carom");
    const auto version = [] { return std::string("carom ") + CAROM_VERSION + ", " + std::string(name_of(World().simd())); };
    app.set_version_flag("--version", version);
    app.require_subcommand(1);
    app.footer(examples);
    add_scenes_command(app, surroundings);
    add_run_command(app, surroundings);
    add_export_command(app, surroundings);
    add_trace_command(app, surroundings);
    add_lab_command(app, surroundings);
    try
    {
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend())); // CLI11 wants them in reverse
        return 0;
    }
    catch (const CLI::Success& help_or_version)
    {
        return app.exit(help_or_version, surroundings.out, surroundings.err);
    }
    catch (const CLI::ParseError& error)
    {
        return report(surroundings, BadUsage(problem_of(error, app, arguments) + "; --help tells more"), status_bad_usage);
    }
    catch (const BadUsage& error)
    {
        return report(surroundings, error, status_bad_usage);
    }
    catch (const scenes::SceneError& error)
    {
        return report(surroundings, error, status_bad_usage);
    }
    catch (const lab::SceneFileError& error)
    {
        return report(surroundings, error, status_bad_usage);
    }
    catch (const files::BadTarget& error)
    {
        return report(surroundings, error, status_bad_usage);
    }
    catch (const files::CannotRead& error)
    {
        return report(surroundings, error, status_bad_usage);
    }
    catch (const std::exception& error)
    {
        // Ctrl-C reaches ffmpeg too: that it failed is then no news.
        const bool is_interrupted = surroundings.is_interrupted && surroundings.is_interrupted();
        if (is_interrupted) return report(surroundings, Failure("interrupted"), status_failed);
        return report(surroundings, error, status_failed);
    }
}

} // namespace

int run_program(const std::vector<std::string>& arguments, const Surroundings& surroundings)
{
    const int status = run_arguments(arguments, surroundings);
    surroundings.out.flush();
    if (status == 0 && !surroundings.out) return report(surroundings, Failure("can't write the output"), status_failed);
    return status;
}

} // namespace carom::cli
