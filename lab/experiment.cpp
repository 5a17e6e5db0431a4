// Rounds of runs.
#include "lab/experiment.hpp"

#include "files/text.hpp"
#include "lab/comparison.hpp"
#include "lab/fingerprint.hpp"
#include "lab/process.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
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
    result.reason = files::printable(reason);
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

/// @throws std::runtime_error when the run is not of that case
void check(const EngineRun& run, const PlannedCase& one)
{
    if (!run.is_of(one.file)) throw std::runtime_error("its result is of the scene " + files::quoted(run.scene));
    if (run.step_ms.size() != static_cast<std::size_t>(one.steps))
        throw std::runtime_error("it made " + std::to_string(run.step_ms.size()) + " of " + std::to_string(one.steps) + " steps");
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
        check(run, one);
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
                      .engines = {},
                      .fingerprint = one.fingerprint};
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

/// What is finished of a plan, by the number of its case.
class Finished
{
public:
    explicit Finished(const Plan& plan)
        : results_{.origin = origin_here(), .suite = plan.suite, .runs = plan.runs, .cases = {}, .engines = programs_of(plan.engines)},
          cases_(plan.cases.size())
    {
        for (std::size_t i = 0; i < cases_.size(); ++i)
            for (const CaseResult& one : plan.finished)
                if (one.scene == plan.cases[i].scene && one.threads == plan.cases[i].threads) cases_[i] = one;
    }

    bool has(std::size_t i) const { return cases_[i].has_value(); }
    void add(std::size_t i, CaseResult result) { cases_[i] = std::move(result); }
    int open_cases() const { return static_cast<int>(std::count(cases_.begin(), cases_.end(), std::nullopt)); }
    /// In the order of the plan.
    Results results() const
    {
        Results results = results_;
        for (const std::optional<CaseResult>& one : cases_)
            if (one) results.cases.push_back(*one);
        return results;
    }

private:
    Results results_;
    std::vector<std::optional<CaseResult>> cases_;
};

/// Runs the engines on one case after the other, and tells how it goes.
class Rounds
{
public:
    Rounds(const Plan& plan, int cases, const std::function<void(const Progress&)>& tell) : plan_(plan), tell_(tell)
    {
        progress_.total = cases * static_cast<int>(plan.engines.size()) * plan.runs;
    }

    void run(const PlannedCase& one, std::vector<Series>& all)
    {
        for (int round = 0; round < plan_.runs; ++round)
        {
            for (std::size_t place = 0; place < all.size(); ++place)
            {
                // Whoever comes first finds the machine as the round before left it: everybody does, in turn.
                const std::size_t turn = (place + static_cast<std::size_t>(round)) % all.size();
                progress_.now = one.scene + ", " + plan_.engines[turn].name + ", run " + std::to_string(round + 1) + " of " +
                                std::to_string(plan_.runs);
                if (tell_) tell_(progress_);
                if (all[turn].result.outcome == Outcome::Done) run_once(plan_, one, plan_.engines[turn], all[turn]);
                if (plan_.is_interrupted && plan_.is_interrupted()) throw std::runtime_error("interrupted");
                ++progress_.done;
                progress_.seconds_left = watch_.seconds() / progress_.done * (progress_.total - progress_.done);
            }
        }
    }

private:
    const Plan& plan_;
    const std::function<void(const Progress&)>& tell_;
    const Stopwatch watch_;
    Progress progress_;
};

} // namespace

std::vector<EngineProgram> programs_of(const std::vector<Engine>& engines)
{
    std::vector<EngineProgram> programs;
    for (const Engine& engine : engines)
        programs.push_back(
            {.name = engine.name, .fingerprint = engine.command.empty() ? std::string() : fingerprint_of_file(engine.command.front())});
    return programs;
}

Results run_experiment(const Plan& plan, const Evaluator& evaluate, const std::function<void(const Progress&)>& tell,
                       const std::function<void(const Results&)>& keep_part)
{
    std::filesystem::create_directories(plan.scratch);
    Finished finished(plan);
    Rounds rounds(plan, finished.open_cases(), tell);
    for (std::size_t i = 0; i < plan.cases.size(); ++i)
    {
        if (finished.has(i)) continue;
        std::vector<Series> all = start_series(plan);
        rounds.run(plan.cases[i], all);
        finished.add(i, finish(plan.cases[i], all, evaluate));
        if (keep_part && finished.open_cases() > 0) keep_part(finished.results());
    }
    return finished.results();
}

} // namespace carom::lab
