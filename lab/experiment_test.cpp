#include "lab/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace carom::lab
{

namespace
{

/// Engines that are shell scripts.
class ExperimentTest : public testing::Test
{
protected:
    void SetUp() override
    {
        folder_ = std::filesystem::path(testing::TempDir()) / ("carom_experiment_test_" + std::to_string(getpid()));
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// @param script sees the scene as $1 and the file to write as $7
    Engine engine(const std::string& name, const std::string& script)
    {
        const std::filesystem::path file = folder_ / (name + ".sh");
        std::ofstream(file) << "echo " << name << " >> " << (folder_ / "order").string() << "\n" << script << "\n";
        return {.name = name, .command = {"sh", file.string()}, .missing = ""};
    }
    Engine good(const std::string& name, const std::string& step_ms)
    {
        return engine(name, R"(echo '{"engine":"x","version":"1","differences":["d"],"step_ms":[)" + step_ms +
                                R"(],"samples":[{"step":2,"bodies":[[1,2,3,4,5,6],null,[null,0,0,0,0,0]]}]}' > "$7")");
    }
    Plan plan(std::vector<Engine> engines, int runs)
    {
        Plan plan;
        plan.suite = "test";
        plan.cases = {{.scene = "one", .what = "", .bodies = 3, .steps = 2, .threads = 1, .file = folder_ / "one.json"}};
        plan.engines = std::move(engines);
        plan.runs = runs;
        plan.scratch = folder_ / "scratch";
        return plan;
    }
    std::vector<std::string> order() const
    {
        std::ifstream in(folder_ / "order");
        std::vector<std::string> names;
        for (std::string name; in >> name;) names.push_back(name);
        return names;
    }

    std::filesystem::path folder_;
};

} // namespace

TEST_F(ExperimentTest, engines_take_turns_and_their_times_are_kept)
{
    const Results results = run_experiment(plan({good("a", "1,3"), good("b", "4,4")}, 3), {});
    EXPECT_EQ(order(), (std::vector<std::string>{"a", "b", "b", "a", "a", "b"}));
    const CaseResult& one = results.cases.at(0);
    EXPECT_EQ(one.find("a")->run_ms, (std::vector<double>{2, 2, 2}));
    EXPECT_EQ(one.find("a")->curve_ms, (std::vector<double>{1, 3}));
    EXPECT_EQ(one.find("b")->differences, (std::vector<std::string>{"d"}));
}

TEST_F(ExperimentTest, what_went_wrong_is_told_and_does_not_stop_the_others)
{
    const Results results = run_experiment(plan({engine("cannot", "echo hello >&2; echo 'has no pulleys' >&2; exit 3"),
                                                 engine("crash", "kill -ABRT $$"),
                                                 engine("silent", "exit 0"),
                                                 engine("liar", "echo '{\"engine\":1' > \"$7\""),
                                                 {.name = "gone", .command = {}, .missing = "install it"},
                                                 good("good", "1,1")},
                                                2),
                                           {});
    const CaseResult& one = results.cases.at(0);
    EXPECT_EQ(one.find("cannot")->outcome, Outcome::CanNot);
    EXPECT_EQ(one.find("cannot")->reason, "has no pulleys");
    EXPECT_EQ(one.find("crash")->outcome, Outcome::Failed);
    EXPECT_NE(one.find("crash")->reason.find("134"), std::string::npos) << one.find("crash")->reason;
    EXPECT_EQ(one.find("silent")->outcome, Outcome::Failed) << "it must not get the result of the engine before";
    EXPECT_EQ(one.find("liar")->outcome, Outcome::Failed);
    EXPECT_EQ(one.find("gone")->outcome, Outcome::Missing);
    EXPECT_EQ(one.find("gone")->reason, "install it");
    EXPECT_EQ(one.find("good")->run_ms.size(), 2u);
    const std::vector<std::string> ran = order();
    EXPECT_EQ(std::count(ran.begin(), ran.end(), "crash"), 1) << "it is not asked again";
}

TEST_F(ExperimentTest, the_evaluator_sees_the_samples)
{
    const auto evaluate = [](const PlannedCase& one, const EngineRun& run) -> std::map<std::string, double>
    {
        EXPECT_EQ(one.scene, "one");
        EXPECT_FALSE(run.samples.at(0).bodies.at(1));
        EXPECT_TRUE(std::isnan(run.samples.at(0).bodies.at(2)->x));
        return {{"x", run.samples.at(0).bodies.at(0)->x}};
    };
    const Results results = run_experiment(plan({good("a", "1,3")}, 1), evaluate);
    EXPECT_EQ(results.cases.at(0).find("a")->quality.at("x"), 1);
}

TEST_F(ExperimentTest, what_is_finished_is_kept_when_it_is_ended)
{
    Plan two = plan({good("a", "1,1"), good("b", "1,1")}, 2);
    two.cases.push_back(two.cases.front());
    two.cases.back().scene = "two";
    std::vector<std::size_t> kept;
    const auto tell = [](const Progress& progress)
    {
        if (progress.done == 6) throw std::runtime_error("interrupted");
    };
    const auto keep = [&](const Results& part) { kept.push_back(part.cases.size()); };
    EXPECT_THROW(run_experiment(two, {}, tell, keep), std::runtime_error);
    EXPECT_EQ(kept, (std::vector<std::size_t>{1}));
}

TEST_F(ExperimentTest, the_work_of_a_step_holds_its_events_and_rays)
{
    const Engine busy = engine("busy", R"(echo '{"engine":"x","version":"1","differences":[],"step_ms":[1,3],"event_ms":[0.5,0.5],)"
                                       R"("ray_ms":[1,3],"ray_hits":7,"samples":[]}' > "$7")");
    const Results results = run_experiment(plan({busy}, 2), {});
    const EngineResult& result = *results.cases.at(0).find("busy");
    EXPECT_EQ(result.run_ms, (std::vector<double>{4.5, 4.5}));
    EXPECT_EQ(result.curve_ms, (std::vector<double>{2.5, 6.5}));
    EXPECT_EQ(result.event_ms, 0.5);
    EXPECT_EQ(result.ray_ms, 2);
    EXPECT_EQ(result.ray_hits, 7);
}

TEST_F(ExperimentTest, a_result_of_another_scene_is_no_result)
{
    const auto of = [&](const std::string& scene)
    { return R"(echo '{"engine":"x","version":"1","differences":[],"step_ms":[1,3],"samples":[],"scene":")" + scene + R"("}' > "$7")"; };
    const Results results = run_experiment(
        plan({engine("other", of("/tmp/two.json")), engine("right", of((folder_ / "one.json").string())), good("silent", "1,1")}, 1), {});
    const CaseResult& one = results.cases.at(0);
    EXPECT_EQ(one.find("other")->outcome, Outcome::Failed);
    EXPECT_EQ(one.find("other")->reason, "its result is of the scene \"/tmp/two.json\"");
    EXPECT_EQ(one.find("right")->outcome, Outcome::Done) << one.find("right")->reason;
    EXPECT_EQ(one.find("silent")->outcome, Outcome::Done) << "peers of an older protocol do not tell";
}

TEST_F(ExperimentTest, what_an_engine_said_is_safe_to_print_and_to_store)
{
    const Results results = run_experiment(plan({engine("rude", "printf '\\033[2J\\377' >&2; exit 1")}, 1), {});
    EXPECT_EQ(results.cases.at(0).find("rude")->reason, "exit status 1: \\x1b[2J\\xff");
    EXPECT_EQ(to_json(results_from_json(to_json(results))), to_json(results));
}

TEST_F(ExperimentTest, what_was_measured_before_is_not_measured_again)
{
    Plan first = plan({good("a", "1,3")}, 2);
    first.cases.push_back(first.cases.front());
    first.cases.back().scene = "two";
    first.cases.push_back(first.cases.front());
    first.cases.back().threads = 2;
    Results before = run_experiment(first, {});
    EXPECT_EQ(order().size(), 6u);

    Plan second = first;
    second.finished = {before.cases[2], before.cases[0]};
    std::vector<std::size_t> kept;
    std::vector<int> totals;
    const Results after = run_experiment(second, {}, [&](const Progress& progress) { totals.push_back(progress.total); },
                                         [&](const Results& part) { kept.push_back(part.cases.size()); });
    EXPECT_EQ(order().size(), 8u) << "the second case alone";
    EXPECT_EQ(totals, (std::vector<int>{2, 2}));
    ASSERT_EQ(after.cases.size(), 3u);
    EXPECT_EQ(after.cases[0].scene, "one");
    EXPECT_EQ(after.cases[1].scene, "two");
    EXPECT_EQ(after.cases[2].threads, 2);
    EXPECT_EQ(after.engines.at(0).name, "a");
}

TEST_F(ExperimentTest, times_that_are_not_one_a_step_are_nonsense)
{
    const Engine short_run = good("short", "1");
    const Results of_one = run_experiment(plan({short_run}, 2), {});
    EXPECT_EQ(of_one.cases.at(0).find("short")->outcome, Outcome::Failed);
    EXPECT_EQ(of_one.cases.at(0).find("short")->reason, "it made 1 of 2 steps");
    const Engine liar =
        engine("liar", R"(echo '{"engine":"x","version":"1","differences":[],"step_ms":[1,3],"ray_ms":[1],"samples":[]}' > "$7")");
    const Results results = run_experiment(plan({liar}, 2), {});
    EXPECT_EQ(results.cases.at(0).find("liar")->outcome, Outcome::Failed);
}

TEST_F(ExperimentTest, progress_goes_from_nothing_to_all)
{
    std::vector<int> done;
    run_experiment(plan({good("a", "1,1"), good("b", "1,1")}, 2), {}, [&](const Progress& progress)
    {
        EXPECT_EQ(progress.total, 4);
        done.push_back(progress.done);
    });
    EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 3}));
}

TEST(EngineRun, survives_its_json)
{
    EngineRun run{.engine = "e", .version = "v", .differences = {}, .step_ms = {1, 2, 6}, .samples = {}};
    run.samples.push_back({.step = 3, .bodies = {BodySample{.x = 1, .y = 2, .angle = 3, .vx = 4, .vy = 5, .w = 6}, std::nullopt}});
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / ("carom_run_" + std::to_string(getpid()) + ".json");
    std::ofstream(file) << to_json(run);
    EXPECT_EQ(to_json(read_run(file)), to_json(run));
    EXPECT_EQ(run.mean_ms(), 3);
    EXPECT_EQ(run.curve(2), (std::vector<double>{1, 4}));
    std::filesystem::remove(file);
}

} // namespace carom::lab
