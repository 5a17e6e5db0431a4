// Rounds of runs.
#include "lab/experiment.hpp"

#include "lab/comparison.hpp"
#include "lab/process.hpp"

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace carom::lab
{

namespace
{

constexpr int curve_parts = 100;

/// What one engine has done so far on one case.
struct Series
{
    EngineResult result;
    std::vector<std::vector<double>> curves;
    std::vector<double> event_ms; ///< of each run the mean
    std::vector<double> ray_ms;
    EngineRun last;
};

class Stopwatch
{
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void give_up(EngineResult& result, Outcome outcome, std::string reason)
{
    while (!reason.empty() && reason.back() == '\n') reason.pop_back();
    result.outcome = outcome;
    result.reason = std::move(reason);
    result.run_ms.clear();
}

/// The last line of what a program said: the one that tells why it ended.
std::string last_line(const std::string& words)
{
    const std::size_t end = words.find_last_not_of("\n ");
    if (end == std::string::npos) return {};
    const std::size_t begin = words.find_last_of('\n', end);
    return words.substr(begin == std::string::npos ? 0 : begin + 1, end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

void run_once(const Plan& plan, const PlannedCase& one, const Engine& engine, Series& series)
{
    const std::filesystem::path out = plan.scratch / "run.json";
    std::error_code ignored;
    std::filesystem::remove(out, ignored);
    std::vector<std::string> command = engine.command;
    for (const std::string& word : {one.file.string(), std::string("--threads"), std::to_string(one.threads), std::string("--samples"),
                                    std::to_string(one.samples), std::string("--out"), out.string()})
        command.push_back(word);

    const ProcessResult process = run_process(command, plan.most_seconds, plan.is_interrupted);
    EngineResult& result = series.result;
    if (!process.is_started) return give_up(result, Outcome::Missing, command.front() + " can't be started");
    if (process.is_timeout)
        return give_up(result, Outcome::Failed, "took more than " + std::to_string(static_cast<int>(plan.most_seconds)) + " s");
    if (process.status == status_can_not) return give_up(result, Outcome::CanNot, last_line(process.errors));
    if (process.status != 0)
        return give_up(result, Outcome::Failed, "exit status " + std::to_string(process.status) + ": " + last_line(process.errors));
    try
    {
        EngineRun run = read_run(out);
        result.version = run.version;
        result.differences = run.differences;
        result.run_ms.push_back(run.mean_ms());
        result.ray_hits = run.ray_hits;
        series.event_ms.push_back(mean_of(run.event_ms));
        series.ray_ms.push_back(mean_of(run.ray_ms));
        series.curves.push_back(run.curve(curve_parts));
        if (plan.on_run) plan.on_run(engine, run);
        series.last = std::move(run);
    }
    catch (const std::runtime_error& error)
    {
        give_up(result, Outcome::Failed, error.what());
    }
}

std::vector<double> median_curve(const std::vector<std::vector<double>>& curves)
{
    std::vector<double> medians;
    for (std::size_t i = 0; !curves.empty() && i < curves.front().size(); ++i)
    {
        std::vector<double> values;
        for (const std::vector<double>& curve : curves)
            if (i < curve.size()) values.push_back(curve[i]);
        medians.push_back(median(values));
    }
    return medians;
}

CaseResult finish(const PlannedCase& one, std::vector<Series>& all, const Evaluator& evaluate)
{
    CaseResult result{.suite = one.suite,
                      .scene = one.scene,
                      .what = one.what,
                      .bodies = one.bodies,
                      .steps = one.steps,
                      .threads = one.threads,
                      .engines = {}};
    for (Series& series : all)
    {
        if (series.result.outcome == Outcome::Done)
        {
            series.result.event_ms = median(series.event_ms);
            series.result.ray_ms = median(series.ray_ms);
            series.result.curve_ms = median_curve(series.curves);
            if (evaluate) series.result.quality = evaluate(one, series.last);
        }
        result.engines.push_back(std::move(series.result));
    }
    return result;
}

std::vector<Series> start_series(const Plan& plan)
{
    std::vector<Series> all;
    for (const Engine& engine : plan.engines)
    {
        Series& series = all.emplace_back();
        series.result.engine = engine.name;
        if (engine.command.empty()) give_up(series.result, Outcome::Missing, engine.missing);
    }
    return all;
}

} // namespace

Results run_experiment(const Plan& plan, const Evaluator& evaluate, const std::function<void(const Progress&)>& tell,
                       const std::function<void(const Results&)>& keep_part)
{
    std::filesystem::create_directories(plan.scratch);
    Results results{.origin = origin_here(), .suite = plan.suite, .runs = plan.runs, .cases = {}};
    const Stopwatch watch;
    Progress progress;
    progress.total = static_cast<int>(plan.cases.size() * plan.engines.size()) * plan.runs;
    for (const PlannedCase& one : plan.cases)
    {
        std::vector<Series> all = start_series(plan);
        for (int round = 0; round < plan.runs; ++round)
        {
            for (std::size_t place = 0; place < all.size(); ++place)
            {
                // Whoever comes first finds the machine as the round before left it: everybody does, in turn.
                const std::size_t turn = (place + static_cast<std::size_t>(round)) % all.size();
                progress.now =
                    one.scene + ", " + plan.engines[turn].name + ", run " + std::to_string(round + 1) + " of " + std::to_string(plan.runs);
                if (tell) tell(progress);
                if (all[turn].result.outcome == Outcome::Done) run_once(plan, one, plan.engines[turn], all[turn]);
                if (plan.is_interrupted && plan.is_interrupted()) throw std::runtime_error("interrupted");
                ++progress.done;
                progress.seconds_left = watch.seconds() / progress.done * (progress.total - progress.done);
            }
        }
        results.cases.push_back(finish(one, all, evaluate));
        if (keep_part && &one != &plan.cases.back()) keep_part(results);
    }
    return results;
}

} // namespace carom::lab
