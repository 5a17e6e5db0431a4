// Sets the program against itself.
#include "lab/self_check.hpp"

#include "lab/report_tables.hpp"

#include <algorithm>
#include <stdexcept>

namespace carom::lab
{

namespace
{

/// @param slowdown of B
Comparison compare_with_itself(const SelfCheckPlan& plan, double slowdown, Origin& origin, const std::function<void(const Progress&)>& tell)
{
    const std::vector<std::string> step = {plan.carom.string(), "lab", "step"};
    std::vector<std::string> slowed = step;
    if (slowdown > 0) slowed.insert(slowed.end(), {"--slowdown", std::to_string(slowdown)});
    const Plan experiment{.suite = "selfcheck",
                          .cases = {plan.scene},
                          .engines = {{.name = "A", .command = step, .missing = ""}, {.name = "B", .command = slowed, .missing = ""}},
                          .runs = plan.runs,
                          .scratch = plan.scratch,
                          .is_interrupted = plan.is_interrupted};
    const Results results = run_experiment(experiment, {}, tell);
    origin = results.origin;
    const std::vector<EngineResult>& sides = results.cases.front().engines;
    for (const EngineResult& side : sides)
        if (side.outcome != Outcome::Done) throw std::runtime_error(side.engine + ": " + side.reason);
    return compare(sides[0].run_ms, sides[1].run_ms);
}

std::vector<std::string> comparison_row(const std::string& name, const Comparison& c)
{
    return {name,
            number_text(c.median_a),
            number_text(c.median_b),
            number_text(c.ratio, 4),
            interval_text(c.interval, 4),
            number_text(c.mann_whitney_p, 2),
            number_text(c.student.p, 2),
            number_text(c.welch.p, 2),
            verdict_text(c)};
}

} // namespace

int SelfCheck::false_alarms() const
{
    return static_cast<int>(std::count_if(same.begin(), same.end(), [](const Comparison& c) { return c.verdict != Verdict::None; }));
}

bool SelfCheck::is_passed() const
{
    const int allowed = std::max(1, static_cast<int>(same.size()) / 20);
    return false_alarms() <= allowed && planted.verdict == Verdict::Slower && planted.interval.contains(1 + plan.slowdown);
}

SelfCheck run_self_check(const SelfCheckPlan& plan, const std::function<void(const Progress&)>& tell)
{
    SelfCheck check{.origin = {}, .plan = plan, .same = {}, .planted = {}};
    // Counts through all comparisons.
    Progress whole;
    whole.total = 2 * plan.runs * (plan.tries + 1);
    const auto tell_of = [&](int number)
    {
        return [&, number](const Progress& part)
        {
            whole.done = 2 * plan.runs * number + part.done;
            const double left = part.seconds_left / std::max(part.total - part.done, 1); // a run
            whole.seconds_left = left * (whole.total - whole.done);
            whole.now =
                (number < plan.tries ? "A against A, try " + std::to_string(number + 1) : std::string("slowed down")) + ": " + part.now;
            if (tell) tell(whole);
        };
    };
    for (int i = 0; i < plan.tries; ++i) check.same.push_back(compare_with_itself(plan, 0, check.origin, tell_of(i)));
    check.planted = compare_with_itself(plan, plan.slowdown, check.origin, tell_of(plan.tries));
    return check;
}

std::string self_check_text(const SelfCheck& check)
{
    Table table({"try", "A ms", "B ms", "B / A", "95% interval", "Mann-Whitney p", "Student p", "Welch p", "B is"});
    for (std::size_t i = 0; i < check.same.size(); ++i) table.add(comparison_row(std::to_string(i + 1), check.same[i]));
    const std::string percent = number_text(100 * check.plan.slowdown, 2) + "%";
    table.add(comparison_row("B slowed by " + percent, check.planted));
    const bool is_found = check.planted.verdict == Verdict::Slower;
    return origin_line(check.origin, "selfcheck on " + check.plan.scene.scene, check.plan.runs) + "\n\n" + table.text() +
           "\nThe same program against itself: a difference in " + std::to_string(check.false_alarms()) + " of " +
           std::to_string(check.same.size()) + " tries. A slowdown of " + percent + (is_found ? " was found" : " was NOT found") + ".\n" +
           (check.is_passed() ? "The laboratory can be trusted here.\n"
                              : "The laboratory can't be trusted here now: is the machine busy?\n");
}

} // namespace carom::lab
