// Scene files that were spoilt in every way: each is read or refused, what is read is played or refused, and nothing else happens.
#include "scenes/random.hpp"

#include "scene_file/everything_test.hpp"
#include "scene_file/player.hpp"
#include "scene_file/reader.hpp"
#include "scene_file/writer.hpp"

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

TEST(SceneFiles, spoilt_ones_are_read_or_refused)
{
    const std::string text = scene_file_text(everything());
    Spoiler spoiler(5);
    int refused = 0;
    int played = 0;
    for (int i = 0; i < 4000; ++i)
    {
        const std::string spoilt = spoiler.spoilt(text);
        try
        {
            FilePlayer player(parse_scene_file(spoilt, "spoilt.json"), "spoilt.json");
            for (int step = 0; step < 12; ++step) player.step();
            scene_file_text(player.file());
            ++played;
        }
        catch (const SceneFileError& error)
        {
            EXPECT_EQ(std::string_view(error.what()).substr(0, 12), "spoilt.json:");
            EXPECT_LT(std::string_view(error.what()).size(), 1000u);
            ++refused;
        }
    }
    EXPECT_GT(refused, 2000);
    EXPECT_GT(played, 200);
}

} // namespace carom::scene_file
