// A measurement is kept when it would be made alike, and when it is not, the difference is named.
#include "lab/resume.hpp"

#include <gtest/gtest.h>

namespace carom::lab
{

namespace
{

class ResumeTest : public ::testing::Test
{
protected:
    ResumeTest()
    {
        plan.suite = "quick";
        plan.runs = 4;
        plan.engines = {{.name = "gone", .command = {}, .missing = ""}};
        for (const char* scene : {"a", "b"})
        {
            plan.cases.push_back({.scene = scene, .what = "", .file = scene, .fingerprint = scene});
            EngineResult engine;
            engine.engine = "gone";
            results.cases.push_back({.scene = scene, .what = "", .engines = {engine}, .fingerprint = scene});
        }
        results.origin = here;
        results.suite = "quick";
        results.runs = 4;
        results.engines = programs_of(plan.engines);
    }

    const Origin here = {
        .date = "", .processor = "p", .cores = 2, .system = "s", .compiler = "c", .flags = "f", .commit = "1+", .version = "v"};
    Plan plan;
    Results results;
};

} // namespace

TEST_F(ResumeTest, all_is_kept_when_nothing_changed)
{
    const Resumption all = resume(results, plan, here);
    EXPECT_EQ(all.kept.size(), 2u);
    EXPECT_EQ(all.why_not, "");
    EXPECT_TRUE(all.is_complete);
}

TEST_F(ResumeTest, nothing_is_kept_of_another_build_machine_or_setting)
{
    const auto expect = [&](const Origin& now, const std::string& words)
    {
        const Resumption none = resume(results, plan, now);
        EXPECT_TRUE(none.kept.empty());
        EXPECT_EQ(none.why_not, words);
        EXPECT_FALSE(none.is_complete);
    };
    Origin other = here;
    other.commit = "2";
    expect(other, "the commit was \"1+\" and is \"2\"");
    other = here;
    other.compiler = "d";
    expect(other, "the compiler was \"c\" and is \"d\"");
    other = here;
    other.flags = "";
    expect(other, "the flags was \"f\" and is unknown");
    other = here;
    other.cores = 3;
    expect(other, "the number of cores was \"2\" and is \"3\"");
    plan.runs = 5;
    expect(here, "the number of runs was \"4\" and is \"5\"");
    plan.runs = 4;
    plan.engines.push_back({.name = "more", .command = {}, .missing = ""});
    expect(here, "the engines were \"gone\" and are \"gone,more\"");
    plan.engines = {{.name = "gone", .command = {"/bin/sh"}, .missing = ""}};
    expect(here, "the program of the engine gone is another one");
}

TEST_F(ResumeTest, a_scene_that_changed_or_failed_is_measured_again)
{
    plan.cases[0].fingerprint = "other";
    Resumption part = resume(results, plan, here);
    ASSERT_EQ(part.kept.size(), 1u);
    EXPECT_EQ(part.kept[0].scene, "b");
    EXPECT_EQ(part.why_not, "a: the scene is another one now");
    EXPECT_FALSE(part.is_complete);

    results.cases[1].engines[0].outcome = Outcome::Failed;
    part = resume(results, plan, here);
    EXPECT_TRUE(part.kept.empty());
    EXPECT_EQ(part.why_not, "a: the scene is another one now; b: an engine failed on it");
}

TEST_F(ResumeTest, what_is_not_planned_is_not_kept)
{
    plan.cases.pop_back();
    const Resumption part = resume(results, plan, here);
    EXPECT_EQ(part.kept.size(), 1u);
    EXPECT_FALSE(part.is_complete) << "the earlier file holds more";
}

} // namespace carom::lab
