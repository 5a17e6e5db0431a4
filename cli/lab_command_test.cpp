#include "cli/run_carom_test.hpp"
#include "lab/engine_run.hpp"
#include "lab/results.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <unistd.h>

namespace carom::cli
{

namespace
{

class LabCommandTest : public testing::Test
{
protected:
    void SetUp() override
    {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string& name) const { return (folder_ / name).string(); }

    /// Results of a run in which Carom took so long.
    std::string results(const std::string& name, double ms) const
    {
        lab::EngineResult engine;
        engine.engine = "carom";
        for (int i = 0; i < 8; ++i) engine.run_ms.push_back(ms * (1 + 0.001 * i));
        lab::CaseResult one;
        one.scene = "pile";
        one.engines = {engine};
        lab::Results all;
        all.suite = "quick";
        all.runs = 8;
        all.cases = {one};
        lab::write_results(all, folder_ / name);
        return path(name);
    }

    std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / ("carom_lab_command_test_" + std::to_string(getpid()));
};

} // namespace

TEST_F(LabCommandTest, steps_a_file_as_an_engine)
{
    ASSERT_EQ(carom({"export", "stack_20", path("stack.json"), "--set", "size=3", "--steps", "5"}).status, 0);
    const Outcome step = carom({"lab", "step", path("stack.json"), "--threads", "1", "--samples", "2", "--out", path("run.json")});
    EXPECT_EQ(step.status, 0) << step.err;
    const lab::EngineRun run = lab::read_run(path("run.json"));
    EXPECT_EQ(run.step_ms.size(), 5u);
    EXPECT_EQ(run.samples.size(), 2u);
    EXPECT_EQ(run.samples.back().bodies.size(), 4u);
}

TEST_F(LabCommandTest, draws_what_it_steps)
{
    ASSERT_EQ(carom({"export", "stack_20", path("stack.json"), "--set", "size=3", "--steps", "5"}).status, 0);
    const Outcome step = carom({"lab", "step", path("stack.json"), "--draw", "--out", path("run.json")});
    EXPECT_EQ(step.status, 0) << step.err;
    const lab::EngineRun run = lab::read_run(path("run.json"));
    ASSERT_EQ(run.draw_ms.size(), 5u);
    for (const double ms : run.draw_ms) EXPECT_GT(ms, 0.01) << "a picture is painted over";
}

TEST_F(LabCommandTest, compares_two_folders_of_results)
{
    const Outcome slower = carom({"lab", "compare", results("a", 1), results("b", 1.05)});
    EXPECT_EQ(slower.status, 0) << slower.err;
    EXPECT_NE(slower.out.find("slower"), std::string::npos) << slower.out;
    const Outcome same = carom({"lab", "compare", path("a"), path("a")});
    EXPECT_NE(same.out.find("no difference"), std::string::npos) << same.out;
}

TEST_F(LabCommandTest, reports_in_every_format)
{
    results("a", 1);
    const Outcome report = carom({"lab", "report", path("a")});
    EXPECT_EQ(report.status, 0) << report.err;
    for (const char* name : {"report.md", "report.html", "report.json"})
        EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "a" / name)) << name;
    std::filesystem::create_directories(folder_ / "benchmarks");
    std::ofstream(folder_ / "benchmarks" / "mine.txt") << "mine";
    EXPECT_EQ(carom({"lab", "report", path("a"), "--markdown", path("benchmarks.md")}).status, 0);
    EXPECT_TRUE(std::filesystem::is_regular_file(folder_ / "benchmarks.md"));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "benchmarks" / "mine.txt")) << "a folder that was there keeps what is in it";
    EXPECT_TRUE(std::filesystem::is_directory(folder_ / "benchmarks"));
    const Outcome json = carom({"lab", "report", path("a"), "--json"});
    EXPECT_NEAR(nlohmann::json::parse(json.out)["cases"][0]["engines"][0]["median_ms"].get<double>(), 1.0035, 1e-9);
}

TEST_F(LabCommandTest, says_what_can_not_be_had)
{
    const auto refused = [&](const std::vector<std::string>& arguments, const std::string& words)
    {
        const Outcome outcome = carom(arguments);
        EXPECT_EQ(outcome.status, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    };
    refused({"lab"}, "--help");
    refused({"lab", "run", "fast", "--out", path("x")}, "suite \"fast\" is not known; give one of box2d");
    refused({"lab", "run", "--scenes", "washer", "--out", path("x")}, "no scene \"washer\"; give some of large_pyramid");
    refused({"lab", "run", "--engines", "chipmunk", "--out", path("x")}, "give some of carom");
    refused({"lab", "run", "--threads", "0", "--out", path("x")}, "--threads: \"0\"");
    refused({"lab", "run", "--runs", "2", "--out", path("x")}, "--runs");
    refused({"lab", "selfcheck", "--scene", "stack_20,shots", "--out", path("x")}, "names 2; give one");
    results("a", 1);
    refused({"lab", "report", path("a"), "--markdown", path("a")}, "ends in .md");
    refused({"lab", "report", path("nothing")}, "carom lab run");
    refused({"lab", "compare", path("nothing"), path("nothing")}, "neither a folder");
    refused({"lab", "compare", path("a"), "--simd", "scalar,best", "--out", path("x")}, "leave A and B out");
    refused({"lab", "compare", "--simd", "scalar", "--out", path("x")}, "give two instruction sets");
    refused({"lab", "compare", "--simd", "scalar,mmx", "--out", path("x")}, "\"mmx\" is not on this machine");
    refused({"lab", "compare", "--simd", "scalar,best"}, "--out is missing");
    refused({"lab", "step", path("nothing.json"), "--out", path("y")}, "nothing.json");
    refused({"lab", "step", path("nothing.json"), "--broadphase", "Grid", "--out", path("y")}, "Quadtree");
}

} // namespace carom::cli
