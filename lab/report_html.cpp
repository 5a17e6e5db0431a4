// A report as one page.
#include "lab/report.hpp"

#include "lab/plots.hpp"
#include "lab/report_tables.hpp"

namespace carom::lab
{

namespace
{

constexpr const char* head = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Carom against its peers</title>
<style>
body { font: 15px/1.5 system-ui, sans-serif; color: #1b2030; background: #fff; margin: 2rem auto; max-width: 84rem; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2.2rem; }
table { border-collapse: collapse; font-size: 0.9rem; }
th, td { padding: 0.25rem 0.7rem; border-bottom: 1px solid #dde2ec; text-align: left; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
tr:hover td { background: #f3f6fc; }
.scroll { overflow-x: auto; }
.plots { display: grid; grid-template-columns: repeat(auto-fill, minmax(34rem, 1fr)); gap: 1rem; }
.plots svg { width: 100%; height: auto; }
.warning { background: #fff3d6; padding: 0.6rem 1rem; border-radius: 0.4rem; }
</style>
</head>
<body>
)";

std::string section(const std::string& title, const std::string& content) { return "<h2>" + title + "</h2>\n" + content; }

std::string paragraph(const std::string& words) { return "<p>" + html_text(words) + "</p>\n"; }

std::string scrolling(const Table& table) { return "<div class=\"scroll\">" + table.html() + "</div>\n"; }

} // namespace

std::string report_html(const Report& report, const Plots& plots)
{
    std::string page = head;
    page += "<h1>Carom against its peers</h1>\n<p>" + html_text(origin_line(*report.results)) + "</p>\n" + paragraph(engines_line(report));
    if (report.is_noisy) page += "<p class=\"warning\">" + html_text(noise_line(report)) + "</p>\n";
    page += section("Means", scrolling(mean_table(report)));

    if (!plots.problem.empty()) page += "<p class=\"warning\">" + html_text(plots.problem) + "</p>\n";
    std::string figures;
    for (const Plot& plot : plots.drawn) figures += "<figure>" + plot.svg + "</figure>\n";
    if (!figures.empty()) page += section("Plots", "<div class=\"plots\">\n" + figures + "</div>\n");
    page += section("Times", paragraph(time_words(report)) + scrolling(time_table(report)));
    const Table parts = parts_table(report);
    if (!parts.is_empty()) page += section("Events and rays", paragraph(parts_words()) + scrolling(parts));
    page += section("Quality", paragraph(quality_words()) + scrolling(quality_table(report)));
    std::string differences;
    for (const std::string& line : difference_lines(report)) differences += "<li>" + html_text(line) + "</li>\n";
    if (!differences.empty()) page += section("Settings that differ", "<ul>\n" + differences + "</ul>\n");
    return page + "</body>\n</html>\n";
}

} // namespace carom::lab
