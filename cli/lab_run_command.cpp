// `carom lab run` and the part of `carom lab compare` that measures programs: plans, measures, and reports.
#include "cli/errors.hpp"
#include "cli/lab_command.hpp"
#include "cli/lab_parts.hpp"
#include "files/folder_lock.hpp"
#include "files/temporary.hpp"
#include "files/text.hpp"
#include "lab/engines.hpp"
#include "lab/resume.hpp"
#include "scene_file/reader.hpp"

#include <charconv>
#include <stdexcept>

namespace carom::cli
{

namespace
{

using std::filesystem::path;

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

std::vector<lab::Engine> engines_of(const std::string& list, const path& peers)
{
    try
    {
        return lab::find_engines(list.empty() ? lab::default_engines(peers) : parts_of(list), own_program(), peers);
    }
    catch (const std::invalid_argument& error)
    {
        throw BadUsage(std::string("--engines: ") + error.what());
    }
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

std::string names_of(const std::vector<lab::CaseResult>& cases)
{
    std::string names;
    for (const lab::CaseResult& one : cases)
        names += (names.empty() ? "" : ", ") + one.scene + (one.threads > 1 ? " with " + std::to_string(one.threads) + " threads" : "");
    return names;
}

/// What is not kept of earlier results is not overwritten either.
void set_aside(const path& folder)
{
    const path file = folder / lab::results_file_name;
    const path name = folder / "results.previous.json";
    std::error_code error;
    std::filesystem::copy_file(file, name, std::filesystem::copy_options::overwrite_existing, error);
    if (error) throw Failure("can't copy " + files::quoted(file) + " to " + files::quoted(name) + ": " + error.message());
}

/// Finds in a folder what need not be measured again, and says what that is.
std::vector<lab::CaseResult> kept_cases(const lab::Plan& plan, const path& folder, const Surroundings& surroundings)
{
    const auto say = [&](const std::string& words) { surroundings.err << "carom: --resume: " << files::printable(words) << "\n"; };
    if (!std::filesystem::exists(folder / lab::results_file_name))
    {
        say("nothing is kept: there are no results in " + files::quoted(folder) + " yet");
        return {};
    }
    lab::Resumption found{.kept = {}, .why_not = {}, .is_complete = false};
    try
    {
        found = lab::resume(lab::read_results(folder), plan, lab::origin_here());
    }
    catch (const std::runtime_error& error)
    {
        found.why_not = error.what();
    }
    const std::string of_all = std::to_string(found.kept.size()) + " of " + std::to_string(plan.cases.size());
    if (found.kept.empty())
        say("nothing is kept" + (found.why_not.empty() ? std::string() : ": " + found.why_not));
    else
        say("kept " + of_all + ": " + names_of(found.kept) + (found.why_not.empty() ? "" : "; measured again: " + found.why_not));
    if (found.is_complete) return found.kept;
    set_aside(folder);
    say("the earlier results are in " + files::quoted(folder / "results.previous.json"));
    return found.kept;
}

/// Also of a measurement that is none: the report says what the engines said.
void report(const lab::Results& results, const std::string& base, const path& out, const path& scratch, const std::string& before,
            const std::string& after, const Surroundings& surroundings)
{
    const lab::Report report = lab::evaluate(results, base);
    write_report(report, draw_plots(report, scratch), out);
    surroundings.out << files::printable(before + report_text(report) + after);
    if (const std::string lack = lab::lack_of(results); !lack.empty()) throw Failure(lack);
}

/// What is compared when nothing was measured yet: two programs, or this one with several instruction sets.
std::vector<lab::Engine> sides_of(const LabCompareRequest& request)
{
    if (request.simd.empty())
        return {{.name = "A", .command = {request.a, "lab", "step"}, .missing = ""},
                {.name = "B", .command = {request.b, "lab", "step"}, .missing = ""}};
    std::vector<lab::Engine> sides;
    for (const std::string& name : parts_of(request.simd))
    {
        simd_of(name);
        sides.push_back({.name = name, .command = {own_program().string(), "lab", "step", "--simd", name}, .missing = ""});
    }
    if (sides.size() < 2) throw BadUsage("--simd: give two instruction sets or more, as sse2,avx2");
    return sides;
}

/// @throws BadUsage when they are not
void require_programs(const LabCompareRequest& request)
{
    std::error_code ignored;
    for (const std::string& program : {request.a, request.b})
        if (!std::filesystem::is_regular_file(program, ignored))
            throw BadUsage(files::quoted(program) + " is neither a folder of results nor a program; give two of one kind, or --simd");
}

} // namespace

void lab_run_command(const LabRunRequest& request, const Surroundings& surroundings)
{
    const lab::Suite suite = suite_of(request.suite, request.scenes);
    const std::vector<int> threads = threads_of(request.threads);
    const path out = request.out;
    const path peers = request.peers.empty() ? own_program().parent_path() / ".." / ".." / "peers" / "bin" : path(request.peers);
    lab::Plan plan{.suite = suite.name,
                   .cases = {},
                   .engines = engines_of(request.engines, peers.lexically_normal()),
                   .runs = request.runs,
                   .is_interrupted = surroundings.is_interrupted};
    const files::FolderLock lock("--out", out);
    const files::ScratchFolder scratch(out);
    plan.scratch = scratch.path();
    plan.cases = plan_cases(suite, threads, out / "scenes");
    if (request.resumes) plan.finished = kept_cases(plan, out, surroundings);
    const lab::Results results = measure(plan, suite, out, surroundings);
    report(results, "carom", out, scratch.path(), "", "\n" + (out / "report.html").string() + "\n", surroundings);
}

void lab_compare_command(const LabCompareRequest& request, const Surroundings& surroundings)
{
    std::error_code ignored;
    if (!request.simd.empty() && !request.a.empty()) throw BadUsage("--simd compares this program with itself; leave A and B out");
    const bool are_folders = std::filesystem::is_directory(request.a, ignored) && std::filesystem::is_directory(request.b, ignored);
    if (are_folders)
    {
        surroundings.out << files::printable(lab::compare_text(results_in(request.a), results_in(request.b)));
        return;
    }
    if (request.simd.empty()) require_programs(request);
    const std::vector<lab::Engine> sides = sides_of(request);
    if (request.out.empty()) throw BadUsage("--out is missing: something is measured, and the results go into a folder");
    const lab::Suite suite = suite_of(request.suite, request.scenes);
    const path out = request.out;
    const files::FolderLock lock("--out", out);
    const files::ScratchFolder scratch(out);
    lab::Plan plan{.suite = suite.name,
                   .cases = plan_cases(suite, {1}, out / "scenes"),
                   .engines = sides,
                   .runs = request.runs,
                   .scratch = scratch.path(),
                   .is_interrupted = surroundings.is_interrupted};
    const lab::Results results = measure(plan, suite, out, surroundings);
    const std::string head = request.simd.empty() ? "A: " + request.a + "\nB: " + request.b + "\n" : std::string();
    report(results, sides.front().name, out, scratch.path(), head, "", surroundings);
}

} // namespace carom::cli
