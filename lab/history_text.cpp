// The history as text, Markdown and JSON.
#include "lab/history.hpp"

#include "lab/report_tables.hpp"
#include "lab/results_json.hpp"

#include <sstream>

namespace carom::lab
{

using nlohmann::ordered_json;

namespace
{

const char* const reading = "Times are medians over the runs. A frame is a step and the drawing of its picture; the drawing is the same in "
                            "every version, so the faster the "
                            "physics, the less of a frame it is, and the less a frame gains from the next change. Fewer pairs tested is "
                            "not the same as less time: the naive "
                            "quadtree tests few because its leaves are small, and pays for them when it builds them and asks its set. "
                            "Memory is the most that the world held; "
                            "allocations are those of a step in the second half of a run.";

const char* const testing_words = "The author's test takes each frame of one run for a measurement of its own. Neighbouring frames are "
                                  "alike, and a whole run may be slow for reasons "
                                  "of the machine, so his intervals are too narrow. The proper unit is the run: its mean is one "
                                  "measurement, versions take turns, and the test is of "
                                  "as many measurements as there were runs.";

/// With line breaks between words, for a terminal.
std::string wrapped(const std::string& text)
{
    constexpr std::size_t width = 120;
    std::istringstream words(text);
    std::string out;
    std::size_t column = 0;
    for (std::string word; words >> word;)
    {
        const bool fits = column + 1 + word.size() <= width;
        if (column > 0) out += fits ? " " : "\n";
        column = column > 0 && fits ? column + 1 + word.size() : word.size();
        out += word;
    }
    return out + "\n";
}

std::string percent(double part, double whole) { return number_text(whole > 0 ? 100 * part / whole : 0) + " %"; }

Table version_table(const History& history)
{
    Table table({"version", "ms a frame", "ms a step", "of the frame", "ms to find pairs", "of the step", "pairs tested a step", "memory",
                 "allocations a step"});
    for (const Chapter& chapter : history.chapters)
    {
        const double frame = median(chapter.frame_ms);
        const double step = median(chapter.step_ms);
        const double find_pairs = median(chapter.find_pairs_ms);
        table.add({chapter.name, number_text(frame), number_text(step), percent(step, frame), number_text(find_pairs),
                   percent(find_pairs, step), number_text(chapter.pairs_tested), number_text(chapter.memory_bytes / 1e6) + " MB",
                   number_text(chapter.allocations)});
    }
    return table;
}

std::string p_text(double p) { return p < 1e-4 ? "< 0.0001" : number_text(p, 2); }

/// What somebody reads from a p value alone.
std::string verdict_of(const TTest& test)
{
    if (test.p >= 0.05) return std::string(name_of(Verdict::None));
    return std::string(name_of(test.difference < 0 ? Verdict::Faster : Verdict::Slower));
}

std::vector<std::string> row_of(const std::string& what, const Comparison& c)
{
    return {what,
            number_text(c.welch.difference),
            interval_text(c.welch.interval),
            number_text(c.welch.t),
            p_text(c.welch.p),
            p_text(c.mann_whitney_p),
            number_text(c.ratio),
            interval_text(c.interval),
            verdict_text(c)};
}

Table change_table(const History& history, std::size_t after)
{
    const Change change = change_to(history, after);
    const TTest& t = change.frames_of_one_run;
    const std::string runs = std::to_string(history.runs) + " + " + std::to_string(history.runs) + " runs, ";
    const std::string frames = std::to_string(history.steps) + " + " + std::to_string(history.steps) + " frames";
    Table table({"test", "difference [ms]", "95 % interval", "t", "p of t", "p of ranks", "ratio", "95 % interval", "it is"});
    table.add({"as he did it: " + frames + " of one run each, Student's t", number_text(t.difference), interval_text(t.interval),
               number_text(t.t), p_text(t.p), "", "", "", verdict_of(t)});
    table.add(row_of("as it should be: " + runs + "frames, Welch's t", change.frames));
    table.add(row_of("as it should be: " + runs + "steps alone, Welch's t", change.steps));
    return table;
}

std::string alarm_line(const History& history)
{
    const FalseAlarms alarms = false_alarms(history);
    return "A check on his test: between two runs of one version there is nothing to find. His finds a difference (p < 0.05) in " +
           std::to_string(alarms.found) + " of " + std::to_string(alarms.pairs) + " such pairs; a sound test would in about " +
           number_text(0.05 * alarms.pairs, 2) + ".";
}

std::string head_line(const History& history) { return origin_line(history.origin, "history", history.runs); }

std::string scene_line(const History& history)
{
    return history.scene + " " + std::to_string(history.steps) + " steps, " + number_text(history.seconds) + " s of the scene's time.";
}

std::string change_name(const History& history, std::size_t after)
{
    return history.chapters[after - 1].name + " -> " + history.chapters[after].name;
}

ordered_json json_of(const Interval& interval) { return {interval.low, interval.high}; }

ordered_json json_of(const TTest& t)
{
    return {{"t", t.t},
            {"degrees_of_freedom", t.degrees_of_freedom},
            {"p", t.p},
            {"difference_ms", t.difference},
            {"interval_ms", json_of(t.interval)}};
}

ordered_json json_of(const Comparison& c)
{
    return {{"welch", json_of(c.welch)}, {"student", json_of(c.student)},   {"mann_whitney_p", c.mann_whitney_p},
            {"ratio", c.ratio},          {"interval", json_of(c.interval)}, {"verdict", name_of(c.verdict)},
            {"is_noisy", c.is_noisy}};
}

ordered_json json_of(const Chapter& c)
{
    const double frame = median(c.frame_ms);
    const double step = median(c.step_ms);
    const double find_pairs = median(c.find_pairs_ms);
    return {{"name", c.name},
            {"what", c.what},
            {"broad_phase", name_of(c.broad_phase)},
            {"frame_ms", frame},
            {"step_ms", step},
            {"step_share_of_frame", step / frame},
            {"find_pairs_ms", find_pairs},
            {"find_pairs_share_of_step", find_pairs / step},
            {"pairs_tested", c.pairs_tested},
            {"memory_bytes", c.memory_bytes},
            {"allocations", c.allocations},
            {"run_frame_ms", c.frame_ms},
            {"run_step_ms", c.step_ms},
            {"run_find_pairs_ms", c.find_pairs_ms},
            {"frames_ms", c.frames_ms}};
}

} // namespace

std::string history_text(const History& history)
{
    std::string out = wrapped(head_line(history)) + wrapped(scene_line(history)) + "\n";
    for (std::size_t i = 0; i < history.chapters.size(); ++i)
        out += wrapped(std::to_string(i + 1) + ". " + history.chapters[i].name + ": " + history.chapters[i].what);
    out += "\n" + version_table(history).text() + "\n" + wrapped(reading) + "\n" + wrapped(testing_words) + wrapped(alarm_line(history));
    for (std::size_t i = 1; i < history.chapters.size(); ++i)
        out += "\n" + change_name(history, i) + "\n" + change_table(history, i).text();
    return out;
}

std::string history_markdown(const History& history)
{
    std::string out = "# From every pair to a tree\n\n" + head_line(history) + "\n\n" + scene_line(history) + "\n\n## The versions\n\n";
    for (std::size_t i = 0; i < history.chapters.size(); ++i)
        out += std::to_string(i + 1) + ". **" + history.chapters[i].name + "**: " + history.chapters[i].what + "\n";
    out += "\n" + version_table(history).markdown() + "\n" + reading + "\n\n## The tests\n\n" + testing_words + "\n\n" +
           alarm_line(history) + "\n";
    for (std::size_t i = 1; i < history.chapters.size(); ++i)
        out += "\n### " + change_name(history, i) + "\n\n" + change_table(history, i).markdown();
    return out;
}

std::string history_json(const History& history)
{
    ordered_json versions = ordered_json::array();
    for (const Chapter& chapter : history.chapters) versions.push_back(json_of(chapter));
    ordered_json changes = ordered_json::array();
    for (std::size_t i = 1; i < history.chapters.size(); ++i)
    {
        const Change change = change_to(history, i);
        changes.push_back({{"from", history.chapters[i - 1].name},
                           {"to", history.chapters[i].name},
                           {"frames_of_one_run", json_of(change.frames_of_one_run)},
                           {"frames_of_runs", json_of(change.frames)},
                           {"steps_of_runs", json_of(change.steps)}});
    }
    const FalseAlarms alarms = false_alarms(history);
    const ordered_json json = {{"carom_history", 1},
                               {"origin", json_of(history.origin)},
                               {"scene", history.scene},
                               {"steps", history.steps},
                               {"seconds", history.seconds},
                               {"runs", history.runs},
                               {"versions", versions},
                               {"changes", changes},
                               {"false_alarms", {{"pairs", alarms.pairs}, {"found", alarms.found}}}};
    return json.dump(1) + "\n";
}

} // namespace carom::lab
