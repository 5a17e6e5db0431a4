// Input files: what they do, and how their mistakes are named.
#include "cli/input_script.hpp"

#include "cli/errors.hpp"
#include "scenes/registry.hpp"

#include <gtest/gtest.h>

namespace carom::cli
{

namespace
{

InputScript parse(std::string_view text) { return InputScript::parse(text, "events.json", scenes::find_scene("gravity")); }

std::string message_of(std::string_view text)
{
    try
    {
        parse(text);
    }
    catch (const BadUsage& error)
    {
        return error.what();
    }
    return "no error";
}

} // namespace

TEST(InputScript, gives_events_at_their_steps)
{
    const InputScript script = parse(R"([
        {"step": 3, "pointer": "down", "button": "left", "x": 0, "y": 40},
        {"step": 1, "key": "C"},
        {"step": 3, "pointer": "wheel", "wheel": 2.5, "x": 0, "y": 0},
        {"step": 900, "pointer": "move", "x": 1e3, "y": -2}
    ])");
    EXPECT_EQ(script.size(), 4u);
    const auto scene = scenes::make_scene("gravity");
    script.apply(*scene, 0);
    EXPECT_GT(scene->world().body_count(), 1);
    script.apply(*scene, 1);
    EXPECT_EQ(scene->world().body_count(), 1);
    script.apply(*scene, 3);
    EXPECT_EQ(scene->world().body_count(), 2);
    EXPECT_GT(scene->parameters().real("size"), 1);
}

TEST(InputScript, takes_no_events) { EXPECT_EQ(parse("[]").size(), 0u); }

TEST(InputScript, names_the_line_of_broken_json)
{
    EXPECT_NE(message_of("[\n{\"step\": 1,\n}]").find("line 3"), std::string::npos) << message_of("[\n{\"step\": 1,\n}]");
    EXPECT_EQ(message_of("{}"), "--input: events.json: not an array; write [ {\"step\": ...}, ... ]");
    for (const char* text : {"", "[", "nonsense", "[1e999]", "\xff\xfe", "[{\"step\": 1, \"key\": \"\xc3\x28\"}]"})
        EXPECT_THROW(parse(text), BadUsage) << text;
}

TEST(InputScript, names_the_entry_and_the_field)
{
    const std::string good = R"({"step": 1, "key": "c"})";
    EXPECT_EQ(message_of("[" + good + ", 5]"), "--input: events.json, entry 2: is not an object; write {\"step\": ...}");
    EXPECT_EQ(message_of("[" + good + R"(, {"key": "c"}])"), "--input: events.json, entry 2: has no field \"step\"; add it");
    EXPECT_EQ(message_of(R"([{"step": -1, "key": "c"}])"),
              "--input: events.json, entry 1: field \"step\" is -1; give a whole number, 0 or more");
    EXPECT_EQ(message_of(R"([{"step": 1}])"),
              "--input: events.json, entry 1: needs one of the fields \"key\" and \"pointer\"; give the one that is meant");
    EXPECT_EQ(message_of(R"([{"step": 1, "pointer": "tap", "x": 0, "y": 0}])"),
              "--input: events.json, entry 1: field \"pointer\" is \"tap\"; give one of down, up, move, wheel");
    EXPECT_EQ(message_of(R"([{"step": 1, "pointer": "down", "button": "left", "x": "1", "y": 0}])"),
              "--input: events.json, entry 1: field \"x\" is \"1\"; give a number from -10000 to 10000");
    EXPECT_EQ(message_of(R"([{"step": 1, "pointer": "move", "button": "left", "x": 1, "y": 0}])"),
              "--input: events.json, entry 1: has an unknown field \"button\"; its fields are step, pointer, x, y");
    EXPECT_NE(message_of(R"([{"step": 1, "key": "z"}])").find("field \"key\" is \"z\"; the keys of gravity are 1, 2, 3"),
              std::string::npos);
}

TEST(InputScript, refuses_steps_and_places_that_are_out_of_range)
{
    for (const char* step : {"1.5", "1e10", "99999999999999999999", "true", "null", "\"1\""})
        EXPECT_THROW(parse("[{\"step\": " + std::string(step) + ", \"key\": \"c\"}]"), BadUsage) << step;
    EXPECT_THROW(parse(R"([{"step": 1, "pointer": "move", "x": 1e30, "y": 0}])"), BadUsage);
    EXPECT_THROW(parse(R"([{"step": 1, "pointer": "move", "x": 10001, "y": 0}])"), BadUsage); // a scene would ignore it
    EXPECT_EQ(parse(R"([{"step": 1, "pointer": "move", "x": 10000, "y": -10000}])").size(), 1u);
}

TEST(InputScript, words_what_is_no_json)
{
    EXPECT_EQ(message_of(""), "--input: events.json: the file is empty; write [ {\"step\": ...}, ... ]");
    EXPECT_EQ(message_of(" \n"), "--input: events.json: the file is empty; write [ {\"step\": ...}, ... ]");
    EXPECT_EQ(message_of("[1,").find("--input: events.json: not JSON: parse error at line 1, column 4"), 0u) << message_of("[1,");
}

TEST(InputScript, counts_events_from_a_step_on)
{
    const InputScript script = parse(R"([{"step": 4, "key": "c"}, {"step": 9, "key": "c"}, {"step": 4, "key": "1"}])");
    EXPECT_EQ(script.size(), 3u);
    EXPECT_EQ(script.count_from(4), 3u);
    EXPECT_EQ(script.count_from(5), 1u);
    EXPECT_EQ(script.count_from(10), 0u);
}

TEST(InputScript, refuses_deep_nesting)
{
    constexpr int depth = 200000;
    const std::string value = std::string(depth, '[') + std::string(depth, ']');
    EXPECT_NE(message_of(R"([{"step": 1, "key": )" + value + "}]").find("nested too deeply"), std::string::npos);
}

TEST(InputScript, quotes_only_the_start_of_a_long_value)
{
    const std::string text(1000000, 'a');
    EXPECT_LT(message_of(R"([{"step": 1, "key": ")" + text + "\"}]").size(), 1000u);
    EXPECT_LT(message_of(R"([{"step": 1, "key": "c", ")" + text + "\": 1}]").size(), 1000u);
    EXPECT_LT(message_of("[\"" + text + "\\x").size(), 1000u);
}

TEST(InputScript, refuses_an_endless_file) { EXPECT_THROW(InputScript::read("/dev/zero", scenes::find_scene("gravity")), BadUsage); }

TEST(InputScript, every_scene_has_an_example_that_can_be_played)
{
    for (const scenes::SceneInfo& info : scenes::all_scenes())
    {
        const auto folder = std::filesystem::path(CAROM_SOURCE_DIR) / "scenes" / "inputs";
        const InputScript script = InputScript::read(folder / (info.name + ".json"), info);
        EXPECT_GT(script.size(), 0u);
        const auto scene = scenes::make_scene(info.name);
        const auto untouched = scenes::make_scene(info.name);
        bool is_felt = false;
        for (int step = 0; step < 1500 && !is_felt; ++step)
        {
            script.apply(*scene, step);
            scene->step();
            untouched->step();
            is_felt = scene->world().hash() != untouched->world().hash();
        }
        EXPECT_TRUE(is_felt) << info.name << ": the input changes nothing";
    }
}

TEST(InputScript, names_a_file_that_is_not_there)
{
    EXPECT_THROW(InputScript::read("/no/such/file.json", scenes::find_scene("gravity")), BadUsage);
    EXPECT_THROW(InputScript::read("/tmp", scenes::find_scene("gravity")), BadUsage);
}

} // namespace carom::cli
