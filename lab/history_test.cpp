#include "lab/history.hpp"

#include <gtest/gtest.h>

namespace carom::lab
{

TEST(History, tests_neighbours_by_frames_and_by_runs)
{
    History history;
    history.origin = origin_here();
    history.scene = "A scene.";
    history.steps = 100;
    history.runs = 6;
    for (const double ms : {4.0, 2.0, 2.0})
    {
        Chapter chapter;
        chapter.name = "version " + std::to_string(history.chapters.size());
        for (int i = 0; i < 6; ++i) chapter.run_ms.push_back(ms * (1 + 0.001 * i));
        chapter.frame_ms.assign(100, ms);
        chapter.frame_ms.back() = 1.01 * ms;
        chapter.find_pairs_ms = 0.25 * ms;
        history.chapters.push_back(chapter);
    }
    const std::string text = history_text(history);
    EXPECT_NE(text.find("version 0 -> version 1"), std::string::npos) << text;
    EXPECT_NE(text.find("100 and 100 frames of one run each"), std::string::npos) << text;
    EXPECT_NE(text.find(": faster"), std::string::npos) << text;
    EXPECT_NE(text.find(": no difference"), std::string::npos) << text;
    EXPECT_NE(text.find("25.0 %"), std::string::npos) << text;
}

} // namespace carom::lab
