// Scene files that were spoilt in every way: each is loaded and plays, or is refused and leaves the world as it was.
#include "files/text.hpp"
#include "scene_file/everything_test.hpp"
#include "scene_file/writer.hpp"
#include "scenes/random.hpp"

#include <carom/scene_file.hpp>
#include <gtest/gtest.h>

namespace carom::scene_file
{

namespace
{

/// Pieces that do harm where they do not belong.
constexpr std::string_view pieces[] = {"null",
                                       "true",
                                       "-1",
                                       "0",
                                       "1e39",
                                       "-1e-40",
                                       "1e999",
                                       "4294967296",
                                       "18446744073709551615",
                                       "-9223372036854775808",
                                       "[]",
                                       "{}",
                                       "[1,2]",
                                       "\"static\"",
                                       "\"\\ud800\"",
                                       "\xff",
                                       "NaN",
                                       ",",
                                       ":",
                                       "[[[[[[[[[[[[[[[[",
                                       "\"radius\":1,",
                                       "1.5",
                                       "\"body\":0,",
                                       "2"};

class Spoiler
{
public:
    explicit Spoiler(std::uint64_t seed) : random_(seed) {}

    std::string spoilt(std::string text)
    {
        const int changes = random_.integer(1, 3);
        for (int i = 0; i < changes && !text.empty(); ++i) change(text);
        return text;
    }

private:
    void change(std::string& text)
    {
        const std::size_t at = place(text);
        switch (random_.integer(0, 16))
        {
        case 0: text[at] = static_cast<char>(random_.integer(0, 255)); return;
        case 1: text.erase(at, static_cast<std::size_t>(random_.integer(1, 40))); return;
        case 2: text.insert(at, piece()); return;
        case 3: text.insert(place(text), text.substr(at, static_cast<std::size_t>(random_.integer(1, 60)))); return;
        case 4: text.resize(at); return;
        case 5: replace_value(text, at); return;
        default: replace_digit(text, at); return;
        }
    }

    /// What still parses does more: puts another value where one is.
    void replace_value(std::string& text, std::size_t at)
    {
        const std::size_t start = text.find_first_of(":[,", at);
        if (start == std::string::npos) return;
        const std::size_t end = text.find_first_of(",]}", start + 1);
        if (end == std::string::npos) return;
        text.replace(start + 1, end - start - 1, piece());
    }

    /// What is still a scene, with another number somewhere.
    void replace_digit(std::string& text, std::size_t at)
    {
        const std::size_t digit = text.find_first_of("0123456789", at);
        if (digit != std::string::npos) text[digit] = static_cast<char>('0' + random_.integer(0, 9));
    }

    std::size_t place(const std::string& text) { return static_cast<std::size_t>(random_.integer(0, static_cast<int>(text.size()) - 1)); }
    std::string piece()
    {
        return std::string(pieces[static_cast<std::size_t>(random_.integer(0, static_cast<int>(std::size(pieces)) - 1))]);
    }

    scenes::Random random_;
};

} // namespace

TEST(SceneFiles, spoilt_ones_are_loaded_or_refused_and_change_nothing_then)
{
    const std::string text = scene_file_text(everything());
    World base({.gravity = {0, -3}, .length_unit = everything().world.length_unit});
    base.create_body({.type = BodyType::Static}, box(50, 1));
    base.create_body({.position = {0, 5}}, circle(0.5f));
    const std::uint64_t before = base.hash();
    Spoiler spoiler(5);
    int refused = 0;
    int played = 0;
    for (int i = 0; i < 4000; ++i)
    {
        const std::string spoilt = spoiler.spoilt(text);
        World world = base.copy();
        SceneLoadResult result = load_scene_text(world, spoilt, {.name = "spoilt.json"});
        if (!result)
        {
            ++refused;
            const std::string problem = result.problem.text();
            EXPECT_EQ(problem.substr(0, 12), "spoilt.json:");
            EXPECT_LT(problem.size(), 1000u);
            for (const std::string& words : {problem, result.problem.field, result.problem.message})
                EXPECT_EQ(words, files::printable_line(words)); // valid UTF-8 without control characters
            EXPECT_EQ(world.hash(), before) << problem;
            const bool is_of_this_world = result.problem.field == "world.length_unit" && result.problem.line > 0;
            const std::vector<SceneProblem> all = validate_scene_text(spoilt, 20, "spoilt.json");
            if (!is_of_this_world)
            {
                EXPECT_EQ(all.empty() ? "" : all.front().text(), problem);
            }
            for (const SceneProblem& one : all) EXPECT_EQ(one.text(), files::printable_line(one.text()));
            continue;
        }
        ++played;
        LoadedScene& scene = *result.scene;
        for (int step = 0; step < 12; ++step)
        {
            const std::optional<SceneProblem> problem = scene.play_events(world, step);
            EXPECT_TRUE(!problem || problem->line > 0);
            world.step(scene.time_step, scene.substeps);
        }
        const std::string saved = scene_text(world, {.names = &scene.names});
        EXPECT_EQ(saved.find("Speeds above"), std::string::npos); // no step leaves a body faster than a file can hold
        EXPECT_TRUE(validate_scene_text(saved).empty()) << spoilt;
    }
    EXPECT_GT(refused, 2000);
    EXPECT_GT(played, 200);
}

} // namespace carom::scene_file
