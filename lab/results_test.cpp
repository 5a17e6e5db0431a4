#include "lab/results.hpp"

#include <gtest/gtest.h>
#include <stdexcept>
#include <unistd.h>

namespace carom::lab
{

namespace
{

Results results_to_keep()
{
    Results results;
    results.origin = origin_here();
    results.suite = "quick";
    results.runs = 2;
    CaseResult one{.suite = "box2d", .scene = "pyramid", .what = "boxes", .bodies = 55, .steps = 100, .threads = 2, .engines = {}};
    one.engines.push_back({.engine = "carom",
                           .version = "0.1.0",
                           .outcome = Outcome::Done,
                           .reason = "",
                           .differences = {},
                           .run_ms = {0.5, 0.25},
                           .curve_ms = {0.125, 1},
                           .quality = {{"deepest_penetration_m", 0.004}}});
    one.engines.push_back({.engine = "other",
                           .version = "",
                           .outcome = Outcome::CanNot,
                           .reason = "has no pulleys",
                           .differences = {"friction is mixed otherwise"},
                           .run_ms = {},
                           .curve_ms = {},
                           .quality = {}});
    results.cases.push_back(one);
    return results;
}

} // namespace

TEST(Results, survive_a_file)
{
    const Results results = results_to_keep();
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / ("carom_results_test_" + std::to_string(getpid())) / "deep";
    write_results(results, folder);
    const Results read = read_results(folder);
    EXPECT_EQ(to_json(read), to_json(results));
    ASSERT_TRUE(read.cases.front().find("other"));
    EXPECT_EQ(read.cases.front().find("other")->outcome, Outcome::CanNot);
    EXPECT_FALSE(read.cases.front().find("nobody"));
    std::filesystem::remove_all(folder.parent_path());
}

TEST(Results, say_what_they_are_not)
{
    EXPECT_THROW(results_from_json("{"), std::runtime_error);
    EXPECT_THROW(results_from_json("[]"), std::runtime_error);
    EXPECT_THROW(results_from_json(R"({"carom_results": 99})"), std::runtime_error);
    EXPECT_THROW(read_results("/nowhere"), std::runtime_error);
    std::string text = to_json(results_to_keep());
    text.replace(text.find("can't"), 5, "won't");
    EXPECT_THROW(results_from_json(text), std::runtime_error);
}

TEST(Results, are_no_measurement_when_an_engine_failed_and_none_was_done)
{
    Results results = results_to_keep();
    EXPECT_EQ(lack_of(results), "") << "one is done";
    results.cases.front().engines.front().outcome = Outcome::Failed;
    results.cases.front().engines.front().reason = "exit status 1";
    EXPECT_EQ(lack_of(results), "no engine finished pyramid, carom: exit status 1, other: has no pulleys");
    results.cases.front().engines.front().outcome = Outcome::Missing;
    EXPECT_EQ(lack_of(results), "no engine finished any scene");
    results.cases.push_back(results.cases.front());
    results.cases.back().engines.front().outcome = Outcome::Done;
    EXPECT_EQ(lack_of(results), "") << "what engines lack is no failure";
}

TEST(Results, say_of_which_scene_and_of_what_programs_they_are)
{
    Results results = results_to_keep();
    results.engines = {{.name = "carom", .fingerprint = "0123456789abcdef"}};
    results.cases.front().fingerprint = "fedcba9876543210";
    EXPECT_EQ(to_json(results_from_json(to_json(results))), to_json(results));
    results.cases.front().scene = "";
    EXPECT_THROW(results_from_json(to_json(results)), std::runtime_error);
}

TEST(Results, name_the_machine)
{
    const Origin here = origin_here();
    EXPECT_GE(here.cores, 1);
    EXPECT_FALSE(here.compiler.empty());
    EXPECT_FALSE(here.version.empty());
    EXPECT_NE(here.flags.find("-ffp-contract=off"), std::string::npos) << here.flags;
}

} // namespace carom::lab
