// Runs the collision scene with one broad phase after the other.
#include "lab/history.hpp"

#include "lab/field_scenes/field_scenes.hpp"
#include "lab/report_tables.hpp"
#include "lab/scene_file/writer.hpp"
#include "lab/suites.hpp"

#include <array>
#include <numeric>
#include <stdexcept>

namespace carom::lab
{

namespace
{

struct Version
{
    const char* name;
    const char* broad_phase;
};

constexpr std::array versions = {Version{"every pair", "BruteForce"}, Version{"naive quadtree, pairs in a hash set", "QuadtreeNaive"},
                                 Version{"quadtree", "Quadtree"}, Version{"tree, Carom's default", "Tree"}};

double mean_of(const std::vector<double>& values)
{
    return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<Engine> engines_of(const std::filesystem::path& carom)
{
    std::vector<Engine> engines;
    for (const Version& version : versions)
        engines.push_back(
            {.name = version.name, .command = {carom.string(), "lab", "step", "--broadphase", version.broad_phase}, .missing = ""});
    return engines;
}

std::string interval_text(const Interval& interval) { return number_text(interval.low) + " to " + number_text(interval.high); }

std::string p_text(double p) { return p < 1e-4 ? "< 0.0001" : number_text(p, 2); }

Table version_table(const History& history)
{
    Table table({"version", "ms a step", "find pairs", "share", "pairs tested a step", "memory", "allocations a step"});
    for (const Chapter& chapter : history.chapters)
    {
        const double step = mean_of(chapter.frame_ms);
        table.add({chapter.name, number_text(median(chapter.run_ms)), number_text(chapter.find_pairs_ms) + " ms",
                   number_text(step > 0 ? 100 * chapter.find_pairs_ms / step : 0) + " %", number_text(chapter.pairs_tested),
                   number_text(chapter.memory_bytes / 1e6) + " MB", number_text(chapter.allocations)});
    }
    return table;
}

std::string by_frames(const Chapter& before, const Chapter& after)
{
    const TTest t = student_t_test(before.frame_ms, after.frame_ms);
    return "  as its author did it, " + std::to_string(before.frame_ms.size()) + " and " + std::to_string(after.frame_ms.size()) +
           " frames of one run each: Student's t = " + number_text(t.t) + ", p " + p_text(t.p) + ", difference " +
           number_text(t.difference) + " ms, " + interval_text(t.interval) + " ms\n";
}

std::string by_runs(const Chapter& before, const Chapter& after)
{
    const Comparison c = compare(before.run_ms, after.run_ms);
    return "  as it should be, " + std::to_string(before.run_ms.size()) + " runs of each in turns: Welch's t = " + number_text(c.welch.t) +
           ", p " + p_text(c.welch.p) + ", difference " + number_text(c.welch.difference) + " ms, " + interval_text(c.welch.interval) +
           " ms; Mann-Whitney p " + p_text(c.mann_whitney_p) + "; ratio of medians " + number_text(c.ratio) + ", " +
           interval_text(c.interval) + ": " + std::string(name_of(c.verdict)) + (c.is_noisy ? " (the machine was noisy)" : "") + "\n";
}

} // namespace

History run_history(const HistoryPlan& plan, const std::function<void(const Progress&)>& tell)
{
    SceneFile file = make_field_scene(*find_field_scene("origin_500"), {.size = plan.size, .seed = 1});
    file.steps = plan.steps;
    std::filesystem::create_directories(plan.scratch);
    const std::filesystem::path path = plan.scratch / "collisions.json";
    write_scene_file(path, file);

    std::vector<EngineRun> last_runs;
    const auto keep = [&](const PlannedCase&, const EngineRun& run) -> std::map<std::string, double>
    {
        last_runs.push_back(run);
        return {};
    };
    Plan experiment{.suite = "history", .cases = {}, .engines = engines_of(plan.carom), .runs = plan.runs, .scratch = plan.scratch};
    experiment.cases = {
        {.scene = "collisions", .what = file.description, .bodies = body_count(file), .steps = file.steps, .threads = 1, .file = path}};
    const Results results = run_experiment(experiment, keep, tell);

    History history{.origin = results.origin, .scene = file.description, .steps = file.steps, .runs = plan.runs, .chapters = {}};
    for (const EngineResult& engine : results.cases.front().engines)
    {
        if (engine.outcome != Outcome::Done) throw std::runtime_error(engine.engine + ": " + engine.reason);
        const EngineRun& run = last_runs[history.chapters.size()];
        history.chapters.push_back({.name = engine.engine,
                                    .run_ms = engine.run_ms,
                                    .frame_ms = run.step_ms,
                                    .find_pairs_ms = run.counters.at("find_pairs_ms"),
                                    .pairs_tested = run.counters.at("pairs_tested"),
                                    .memory_bytes = run.counters.at("memory_bytes"),
                                    .allocations = run.counters.at("allocations")});
    }
    return history;
}

std::string history_text(const History& history)
{
    Results origin;
    origin.origin = history.origin;
    origin.suite = "history";
    origin.runs = history.runs;
    std::string out = origin_line(origin) + "\n" + history.scene + " " + std::to_string(history.steps) + " steps.\n\n" +
                      version_table(history).text() + "\n";
    for (std::size_t i = 1; i < history.chapters.size(); ++i)
    {
        const Chapter& before = history.chapters[i - 1];
        const Chapter& after = history.chapters[i];
        out += before.name + " -> " + after.name + "\n" + by_frames(before, after) + by_runs(before, after);
    }
    return out;
}

} // namespace carom::lab
