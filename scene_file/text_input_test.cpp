// What no scene file holds is refused where it stands, before more of the file is read.
#include "scene_file/reader.hpp"

#include <gtest/gtest.h>

namespace carom::scene_file
{

namespace
{

using namespace std::string_literals;

std::string problem_of(std::string_view text)
{
    try
    {
        parse_scene_file(text, "scene.json");
    }
    catch (const SceneFileError& error)
    {
        return error.what();
    }
    return "no problem";
}

/// ASCII text in another encoding, without a mark.
std::string widened(std::string_view text, std::size_t width, std::size_t place)
{
    std::string wide;
    for (const char c : text)
    {
        std::string unit(width, '\0');
        unit[place] = c;
        wide += unit;
    }
    return wide;
}

/// How many bytes are read of a file without an end before it is refused.
struct Endless
{
    std::size_t bytes = 0;
    std::string problem;
};

Endless refused(const std::string& start, const std::string& repeated)
{
    Endless result;
    std::string rest = start;
    const BlockSource source = [&](std::span<char> block)
    {
        while (rest.size() < block.size()) rest += repeated;
        const std::size_t count = rest.copy(block.data(), block.size());
        rest.erase(0, count);
        result.bytes += count;
        return count;
    };
    TextInput input(source, "scene.json");
    const ReadResult read_result = read(input, 1);
    if (!read_result.problems.empty()) result.problem = read_result.problems.front().text();
    return result;
}

} // namespace

TEST(TextInput, refuses_a_NUL_byte_wherever_it_is)
{
    EXPECT_EQ(problem_of("{\"carom_scene\": 1}\0 rubbish"s), "scene.json:1:19: syntax error: a NUL byte; a scene file is text");
    EXPECT_EQ(problem_of("{\"carom_scene\": 1,\n\"name\": \"a\0\"}"s), "scene.json:2:11: syntax error: a NUL byte; a scene file is text");
    EXPECT_EQ(problem_of("\0\0\0\0\0"s), "scene.json:1:1: syntax error: a NUL byte; a scene file is text");
    EXPECT_EQ(problem_of("{\"carom_scene\"\0: 1}"s), "scene.json:1:15: syntax error: a NUL byte; a scene file is text");
}

TEST(TextInput, says_which_encoding_to_save_a_file_in)
{
    const std::string scene = "{\"carom_scene\": 1}";
    for (const std::size_t place : {0u, 1u})
        EXPECT_EQ(problem_of(widened(scene, 2, place)), "scene.json:1:1: the file is UTF-16; save it as UTF-8");
    for (const std::size_t place : {0u, 3u})
        EXPECT_EQ(problem_of(widened(scene, 4, place)), "scene.json:1:1: the file is UTF-32; save it as UTF-8");
    EXPECT_EQ(problem_of("\xff\xfe" + widened(scene, 2, 0)), "scene.json:1:1: the file is UTF-16; save it as UTF-8");
    EXPECT_EQ(problem_of("\xfe\xff" + widened(scene, 2, 1)), "scene.json:1:1: the file is UTF-16; save it as UTF-8");
    EXPECT_EQ(problem_of("\xff\xfe\0\0"s + widened(scene, 4, 0)), "scene.json:1:1: the file is UTF-32; save it as UTF-8");
    EXPECT_EQ(problem_of("\0\0\xfe\xff"s + widened(scene, 4, 3)), "scene.json:1:1: the file is UTF-32; save it as UTF-8");
    EXPECT_EQ(problem_of("\xef\xbb\xbf" + scene), "no problem");
}

TEST(TextInput, counts_lines_and_characters)
{
    EXPECT_EQ(problem_of("{\"carom_scene\": 1, \"world\": {\"gravity\": [0,\n\n  1e999]}}"),
              "scene.json:3:3: world.gravity[1] is 1e999; give a number from -1000000 to 1000000 [m/s^2]");
    EXPECT_EQ(problem_of("{\"carom_scene\": 1, \"name\": \"\xc3\xa4\xc3\xb6\", \"steps\": 0}"),
              "scene.json:1:43: steps is 0; give a whole number from 1 to 1e+07");
    EXPECT_EQ(problem_of("{\"carom_scene\": 1,}").substr(0, 30), "scene.json:1:19: syntax error ");
    EXPECT_EQ(problem_of("{\"carom_scene\": 1, \"name\": \"\xff\"}").substr(0, 30), "scene.json:1:29: syntax error ");
    EXPECT_EQ(problem_of("{\"carom_scene\": 1, \"name\": \"\\ud800\"}").substr(0, 30), "scene.json:1:35: syntax error ");
    EXPECT_EQ(problem_of("{\"carom_scene\": 1} {}").substr(0, 30), "scene.json:1:20: syntax error ");
    const std::string whole = "{\"carom_scene\": 1, \"bodies\": [{\"name\": \"a\", \"shapes\": [{\"circle\": {\"radius\": 1}}]}]}";
    for (std::size_t size = 1; size < whole.size(); ++size)
        EXPECT_NE(problem_of(whole.substr(0, size)).find("syntax error"), std::string::npos) << size;
}

TEST(TextInput, refuses_at_the_first_token_or_limit)
{
    constexpr std::size_t two_blocks = 2 << 16;
    const Endless list = refused("[1", ",1");
    EXPECT_EQ(list.problem, "scene.json:1:1: the file is a list; write {\"carom_scene\": 1, ...}");
    EXPECT_LE(list.bytes, two_blocks);
    const Endless in_name = refused("{\"carom_scene\": 1, \"name\": [1", ",1");
    EXPECT_EQ(in_name.problem, "scene.json:1:28: name is a list; give a text in quotes");
    EXPECT_LE(in_name.bytes, two_blocks);
    const Endless nested = refused("{\"carom_scene\": 1, \"bodies\": ", "[");
    EXPECT_EQ(nested.problem, "scene.json:1:31: bodies[0] is a list; give an object in {}");
    EXPECT_LE(nested.bytes, two_blocks);
    const Endless name = refused("{\"carom_scene\": 1, \"name\": \"", "abcdefgh");
    EXPECT_EQ(name.problem, "scene.json:1:28: a text is longer than 64 KiB; make it shorter");
    EXPECT_LE(name.bytes, 6 * most_text_bytes + two_blocks);
    const Endless key = refused("{\"", "abcdefgh");
    EXPECT_EQ(key.problem, "scene.json:1:2: a text is longer than 64 KiB; make it shorter");
    const Endless number = refused("{\"carom_scene\": ", "1");
    EXPECT_EQ(number.problem, "scene.json:1:17: a number or word is longer than 1024 characters; make it shorter");
    EXPECT_LE(number.bytes, two_blocks);
    const Endless normals = refused("{\"carom_scene\": 1, \"bodies\": [{\"shapes\": [{\"polygon\": {\"vertices\": [[0,0]", ",[0,0]");
    EXPECT_EQ(normals.problem.substr(0, 71), "scene.json:1:68: bodies[0].shapes[0].polygon.vertices holds more than 8");
    EXPECT_LE(normals.bytes, two_blocks);
}

TEST(TextInput, limits_what_the_whole_file_holds)
{
    const Endless spaces = refused("{\"carom_scene\": 1", " \n");
    EXPECT_NE(spaces.problem.find("the file is longer than 256 MiB; make the scene smaller"), std::string::npos) << spaces.problem;
    const Endless changes = refused("{\"carom_scene\": 1, \"events\": [{\"step\": 0, \"destroy_bodies\": [0", ",0");
    EXPECT_NE(changes.problem.find("holds more than 1000000"), std::string::npos) << changes.problem;
}

} // namespace carom::scene_file
