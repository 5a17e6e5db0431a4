// Reports as tables of text and as JSON.
#include "lab/report.hpp"

#include "lab/plots.hpp"
#include "lab/report_tables.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

namespace carom::lab
{

using nlohmann::ordered_json;

namespace
{

ordered_json json_of(const ReportRow& row)
{
    const EngineResult& result = *row.result;
    ordered_json json = {{"engine", result.engine}, {"version", result.version}, {"outcome", name_of(result.outcome)}};
    if (result.outcome != Outcome::Done)
        json["reason"] = result.reason;
    else
    {
        json["median_ms"] = row.median_ms;
        json["event_ms"] = result.event_ms;
        json["ray_ms"] = result.ray_ms;
        if (result.ray_hits) json["ray_hits"] = *result.ray_hits;
    }
    if (row.comparison)
    {
        const Comparison& c = *row.comparison;
        json["speed_ratio"] = c.ratio;
        json["interval"] = {c.interval.low, c.interval.high};
        json["mann_whitney_p"] = c.mann_whitney_p;
        json["student_p"] = c.student.p;
        json["welch_p"] = c.welch.p;
        json["verdict"] = name_of(c.verdict);
        json["is_noisy"] = c.is_noisy;
    }
    json["quality"] = result.quality;
    json["worse_in"] = row.worse_in;
    json["better_in"] = row.better_in;
    json["differences"] = result.differences;
    return json;
}

ordered_json json_of(const ReportCase& one)
{
    ordered_json engines = ordered_json::array();
    for (const ReportRow& row : one.rows) engines.push_back(json_of(row));
    return {{"scene", one.result->scene},
            {"threads", one.result->threads},
            {"bodies", one.result->bodies},
            {"steps", one.result->steps},
            {"engines", engines}};
}

} // namespace

std::string joined(const std::vector<std::string>& words, const std::string& between)
{
    std::string all;
    for (const std::string& word : words) all += (all.empty() ? "" : between) + word;
    return all;
}

std::string origin_line(const Origin& o, const std::string& suite, int runs)
{
    return "Suite " + suite + ", " + std::to_string(runs) + " runs of each engine in turns. Carom " + o.version +
           (o.commit.empty() ? "" : " at " + o.commit) + ", " + o.compiler + " " + o.flags + ". " + o.processor + ", " +
           std::to_string(o.cores) + " cores, " + o.system + ", " + o.date + ".";
}

std::string origin_line(const Results& results) { return origin_line(results.origin, results.suite, results.runs); }

std::string interval_text(const Interval& interval, int digits)
{
    return number_text(interval.low, digits) + " to " + number_text(interval.high, digits);
}

std::string verdict_text(const Comparison& comparison)
{
    return std::string(name_of(comparison.verdict)) + (comparison.is_noisy ? ", noisy" : "");
}

std::string noise_line(const Report& report)
{
    if (!report.is_noisy) return {};
    return "The machine was noisy: runs of one engine on one scene differ by more than 5%. Trust the intervals, and measure again on a "
           "quiet one.";
}

Table time_table(const Report& report)
{
    Table table({"scene", "bodies", "threads", "engine", "ms a step", report.base + " is faster by", "95% interval", "the engine is",
                 "its quality is, or why there is none"});
    for (const ReportCase& one : report.cases)
    {
        for (const ReportRow& row : one.rows)
        {
            const EngineResult& result = *row.result;
            std::vector<std::string> cells = {one.result->scene, std::to_string(one.result->bodies), std::to_string(one.result->threads),
                                              result.engine};
            if (result.outcome != Outcome::Done)
            {
                cells.insert(cells.end(), {name_of(result.outcome), "", "", "", result.reason});
                table.add(cells);
                continue;
            }
            cells.push_back(number_text(row.median_ms));
            if (const auto& c = row.comparison)
            {
                cells.push_back(number_text(c->ratio) + " x");
                cells.push_back(interval_text(c->interval));
                cells.push_back(verdict_text(*c));
            }
            else
                cells.insert(cells.end(), 3, "");
            std::string quality;
            if (!row.worse_in.empty()) quality = "worse: " + joined(row.worse_in, ", ");
            if (!row.better_in.empty()) quality += (quality.empty() ? "" : "; ") + ("better: " + joined(row.better_in, ", "));
            cells.push_back(quality);
            table.add(cells);
        }
    }
    return table;
}

Table parts_table(const Report& report)
{
    Table table({"scene", "threads", "engine", "its step, ms", "events, ms", "rays, ms", "rays that hit"});
    for (const ReportCase& one : report.cases)
    {
        for (const ReportRow& row : one.rows)
        {
            const EngineResult& result = *row.result;
            if (result.outcome != Outcome::Done || (result.event_ms <= 0 && result.ray_ms <= 0)) continue;
            table.add({one.result->scene, std::to_string(one.result->threads), result.engine,
                       number_text(row.median_ms - result.event_ms - result.ray_ms), number_text(result.event_ms),
                       number_text(result.ray_ms), result.ray_hits ? std::to_string(*result.ray_hits) : ""});
        }
    }
    return table;
}

std::string time_words(const Report& report)
{
    return "The time is the median of the runs' mean times a step. \"" + report.base +
           " is faster by\" is the time of the engine over that of " + report.base + ": above 1 when " + report.base +
           " is faster. Quality is set beside it: where an engine is clearly better or worse than " + report.base + ".";
}

std::string parts_words() { return "What the times above hold in scenes where bodies come, go or are set, and where rays are cast."; }

std::string quality_words()
{
    return "Less is better. One evaluator measures all engines, from where they had the bodies; empty where a measure does not fit the "
           "scene.";
}

Table quality_table(const Report& report)
{
    std::vector<const Metric*> shown; // those that someone has
    for (const Metric& metric : metrics())
        for (const CaseResult& one : report.results->cases)
            for (const EngineResult& engine : one.engines)
                if (engine.quality.count(metric.name) && std::find(shown.begin(), shown.end(), &metric) == shown.end())
                    shown.push_back(&metric);
    std::vector<std::string> head = {"scene", "threads", "engine"};
    for (const Metric* metric : shown) head.emplace_back(metric->label);
    Table table(head);
    for (const ReportCase& one : report.cases)
    {
        for (const ReportRow& row : one.rows)
        {
            if (row.result->outcome != Outcome::Done) continue;
            std::vector<std::string> cells = {one.result->scene, std::to_string(one.result->threads), row.result->engine};
            for (const Metric* metric : shown)
            {
                const auto place = row.result->quality.find(metric->name);
                cells.push_back(place == row.result->quality.end() ? "" : number_text(place->second));
            }
            table.add(cells);
        }
    }
    return table;
}

Table mean_table(const Report& report)
{
    Table table({"suite", "engine", "threads", "scenes", report.base + " is faster by (geometric mean)"});
    for (const ReportMean& mean : report.means)
        table.add({mean.suite, mean.engine, std::to_string(mean.threads), std::to_string(mean.cases), number_text(mean.ratio) + " x"});
    return table;
}

std::string engines_line(const Report& report)
{
    std::vector<std::string> engines; // few enough to search
    for (const CaseResult& one : report.results->cases)
    {
        for (const EngineResult& engine : one.engines)
        {
            const std::string words = engine.engine + " " + engine.version;
            if (!engine.version.empty() && std::find(engines.begin(), engines.end(), words) == engines.end()) engines.push_back(words);
        }
    }
    return engines.empty() ? std::string() : "Engines: " + joined(engines, "; ") + ".";
}

std::vector<std::string> difference_lines(const Report& report)
{
    std::set<std::string> lines;
    for (const CaseResult& one : report.results->cases)
        for (const EngineResult& engine : one.engines)
            for (const std::string& difference : engine.differences) lines.insert(engine.engine + ": " + difference);
    return {lines.begin(), lines.end()};
}

std::string report_text(const Report& report)
{
    std::string out = origin_line(*report.results) + "\n" + engines_line(report) + "\n";
    if (report.is_noisy) out += noise_line(report) + "\n";
    out += "\n" + time_table(report).text();
    const Table parts = parts_table(report);
    if (!parts.is_empty()) out += "\n" + parts.text();
    out += "\n" + quality_table(report).text() + "\n" + mean_table(report).text();
    const std::vector<std::string> differences = difference_lines(report);
    if (!differences.empty()) out += "\nSettings that differ:\n  " + joined(differences, "\n  ") + "\n";
    return out;
}

std::string report_markdown(const Report& report, const Plots& plots, const std::string& plot_folder)
{
    std::string out = "# Carom against its peers\n\n" + origin_line(*report.results) + "\n\n" + engines_line(report) + "\n\n";
    if (report.is_noisy) out += noise_line(report) + "\n\n";
    const auto pictures = [&](PlotKind kind)
    {
        std::string links;
        for (const Plot& plot : plots.drawn)
            if (plot.kind == kind) links += "![" + plot.title + "](" + plot_folder + "/" + plot.file + ")\n";
        return links.empty() ? links : "\n" + links;
    };
    out += "## Means\n\n" + mean_table(report).markdown() + pictures(PlotKind::Ratio) + pictures(PlotKind::Scaling);
    out += "\n## Times\n\n" + time_words(report) + "\n\n" + time_table(report).markdown();
    const Table parts = parts_table(report);
    if (!parts.is_empty()) out += "\n## Events and rays\n\n" + parts_words() + "\n\n" + parts.markdown();
    out += "\n## Quality\n\n" + quality_words() + "\n\n" + quality_table(report).markdown() + pictures(PlotKind::Quality);
    const std::vector<std::string> differences = difference_lines(report);
    if (!differences.empty()) out += "\n## Settings that differ\n\n- " + joined(differences, "\n- ") + "\n";
    return out;
}

std::string report_json(const Report& report)
{
    ordered_json cases = ordered_json::array();
    for (const ReportCase& one : report.cases) cases.push_back(json_of(one));
    ordered_json means = ordered_json::array();
    for (const ReportMean& mean : report.means)
        means.push_back({{"suite", mean.suite},
                         {"engine", mean.engine},
                         {"threads", mean.threads},
                         {"scenes", mean.cases},
                         {"speed_ratio", mean.ratio}});
    const Origin& o = report.results->origin;
    const ordered_json json = {
        {"suite", report.results->suite}, {"base", report.base}, {"runs", report.results->runs}, {"processor", o.processor},
        {"compiler", o.compiler},         {"flags", o.flags},    {"commit", o.commit},           {"date", o.date},
        {"is_noisy", report.is_noisy},    {"cases", cases},      {"geometric_means", means}};
    return json.dump(2) + "\n";
}

std::string compare_text(const Results& a, const Results& b, const ComparisonOptions& options)
{
    Table table({"scene", "threads", "engine", "A ms", "B ms", "B / A", "95% interval", "Mann-Whitney p", "B is"});
    bool is_noisy = false;
    for (const CaseResult& one : a.cases)
    {
        const auto is_it = [&](const CaseResult& c) { return c.scene == one.scene && c.threads == one.threads; };
        const auto other = std::find_if(b.cases.begin(), b.cases.end(), is_it);
        if (other == b.cases.end()) continue;
        for (const EngineResult& engine : one.engines)
        {
            const EngineResult* const same = other->find(engine.engine);
            if (!same || engine.run_ms.size() < 2 || same->run_ms.size() < 2) continue;
            const Comparison c = compare(engine.run_ms, same->run_ms, options);
            is_noisy = is_noisy || c.is_noisy;
            table.add({one.scene, std::to_string(one.threads), engine.engine, number_text(c.median_a), number_text(c.median_b),
                       number_text(c.ratio, 4), interval_text(c.interval, 4), number_text(c.mann_whitney_p, 2), verdict_text(c)});
        }
    }
    std::string out = "A: " + origin_line(a) + "\nB: " + origin_line(b) + "\n\n" + table.text();
    if (is_noisy) out += "\nThe machine was noisy: runs of one side differ by more than 5%.\n";
    return out;
}

} // namespace carom::lab
