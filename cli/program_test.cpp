// The command line as a person uses it, without starting a process.
#include "cli/run_carom_test.hpp"
#include "lab/field_scenes/field_scenes.hpp"
#include "scenes/registry.hpp"

#include <carom/report.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <unistd.h>

namespace carom::cli
{

using nlohmann::json;

namespace
{

/// An empty folder that goes away with the test.
class Program : public testing::Test
{
protected:
    Program() { std::filesystem::create_directory(folder_); }
    ~Program() override { std::filesystem::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }
    std::vector<std::string> files() const
    {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_)) names.push_back(entry.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    }

    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("carom_program_test_" + std::to_string(getpid()));
};

bool starts_with(const std::string& path, std::string_view bytes)
{
    std::ifstream file(path, std::ios::binary);
    std::string start(bytes.size(), '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    return start == bytes;
}

} // namespace

TEST_F(Program, lists_scenes_as_json)
{
    const Outcome outcome = carom({"scenes", "--json"});
    EXPECT_EQ(outcome.status, 0);
    const json scenes = json::parse(outcome.out);
    ASSERT_EQ(scenes.size(), carom::scenes::all_scenes().size());
    const auto collisions = std::find_if(scenes.begin(), scenes.end(), [](const json& s) { return s["name"] == "collisions"; });
    ASSERT_NE(collisions, scenes.end());
    const json circles = (*collisions)["parameters"][0];
    EXPECT_EQ(circles["name"], "circles");
    EXPECT_EQ(circles["kind"], "integer");
    EXPECT_EQ(circles["default"], 500);
    EXPECT_EQ(circles["range"], json({0, 20000}));
    EXPECT_FALSE((*collisions)["controls"].empty());
}

TEST_F(Program, lists_scenes_for_people)
{
    const Outcome outcome = carom({"scenes"});
    EXPECT_EQ(outcome.status, 0);
    for (const char* text : {"planets", "triggers", "collisions", "gravity", "circles=500", "an integer from 0 to 20000", "key f"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
}

TEST_F(Program, runs_a_scene_and_prints_one_object)
{
    const Outcome outcome =
        carom({"run", "collisions", "--set", "circles=50", "--set", "boxes=30", "--steps", "40", "--seed", "3", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const json run = json::parse(outcome.out);
    EXPECT_EQ(run["scene"], "collisions");
    EXPECT_EQ(run["parameters"]["circles"], 50);
    EXPECT_EQ(run["parameters"]["cover"], 34.0);
    EXPECT_EQ(run["seed"], 3);
    EXPECT_EQ(run["steps"], 40);
    EXPECT_EQ(run["bodies"], 81);
    EXPECT_EQ(run["shapes"], 84);
    EXPECT_EQ(run["hash"].get<std::string>().size(), 16u);
    EXPECT_GT(run["step_ms"]["mean"], 0);
    EXPECT_EQ(run["stage_ms"].size(), static_cast<std::size_t>(carom::stage_count));
    EXPECT_GT(run["memory"]["bytes"], 0);
    EXPECT_GT(run["broad_phase_stats"]["nodes"], 0);
    EXPECT_GE(run["broad_phase_stats"]["pairs_tested"], run["broad_phase_stats"]["pairs_found"]);
    for (const char* key : {"pairs", "contacts", "events", "version", "compiler", "build_type", "broad_phase", "broad_phase_stats"})
        EXPECT_TRUE(run.contains(key)) << key;
}

TEST_F(Program, the_broad_phase_does_not_change_the_hash)
{
    const auto hash_with = [](const std::string& name)
    { return json::parse(carom({"run", "gravity", "--steps", "30", "--json", "--broadphase", name}).out)["hash"]; };
    const json expected = hash_with("tree");
    for (const char* name : {"bruteforce", "QuadtreeNaive", "quadtreewithset", "QUADTREE"}) EXPECT_EQ(hash_with(name), expected) << name;
}

TEST_F(Program, bad_usage_is_refused_with_status_2_and_a_clear_message)
{
    const struct
    {
        std::vector<std::string> arguments;
        const char* message;
    } cases[] = {
        {{}, "a command is missing; give scenes, run, export, trace or lab"},
        {{"--bogus"}, "there is no option \"--bogus\" before a command; give scenes, run, export, trace or lab, and its options after it"},
        {{"--json", "scenes"}, "--json"},
        {{"walk"}, "there is no command \"walk\"; give scenes, run, export, trace or lab"},
        {{"run"}, "scene"},
        {{"run", "colisions"}, "did you mean collisions?"},
        {{"run", "gravity", "--steps", "0"}, "--steps: \"0\" does not fit; give a whole number from 1 to 10000000"},
        {{"run", "gravity", "--steps", "-5"}, "-5"},
        {{"run", "gravity", "--steps", "99999999999999999999"}, "--steps"},
        {{"run", "gravity", "--steps", "ten"}, "ten"},
        {{"run", "gravity", "--steps", "1.5"}, "1.5"},
        {{"run", "gravity", "--seed", "-1"}, "--seed: \"-1\" does not fit; give a whole number from 0 to 18446744073709551615"},
        {{"run", "gravity", "--seed", "1x"}, "--seed"},
        {{"run", "gravity", "--set", "size"}, "give NAME=VALUE"},
        {{"run", "gravity", "--set", "size=9"}, "size: 9 is out of range; give a number from 0.2 to 5 m"},
        {{"run", "gravity", "--set", "sise=1"}, "did you mean size?"},
        {{"run", "gravity", "--set", "=1"}, "--set: \"=1\" has no name; give NAME=VALUE"},
        {{"run", "gravity", "--broadphase", "Octree"}, "one of Tree, BruteForce, QuadtreeNaive, QuadtreeWithSet, Quadtree"},
        {{"run", "gravity", "--input", "/no/such/file"}, "/no/such/file"},
        {{"run", "gravity", "--still", "/no/such/folder/a.png"}, "/no/such/folder/a.png"},
        {{"run", "gravity", "--still", "a.jpg"}, ".png"},
        {{"run", "gravity", "--animation", "a.avi"}, ".mp4, .webm or .gif"},
        {{"run", "gravity", "--animation", "/tmp"}, ".mp4"},
        {{"run", "collisions", "--set", "cover=80"}, "cover: 80 is out of range; give a number from 1 to 60 %"},
        {{"run", "gravity", "--frames", "3"}, "--frames"},
    };
    for (const auto& one : cases)
    {
        const Outcome outcome = carom(one.arguments);
        const std::string line = one.arguments.empty() ? "" : one.arguments.back();
        EXPECT_EQ(outcome.status, 2) << line;
        EXPECT_EQ(outcome.out, "") << line;
        EXPECT_NE(outcome.err.find(one.message), std::string::npos) << line << ": " << outcome.err;
    }
}

TEST_F(Program, a_wrong_instruction_set_in_the_environment_is_named)
{
    setenv("CAROM_SIMD", "mmx", 1);
    const Outcome version = carom({"--version"});
    const Outcome run = carom({"run", "gravity", "--steps", "2"});
    unsetenv("CAROM_SIMD");
    EXPECT_NE(version.status, 0);
    EXPECT_NE(version.err.find("CAROM_SIMD (in the environment) is mmx"), std::string::npos) << version.err;
    EXPECT_NE(run.status, 0);
    EXPECT_NE(run.err.find("CAROM_SIMD"), std::string::npos) << run.err;
    EXPECT_EQ(carom({"run", "gravity", "--steps", "2", "--simd", "mmx"}).status, 2);
    const std::string hash = "hash of the world";
    const Outcome scalar = carom({"run", "gravity", "--steps", "20", "--simd", "scalar"});
    const Outcome best = carom({"run", "gravity", "--steps", "20", "--simd", "best"});
    EXPECT_EQ(scalar.out.substr(scalar.out.find(hash)), best.out.substr(best.out.find(hash)));
}

TEST_F(Program, help_and_version_succeed)
{
    EXPECT_EQ(carom({"--help"}).status, 0);
    EXPECT_NE(carom({"run", "--help"}).out.find("--broadphase"), std::string::npos);
    EXPECT_EQ(carom({"--version"}).out, "carom 0.1.0, " + std::string(name_of(World().simd())) + "\n");
}

TEST_F(Program, input_changes_the_run)
{
    std::ofstream(file("events.json")) << R"([{"step": 5, "key": "c"}])";
    const json run = json::parse(carom({"run", "gravity", "--steps", "10", "--json", "--input", file("events.json")}).out);
    EXPECT_EQ(run["bodies"], 1);
}

TEST_F(Program, says_how_many_input_events_come_too_late)
{
    std::ofstream(file("events.json")) << R"([{"step": 9, "key": "c"}, {"step": 10, "key": "c"}, {"step": 400, "key": "c"}])";
    const Outcome outcome = carom({"run", "gravity", "--steps", "10", "--json", "--input", file("events.json")});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.err, "carom: --input: 2 of 3 events come after the last step, 9, and were not used; give more --steps\n");
    EXPECT_EQ(json::parse(outcome.out)["bodies"], 1);
    EXPECT_EQ(carom({"run", "gravity", "--steps", "401", "--json", "--input", file("events.json")}).err, "");
}

TEST_F(Program, draws_a_still)
{
    EXPECT_EQ(carom({"run", "triggers", "--steps", "5", "--still", file("a.png")}).status, 0);
    EXPECT_TRUE(starts_with(file("a.png"), "\x89PNG"));
    EXPECT_EQ(files(), std::vector<std::string>{"a.png"});
}

TEST_F(Program, draws_an_animation_that_does_not_change_the_run)
{
    if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
    const std::vector<std::string> plain = {"run", "gravity", "--steps", "12", "--json"};
    std::vector<std::string> animated = plain;
    animated.insert(animated.end(), {"--animation", file("a.gif")});
    const Outcome outcome = carom(animated);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(starts_with(file("a.gif"), "GIF89a"));
    EXPECT_EQ(json::parse(outcome.out)["hash"], json::parse(carom(plain).out)["hash"]);
    EXPECT_EQ(files(), std::vector<std::string>{"a.gif"});
}

TEST_F(Program, says_when_ffmpeg_is_missing_and_leaves_nothing)
{
    const std::string path = getenv("PATH");
    setenv("PATH", folder_.c_str(), 1);
    const Outcome outcome = carom({"run", "gravity", "--steps", "2", "--animation", file("a.mp4")});
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("ffmpeg was not found"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(files().empty());
}

TEST_F(Program, says_what_a_failing_ffmpeg_said)
{
    std::ofstream(file("ffmpeg")) << "#!/bin/sh\necho no such codec >&2\nexit 1\n";
    std::filesystem::permissions(file("ffmpeg"), std::filesystem::perms::owner_all);
    const std::string path = getenv("PATH");
    setenv("PATH", folder_.c_str(), 1);
    const Outcome outcome = carom({"run", "gravity", "--steps", "40", "--animation", file("a.mp4")});
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("ffmpeg failed: no such codec"), std::string::npos) << outcome.err;
    EXPECT_EQ(files(), std::vector<std::string>{"ffmpeg"});
}

TEST_F(Program, an_interrupted_run_leaves_nothing)
{
    int steps = 0;
    std::ostringstream out;
    std::ostringstream err;
    const Surroundings surroundings{.out = out, .err = err, .is_interrupted = [&] { return ++steps >= 10; }};
    const std::vector<std::string> run = {"run", "gravity", "--steps", "1000000", "--still", file("a.png")};
    EXPECT_EQ(run_program(run, surroundings), 1);
    EXPECT_EQ(err.str(), "carom: interrupted\n");
    EXPECT_EQ(out.str(), "");
    EXPECT_TRUE(files().empty());

    if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
    std::vector<std::string> animated = run;
    animated.insert(animated.end(), {"--animation", file("a.mp4")});
    steps = 0;
    EXPECT_EQ(run_program(animated, surroundings), 1);
    EXPECT_TRUE(files().empty());
}

TEST_F(Program, says_when_the_output_can_not_be_written)
{
    for (const char* argument : {"--help", "--version", "scenes"})
    {
        std::ostringstream out;
        std::ostringstream err;
        out.setstate(std::ios::badbit);
        EXPECT_EQ(run_program({argument}, {out, err}), 1) << argument;
        EXPECT_EQ(err.str(), "carom: can't write the output\n");
    }
}

TEST_F(Program, an_older_picture_stays_when_a_run_fails)
{
    std::ofstream(file("a.png")) << "older";
    EXPECT_EQ(carom({"run", "gravity", "--steps", "2", "--still", file("a.png"), "--set", "size=-1"}).status, 2);
    EXPECT_TRUE(starts_with(file("a.png"), "older"));
}

TEST_F(Program, progress_shows_on_a_terminal_only)
{
    const std::vector<std::string> arguments = {"run", "collisions", "--steps", "1500"};
    EXPECT_EQ(carom(arguments, false).err, "");
    const std::string shown = carom(arguments, true).err;
    if (!shown.empty())
    {
        EXPECT_NE(shown.find(" left"), std::string::npos);
    } // a fast machine is done before the first line
}

TEST_F(Program, exports_a_scene_that_runs_to_the_same_hash)
{
    const Outcome exported =
        carom({"export", "collisions", file("scene.json"), "--set", "circles=40", "--set", "boxes=40", "--seed", "3", "--steps", "50"});
    EXPECT_EQ(exported.status, 0) << exported.err;
    EXPECT_EQ(exported.err, "");
    EXPECT_NE(exported.out.find("scene.json: 81 bodies, 0 joints, 0 events, 50 steps"), std::string::npos) << exported.out;
    const json of_file = json::parse(carom({"run", file("scene.json"), "--json"}).out);
    const json of_scene =
        json::parse(carom({"run", "collisions", "--set", "circles=40", "--set", "boxes=40", "--seed", "3", "--steps", "50", "--json"}).out);
    EXPECT_EQ(of_file["steps"], 50);
    EXPECT_EQ(of_file["hash"], of_scene["hash"]);
    EXPECT_EQ(of_file["scene"], "collisions");
}

TEST_F(Program, exports_and_runs_scenes_of_the_laboratory)
{
    EXPECT_EQ(carom({"export", "large_pyramid", file("scene.json"), "--set", "size=5", "--set", "substeps=2", "--steps", "20"}).status, 0);
    const Outcome of_file = carom({"run", file("scene.json"), "--json", "--still", file("still.png")});
    EXPECT_EQ(of_file.status, 0) << of_file.err;
    EXPECT_TRUE(starts_with(file("still.png"), "\x89PNG"));
    const Outcome of_scene = carom({"run", "large_pyramid", "--set", "size=5", "--set", "substeps=2", "--steps", "20", "--json"});
    EXPECT_EQ(json::parse(of_file.out)["hash"], json::parse(of_scene.out)["hash"]);
    EXPECT_EQ(json::parse(of_scene.out)["parameters"]["size"], 5);
    EXPECT_EQ(json::parse(of_scene.out)["bodies"], 16);
}

TEST_F(Program, lists_the_scenes_of_the_laboratory)
{
    const json list = json::parse(carom({"export", "--list", "--json"}).out);
    EXPECT_EQ(list.size(), lab::field_scenes().size());
    EXPECT_EQ(list[0]["suite"], "box2d");
    const std::string text = carom({"export", "--list"}).out;
    for (const char* word : {"box2d", "ordinary", "origin", "nbody", "large_pyramid", "size=100 rows"})
        EXPECT_NE(text.find(word), std::string::npos) << word;
    EXPECT_TRUE(json::parse(carom({"export", "--schema"}).out).contains("$defs"));
}

TEST_F(Program, says_what_a_scene_file_does_not_hold)
{
    const Outcome outcome = carom({"export", "one-way", file("scene.json")});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.err.find("scene.json: The world's hooks"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("own code"), std::string::npos);
}

TEST_F(Program, refuses_scene_files_with_their_place)
{
    std::ofstream(file("bad.json")) << R"({"carom_scene": 1, "bodies": [{"shapes": [{"circle": {"radius": -1}}]}]})";
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{"run", file("bad.json")}, "bad.json:1:65: bodies[0].shapes[0].circle.radius is -1; give a number > 0 [m]"},
        {{"run", file("none.json")}, "none.json: can't be read: No such file or directory"},
        {{"run", "large_piramid"}, "did you mean large_pyramid?"},
        {{"run", "large_pyramid", "--set", "size=0"}, "size: 0 is out of range; give an integer from 1 to 300"},
        {{"run", "large_pyramid", "--set", "rows=3"}, "rows"},
        {{"export"}, "a scene is missing"},
        {{"export", "gravity"}, "a file is missing; give its name, as gravity.json"},
        {{"export", "gravity", file("no/where.json")}, "can't write"},
    };
    for (const auto& [arguments, words] : cases)
    {
        const Outcome outcome = carom(arguments);
        EXPECT_EQ(outcome.status, 2) << words;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    }
    std::ofstream(file("good.json")) << R"({"carom_scene": 1})";
    EXPECT_EQ(carom({"run", file("good.json"), "--steps", "2"}).status, 0);
    EXPECT_NE(carom({"run", file("good.json"), "--seed", "2"}).err.find("--seed: a scene file holds no random numbers"), std::string::npos);
}

} // namespace carom::cli
