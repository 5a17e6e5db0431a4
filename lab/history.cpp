// Runs the collision scene with one broad phase after the other.
#include "lab/history.hpp"

#include "files/output_file.hpp"
#include "lab/field_scenes/field_scenes.hpp"
#include "lab/suites.hpp"
#include "scene_file/writer.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace carom::lab
{

namespace
{

struct Version
{
    const char* name;
    BroadPhaseType broad_phase;
    const char* what;
};

constexpr std::array versions = {
    Version{"every pair", BroadPhaseType::BruteForce, "Each shape that has left its bounds is tested against every other."},
    Version{"naive quadtree", BroadPhaseType::QuadtreeNaive,
            "Shapes are inserted one by one, each into every leaf that it touches. Two that share leaves are found in each of them, so a "
            "hash set (std::unordered_set) drops what was found before."},
    Version{
        "flat quadtree, pairs in a set", BroadPhaseType::QuadtreeWithSet,
        "The nodes lie in one array, built by sorting, and a shape lies once, in the deepest node that holds it. No pair can come twice, "
        "but each still goes through the set."},
    Version{"flat quadtree", BroadPhaseType::Quadtree, "The same search without the set: the quadtree as it ended."},
    Version{
        "tree, Carom's default", BroadPhaseType::Tree,
        "A tree of bounding boxes with four children a node, kept from step to step, walked against itself, four boxes tested at once."}};

Chapter chapter_of(const Version& version) { return {.name = version.name, .what = version.what, .broad_phase = version.broad_phase}; }

/// As programs that draw what they step.
std::vector<Engine> engines_of(const std::filesystem::path& carom)
{
    std::vector<Engine> engines;
    for (const Version& version : versions)
        engines.push_back({.name = version.name,
                           .command = {carom.string(), "lab", "step", "--draw", "--broadphase", std::string(name_of(version.broad_phase))},
                           .missing = ""});
    return engines;
}

void add_run(Chapter& chapter, const EngineRun& run)
{
    chapter.frames_ms.push_back(run.frame_ms());
    chapter.frame_ms.push_back(mean_of(chapter.frames_ms.back()));
    chapter.step_ms.push_back(run.mean_ms());
    chapter.find_pairs_ms.push_back(run.counters.at("find_pairs_ms"));
    chapter.pairs_tested = run.counters.at("pairs_tested"); // the same in every run
    chapter.memory_bytes = run.counters.at("memory_bytes");
    chapter.allocations = run.counters.at("allocations");
}

} // namespace

History run_history(const HistoryPlan& plan, const std::function<void(const Progress&)>& tell)
{
    SceneFile file = make_field_scene(*find_field_scene("origin_500"), {.size = plan.size, .seed = 1});
    file.steps = plan.steps;
    std::filesystem::create_directories(plan.scratch);
    const std::filesystem::path path = plan.scratch / "collisions.json";
    files::write_file("--out", path, scene_file_text(file));

    History history{.origin = origin_here(),
                    .scene = file.description,
                    .steps = file.steps,
                    .seconds = file.steps * static_cast<double>(file.time_step),
                    .runs = plan.runs,
                    .chapters = {}};
    for (const Version& version : versions) history.chapters.push_back(chapter_of(version));

    Plan experiment{.suite = "history",
                    .cases = {},
                    .engines = engines_of(plan.carom),
                    .runs = plan.runs,
                    .scratch = plan.scratch,
                    .is_interrupted = plan.is_interrupted};
    experiment.cases = {
        {.scene = "collisions", .what = file.description, .bodies = body_count(file), .steps = file.steps, .threads = 1, .file = path}};
    experiment.on_run = [&history](const Engine& engine, const EngineRun& run)
    {
        const auto is_it = [&](const Chapter& chapter) { return chapter.name == engine.name; };
        add_run(*std::find_if(history.chapters.begin(), history.chapters.end(), is_it), run);
    };
    const Results results = run_experiment(experiment, {}, tell);
    for (const EngineResult& engine : results.cases.front().engines)
        if (engine.outcome != Outcome::Done) throw std::runtime_error(engine.engine + ": " + engine.reason);
    return history;
}

Change change_to(const History& history, std::size_t after)
{
    const Chapter& a = history.chapters.at(after - 1);
    const Chapter& b = history.chapters.at(after);
    return {.frames_of_one_run = student_t_test(a.frames_ms.back(), b.frames_ms.back()),
            .frames = compare(a.frame_ms, b.frame_ms),
            .steps = compare(a.step_ms, b.step_ms)};
}

FalseAlarms false_alarms(const History& history)
{
    FalseAlarms alarms;
    for (const Chapter& chapter : history.chapters)
        for (std::size_t i = 0; i < chapter.frames_ms.size(); ++i)
            for (std::size_t j = i + 1; j < chapter.frames_ms.size(); ++j)
            {
                ++alarms.pairs;
                alarms.found += student_t_test(chapter.frames_ms[i], chapter.frames_ms[j]).p < 0.05;
            }
    return alarms;
}

} // namespace carom::lab
