// Writes scripts for gnuplot and reads the pictures that it draws.
#include "lab/plots.hpp"

#include "files/output_file.hpp"
#include "lab/process.hpp"
#include "lab/table.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iomanip>
#include <map>
#include <optional>
#include <sstream>

namespace carom::lab
{

namespace
{

/// Can be told apart by eyes of every kind, and from white.
constexpr std::array colors = {"#d55e00", "#0072b2", "#009e73", "#aa4499", "#555555", "#56b4e9", "#b8860b"};

/// In gnuplot's double quotes.
std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (const char c : text)
    {
        if (c == '"' || c == '\\') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out + "\"";
}

/// A line of a plot.
struct Line
{
    std::string title;
    std::vector<std::pair<double, double>> points;
    std::size_t color = 0; ///< number of it
};

struct Drawing
{
    std::string title;
    std::string settings; ///< gnuplot's, a line each
    std::string style;    ///< "with lines"
    std::vector<Line> lines;
    int height = 340; ///< [pixels]
};

/// A plot that has a row for each name, from above to below: the n-th is at y = n.
Drawing rows_drawing(const std::string& title, const std::vector<std::string>& names, const std::string& settings, const std::string& style)
{
    constexpr int row = 15;   // [pixels]
    constexpr int rest = 110; // title and axis
    const int count = static_cast<int>(names.size());
    Drawing drawing{.title = title, .settings = settings, .style = style, .lines = {}, .height = std::max(200, rest + row * count)};
    drawing.settings += "set yrange [" + std::to_string(count) + ":-1]\nset ytics (";
    for (int i = 0; i < count; ++i)
        drawing.settings += (i > 0 ? ", " : "") + quoted(names[static_cast<std::size_t>(i)]) + " " + std::to_string(i);
    drawing.settings += ")\n";
    return drawing;
}

std::string script_of(const Drawing& drawing, const std::filesystem::path& out)
{
    std::ostringstream script;
    script << std::setprecision(9) << "set terminal svg size 640," << drawing.height << " noenhanced font 'sans,11' background '#ffffff'\n"
           << "set output " << quoted(out.string()) << "\nset title " << quoted(drawing.title) << "\n"
           << "set grid lc rgb '#dddddd'\nset key outside right\nset border 3\nset tics nomirror\n"
           << drawing.settings;
    for (std::size_t i = 0; i < drawing.lines.size(); ++i)
    {
        script << "$line" << i << " << end\n";
        for (const auto& [x, y] : drawing.lines[i].points) script << x << " " << y << "\n";
        script << "end\n";
    }
    script << "plot ";
    for (std::size_t i = 0; i < drawing.lines.size(); ++i)
        script << (i > 0 ? ", " : "") << "$line" << i << " " << drawing.style << " lw 2 lc rgb '"
               << colors[drawing.lines[i].color % colors.size()] << "' title " << quoted(drawing.lines[i].title);
    script << "\n";
    return script.str();
}

/// The element alone, without the head of an XML file.
std::string svg_in(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    const std::string all = text.str();
    const std::size_t start = all.find("<svg");
    return start == std::string::npos || all.find("</svg>") == std::string::npos ? std::string() : all.substr(start);
}

/// gnuplot names parts of its pictures alike, and in one page the first would stand for all.
std::string with_own_names(std::string svg, int number)
{
    const std::string own = "p" + std::to_string(number) + "_";
    for (const std::string& use :
         {std::string("id=\""), std::string("href=\"#"), std::string("href='#"), std::string("id='"), std::string("url(#")})
        for (std::size_t i = svg.find(use); i != std::string::npos; i = svg.find(use, i + use.size() + own.size()))
            svg.insert(i + use.size(), own);
    return svg;
}

/// "scaling of mixed, 1 thread" makes "scaling-of-mixed-1-thread.svg".
std::string file_name(const std::string& title)
{
    std::string name;
    for (const char c : title)
    {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        if (is_plain)
            name += c;
        else if (!name.empty() && name.back() != '-')
            name += '-';
    }
    while (!name.empty() && name.back() == '-') name.pop_back();
    return name + ".svg";
}

std::string threads_text(int threads) { return std::to_string(threads) + (threads == 1 ? " thread" : " threads"); }

/// The same for an engine in every plot.
std::size_t color_of(const Report& report, const std::string& engine)
{
    std::vector<std::string> engines;
    for (const CaseResult& one : report.results->cases)
        for (const EngineResult& result : one.engines)
            if (std::find(engines.begin(), engines.end(), result.engine) == engines.end()) engines.push_back(result.engine);
    return static_cast<std::size_t>(std::find(engines.begin(), engines.end(), engine) - engines.begin());
}

std::vector<Drawing> curves(const Report& report)
{
    std::vector<Drawing> drawings;
    for (const ReportCase& one : report.cases)
    {
        Drawing drawing;
        drawing.title = one.result->scene + ", " + threads_text(one.result->threads);
        drawing.settings = "set xlabel 'step'\nset ylabel 'ms a step'\nset yrange [0:*]\n";
        drawing.style = "with lines";
        for (const EngineResult& engine : one.result->engines)
        {
            if (engine.curve_ms.size() < 2) continue;
            Line line{.title = engine.engine, .points = {}, .color = color_of(report, engine.engine)};
            const double part = static_cast<double>(one.result->steps) / static_cast<double>(engine.curve_ms.size());
            for (std::size_t i = 0; i < engine.curve_ms.size(); ++i)
                line.points.emplace_back((static_cast<double>(i) + 0.5) * part, engine.curve_ms[i]);
            drawing.lines.push_back(std::move(line));
        }
        if (!drawing.lines.empty()) drawings.push_back(std::move(drawing));
    }
    return drawings;
}

/// "collisions_2000" is of the family "collisions".
std::string family_of(const std::string& scene)
{
    const std::size_t end = scene.find_last_not_of("0123456789");
    const bool has_size = end != std::string::npos && end + 1 < scene.size() && (scene[end] == '_' || scene[end] == '-');
    return has_size ? scene.substr(0, end) : std::string();
}

std::vector<Drawing> scalings(const Report& report)
{
    std::map<std::string, std::map<std::string, Line>> families; // by family and threads, then by engine
    for (const ReportCase& one : report.cases)
    {
        const std::string family = family_of(one.result->scene);
        if (family.empty()) continue;
        auto& lines = families[family + ", " + threads_text(one.result->threads)];
        for (const ReportRow& row : one.rows)
        {
            if (row.result->outcome != Outcome::Done) continue;
            Line& line = lines[row.result->engine];
            line.title = row.result->engine;
            line.color = color_of(report, row.result->engine);
            line.points.emplace_back(one.result->bodies, row.median_ms);
        }
    }
    std::vector<Drawing> drawings;
    for (auto& [name, lines] : families)
    {
        Drawing drawing{.title = "scaling of " + name,
                        .settings = "set logscale xy\nset xlabel 'bodies'\nset ylabel 'ms a step'\n",
                        .style = "with linespoints",
                        .lines = {}};
        for (auto& [engine, line] : lines)
        {
            std::sort(line.points.begin(), line.points.end());
            if (line.points.size() >= 2) drawing.lines.push_back(line);
        }
        if (!drawing.lines.empty()) drawings.push_back(std::move(drawing));
    }
    return drawings;
}

/// "tumbler, 2 threads", or the scene alone for one thread.
std::string case_name(const ReportCase& one)
{
    return one.result->scene + (one.result->threads > 1 ? ", " + threads_text(one.result->threads) : "");
}

/// How many times faster the base is, scene by scene, with intervals.
std::vector<Drawing> ratios(const Report& report)
{
    std::map<std::string, std::vector<std::pair<const ReportCase*, const Comparison*>>> engines;
    for (const ReportCase& one : report.cases)
        for (const ReportRow& row : one.rows)
            if (row.comparison) engines[row.result->engine].emplace_back(&one, &*row.comparison);
    std::vector<Drawing> drawings;
    for (const auto& [engine, cases] : engines)
    {
        std::vector<std::string> names;
        for (const auto& [one, comparison] : cases) names.push_back(case_name(*one));
        Drawing drawing = rows_drawing(report.base + " is faster than " + engine + " by", names,
                                       "set logscale x\nset xrange [*<0.5:2<*]\nunset key\nset xlabel 'times faster'\n"
                                       "set arrow from 1, graph 0 to 1, graph 1 nohead lc rgb '#888888'\n",
                                       "with linespoints pt 7 ps 0.6");
        for (std::size_t i = 0; i < cases.size(); ++i)
        {
            const Interval& interval = cases[i].second->interval;
            const auto place = static_cast<double>(i);
            drawing.lines.push_back(
                {"", {{interval.low, place}, {cases[i].second->ratio, place}, {interval.high, place}}, color_of(report, engine)});
        }
        drawings.push_back(std::move(drawing));
    }
    return drawings;
}

/// What each engine has of a metric, scene by scene; nothing when nobody has so much of it that it matters.
std::optional<Drawing> quality(const Report& report, const Metric& metric)
{
    std::vector<std::string> names;
    std::map<std::string, Line> lines;
    bool has_any = false;
    for (const ReportCase& one : report.cases)
    {
        const auto place = static_cast<double>(names.size());
        bool is_shown = false;
        for (const ReportRow& row : one.rows)
        {
            const auto value = row.result->quality.find(metric.name);
            if (row.result->outcome != Outcome::Done || value == row.result->quality.end()) continue;
            is_shown = true;
            has_any = has_any || value->second > metric.floor;
            Line& line = lines[row.result->engine];
            line.title = row.result->engine;
            line.color = color_of(report, row.result->engine);
            line.points.emplace_back(std::max(value->second, metric.floor), place);
        }
        if (is_shown) names.push_back(case_name(one));
    }
    if (!has_any) return std::nullopt;
    Drawing drawing = rows_drawing(metric.label, names,
                                   "set logscale x\nset xrange [" + std::to_string(metric.floor) +
                                       ":*]\nset xlabel 'at the left edge: that or less, which nobody minds'\n",
                                   "with points pt 7 ps 0.7");
    for (auto& [engine, line] : lines) drawing.lines.push_back(std::move(line));
    const auto is_later = [](const Line& a, const Line& b) { return a.color > b.color; }; // equal ones hide each other: the base is on top
    std::sort(drawing.lines.begin(), drawing.lines.end(), is_later);
    return drawing;
}

std::vector<Drawing> qualities(const Report& report)
{
    std::vector<Drawing> drawings;
    for (const Metric& metric : metrics())
        if (std::optional<Drawing> drawing = quality(report, metric)) drawings.push_back(std::move(*drawing));
    return drawings;
}

} // namespace

Plots draw_plots(const Report& report, const std::filesystem::path& scratch)
{
    std::vector<std::pair<PlotKind, Drawing>> drawings;
    const auto add = [&](PlotKind kind, std::vector<Drawing> more)
    {
        for (Drawing& drawing : more) drawings.emplace_back(kind, std::move(drawing));
    };
    add(PlotKind::Ratio, ratios(report));
    add(PlotKind::Scaling, scalings(report));
    add(PlotKind::Quality, qualities(report));
    add(PlotKind::Curve, curves(report));
    std::filesystem::create_directories(scratch);
    Plots plots;
    for (std::size_t i = 0; i < drawings.size(); ++i)
    {
        const auto& [kind, drawing] = drawings[i];
        const std::filesystem::path script = scratch / "plot.gp";
        const std::filesystem::path out = scratch / "plot.svg";
        std::error_code ignored;
        std::filesystem::remove(out, ignored);
        files::write_file("", script, script_of(drawing, out), {.is_durable = false});
        constexpr double patience = 30; // [s]
        const ProcessResult drawn = run_process({"gnuplot", script.string()}, patience);
        if (!drawn.is_started)
        {
            plots.problem = "gnuplot is not installed: there are no plots. On Debian or Ubuntu: apt install gnuplot-nox";
            break;
        }
        std::string svg = drawn.status == 0 ? svg_in(out) : std::string();
        if (svg.empty())
            plots.problem = "gnuplot could not draw \"" + drawing.title + "\": " + drawn.errors;
        else
            plots.drawn.push_back({.kind = kind,
                                   .title = drawing.title,
                                   .file = file_name(drawing.title),
                                   .svg = with_own_names(std::move(svg), static_cast<int>(i))});
    }
    return plots;
}

} // namespace carom::lab
