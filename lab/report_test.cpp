#include "lab/report.hpp"

#include "lab/plots.hpp"
#include "lab/table.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace carom::lab
{

namespace
{

EngineResult engine(const std::string& name, double ms, std::map<std::string, double> quality = {})
{
    EngineResult result;
    result.engine = name;
    result.version = "1";
    for (int i = 0; i < 8; ++i) result.run_ms.push_back(ms * (1 + 0.002 * i));
    result.curve_ms = {ms, ms};
    result.quality = std::move(quality);
    return result;
}

EngineResult absent(const std::string& name)
{
    EngineResult result;
    result.engine = name;
    result.outcome = Outcome::Missing;
    result.reason = "./dev peers builds it";
    return result;
}

Results some_results()
{
    Results results;
    results.origin = origin_here();
    results.suite = "test";
    results.runs = 8;
    for (const int bodies : {100, 1000})
    {
        CaseResult one;
        one.scene = "pile_" + std::to_string(bodies);
        one.bodies = bodies;
        one.steps = 60;
        const double ms = 0.01 * bodies;
        one.engines = {engine("carom", ms, {{"deepest_penetration_m", 0.004}, {"escapes", 0}}),
                       engine("sloppy", 0.5 * ms, {{"deepest_penetration_m", 0.05}, {"escapes", 3}}), engine("slow", 4 * ms),
                       absent("gone")};
        results.cases.push_back(one);
    }
    return results;
}

} // namespace

TEST(Report, tells_how_many_times_faster_the_base_is)
{
    const Results results = some_results();
    const Report report = evaluate(results);
    ASSERT_EQ(report.cases.size(), 2u);
    const ReportRow& slow = report.cases[0].rows[2];
    EXPECT_NEAR(slow.comparison->ratio, 4, 1e-9);
    EXPECT_EQ(slow.comparison->verdict, Verdict::Slower);
    EXPECT_FALSE(report.cases[0].rows[0].comparison) << "the base is not set against itself";
    ASSERT_EQ(report.means.size(), 2u);
    EXPECT_NEAR(report.means[0].ratio, 0.5, 1e-9);
    EXPECT_EQ(report.means[0].cases, 2);
    EXPECT_FALSE(report.is_noisy);
}

TEST(Report, has_means_of_each_suite_where_there_are_several)
{
    Results results = some_results();
    results.cases[0].suite = "ordinary";
    results.cases[1].suite = "box2d";
    results.cases[1].engines[2] = engine("slow", 10 * 8);
    const Report report = evaluate(results);
    std::map<std::string, double> slow;
    for (const ReportMean& mean : report.means)
        if (mean.engine == "slow") slow[mean.suite] = mean.ratio;
    ASSERT_EQ(slow.size(), 3u);
    EXPECT_NEAR(slow["ordinary"], 4, 1e-9);
    EXPECT_NEAR(slow["box2d"], 8, 1e-9);
    EXPECT_NEAR(slow["all"], std::sqrt(32.0), 1e-9);
}

TEST(Report, a_faster_engine_with_worse_quality_is_shown_as_such)
{
    const Results results = some_results();
    const Report report = evaluate(results);
    const ReportRow& sloppy = report.cases[0].rows[1];
    EXPECT_EQ(sloppy.comparison->verdict, Verdict::Faster);
    EXPECT_EQ(sloppy.worse_in, (std::vector<std::string>{"deepest_penetration_m", "escapes"}));
    EXPECT_TRUE(sloppy.better_in.empty());
    EXPECT_NE(report_text(report).find("worse: deepest_penetration_m, escapes"), std::string::npos);
}

TEST(Report, what_is_too_small_to_matter_is_not_worse)
{
    Results results = some_results();
    results.cases[0].engines[0].quality["deepest_penetration_m"] = 0.0001;
    results.cases[0].engines[1].quality["deepest_penetration_m"] = 0.0009;
    const Report report = evaluate(results);
    EXPECT_EQ(report.cases[0].rows[1].worse_in, (std::vector<std::string>{"escapes"}));
}

TEST(Report, names_the_missing_in_every_format)
{
    const Results results = some_results();
    const Report report = evaluate(results);
    for (const std::string& text : {report_text(report), report_markdown(report, {}, "plots"), report_html(report, {})})
    {
        EXPECT_NE(text.find("missing"), std::string::npos);
        EXPECT_NE(text.find("./dev peers builds it"), std::string::npos);
        EXPECT_NE(text.find(results.origin.processor), std::string::npos);
    }
}

TEST(Report, names_each_version_once_in_every_format)
{
    Results results = some_results();
    for (CaseResult& one : results.cases)
    {
        one.engines[1].version = "3.2.0 (1234567)";
        one.engines[2].version = "3.2.0 (89abcde)";
    }
    const Report report = evaluate(results);
    for (const std::string& text : {report_text(report), report_markdown(report, {}, "plots"), report_html(report, {})})
        EXPECT_NE(text.find("Engines: carom 1; sloppy 3.2.0 (1234567); slow 3.2.0 (89abcde)."), std::string::npos) << text;
}

TEST(Report, shows_plots_and_says_when_it_has_none)
{
    const Results results = some_results();
    const Report report = evaluate(results);
    const Plots plots{.drawn = {{.kind = PlotKind::Ratio, .title = "ratios", .file = "ratios.svg", .svg = "<svg>1</svg>"},
                                {.kind = PlotKind::Curve, .title = "pile", .file = "pile.svg", .svg = "<svg>2</svg>"}},
                      .problem = "one is missing"};
    const std::string page = report_html(report, plots);
    for (const char* part : {"<svg>1</svg>", "<svg>2</svg>", "one is missing"}) EXPECT_NE(page.find(part), std::string::npos) << part;
    const std::string text = report_markdown(report, plots, "pictures");
    EXPECT_NE(text.find("![ratios](pictures/ratios.svg)"), std::string::npos);
    EXPECT_EQ(text.find("pile.svg"), std::string::npos) << "there are too many of them for a text";
}

TEST(Report, tells_apart_what_a_step_is_made_of)
{
    Results results = some_results();
    EXPECT_EQ(report_text(evaluate(results)).find("rays"), std::string::npos) << "no scene has any";
    EngineResult& carom = results.cases[0].engines[0];
    carom.event_ms = 0.25;
    carom.ray_ms = 0.5;
    carom.ray_hits = 77;
    const Report report = evaluate(results);
    const std::string text = report_text(report);
    EXPECT_NE(text.find("0.250"), std::string::npos) << text;
    EXPECT_NE(text.find("77"), std::string::npos);
    const nlohmann::json json = nlohmann::json::parse(report_json(report));
    EXPECT_EQ(json["cases"][0]["engines"][0]["ray_ms"], 0.5);
    EXPECT_EQ(json["cases"][0]["engines"][0]["ray_hits"], 77);
}

TEST(Report, is_json_for_machines)
{
    const Results results = some_results();
    const nlohmann::json json = nlohmann::json::parse(report_json(evaluate(results)));
    const nlohmann::json& slow = json["cases"][0]["engines"][2];
    EXPECT_NEAR(slow["speed_ratio"].get<double>(), 4, 1e-9);
    EXPECT_LE(slow["interval"][0].get<double>(), 4.001);
    EXPECT_GE(slow["interval"][1].get<double>(), 3.999);
    EXPECT_EQ(json["geometric_means"].size(), 2u);
    EXPECT_EQ(json["cases"][0]["engines"][3]["outcome"], "missing");
}

TEST(Report, compares_two_builds_engine_by_engine)
{
    const Results old = some_results();
    Results slower = some_results();
    for (double& ms : slower.cases[0].engines[0].run_ms) ms *= 1.05;
    const std::string text = compare_text(old, slower);
    EXPECT_NE(text.find("slower"), std::string::npos) << text;
    EXPECT_NE(text.find("1.050"), std::string::npos) << text;
    EXPECT_EQ(compare_text(old, old).find("slower"), std::string::npos);
}

TEST(Table, lays_columns_out)
{
    Table table({"name", "ms"});
    table.add({"a <b>", "12"});
    table.add({"long name", "3.5", "more"});
    EXPECT_EQ(table.text(), "name       ms\na <b>       12\nlong name  3.5  more\n");
    EXPECT_NE(table.html().find("a &lt;b&gt;"), std::string::npos);
    EXPECT_NE(table.markdown().find("|---|---|---|\n"), std::string::npos);
}

TEST(Table, writes_numbers_with_the_digits_that_matter)
{
    EXPECT_EQ(number_text(1234.5), "1234");
    EXPECT_EQ(number_text(4.567), "4.57");
    EXPECT_EQ(number_text(0.012345), "0.0123");
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(-0.5), "-0.500");
    EXPECT_EQ(number_text(1.5e-9), "1.50e-09");
}

} // namespace carom::lab
