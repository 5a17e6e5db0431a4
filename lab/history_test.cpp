#include "lab/history.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace carom::lab
{

namespace
{

/// Six runs of 100 frames: slow and fast frames alternate around a mean that is a little larger in each run.
Chapter chapter_of(const std::string& name, double ms)
{
    Chapter chapter;
    chapter.name = name;
    chapter.what = "What it does.";
    chapter.pairs_tested = 1000;
    for (int run = 0; run < 6; ++run)
    {
        const double mean = ms * (1 + 0.002 * run);
        std::vector<double> frames;
        for (int i = 0; i < 100; ++i) frames.push_back(mean + (i % 2 == 0 ? 0.0002 : -0.0002) * ms);
        chapter.frames_ms.push_back(frames);
        chapter.frame_ms.push_back(mean);
        chapter.step_ms.push_back(0.5 * mean);
        chapter.find_pairs_ms.push_back(0.125 * mean);
    }
    return chapter;
}

History some_history()
{
    return {.origin = origin_here(),
            .scene = "A scene.",
            .steps = 100,
            .seconds = 1.5,
            .runs = 6,
            .chapters = {chapter_of("first", 4), chapter_of("second", 2), chapter_of("third", 2.0004)}};
}

} // namespace

TEST(History, tests_neighbours_by_frames_and_by_runs)
{
    const History history = some_history();
    const Change large = change_to(history, 1);
    EXPECT_NEAR(large.frames_of_one_run.difference, -2 * 1.01, 1e-9) << "of the last runs";
    EXPECT_EQ(large.frames.verdict, Verdict::Faster);
    EXPECT_NEAR(large.frames.ratio, 0.5, 1e-9);
    EXPECT_NEAR(large.steps.welch.difference, 0.5 * large.frames.welch.difference, 1e-9);

    const Change none = change_to(history, 2);
    EXPECT_LT(none.frames_of_one_run.p, 0.05) << "frames of one run hide how much runs differ";
    EXPECT_GT(none.frames.welch.p, 0.5);
    EXPECT_EQ(none.frames.verdict, Verdict::None);
}

TEST(History, counts_how_often_the_test_of_frames_finds_what_is_not_there)
{
    History history = some_history();
    const FalseAlarms all = false_alarms(history);
    EXPECT_EQ(all.pairs, 3 * 6 * 5 / 2);
    EXPECT_EQ(all.found, all.pairs);
    for (Chapter& chapter : history.chapters) chapter.frames_ms.assign(6, chapter.frames_ms.front());
    EXPECT_EQ(false_alarms(history).found, 0);
}

TEST(History, reads_the_same_as_text_markdown_and_json)
{
    const History history = some_history();
    for (std::string text : {history_text(history), history_markdown(history)})
    {
        std::replace(text.begin(), text.end(), '\n', ' '); // lines may end anywhere
        for (const char* words : {"A scene. 100 steps, 1.50 s", "first -> second", "second -> third", "100 + 100 frames of one run",
                                  "6 + 6 runs, steps alone", "50.0 %", "25.0 %", "45 of 45"})
            EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    }
    const nlohmann::json json = nlohmann::json::parse(history_json(history));
    EXPECT_EQ(json["versions"].size(), 3u);
    EXPECT_EQ(json["versions"][1]["frames_ms"].size(), 6u);
    EXPECT_NEAR(json["versions"][1]["step_share_of_frame"].get<double>(), 0.5, 1e-12);
    EXPECT_NEAR(json["versions"][1]["find_pairs_share_of_step"].get<double>(), 0.25, 1e-12);
    EXPECT_EQ(json["changes"][0]["frames_of_runs"]["verdict"], "faster");
    EXPECT_EQ(json["origin"]["flags"], history.origin.flags);
}

} // namespace carom::lab
