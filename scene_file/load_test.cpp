// A program loads a level by the public functions alone, and a file that is refused changes nothing.
#include <carom/scene_file.hpp>

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

namespace carom
{

namespace
{

constexpr const char* level = R"({"carom_scene": 1, "name": "level", "time_step": 0.01, "substeps": 8, "world": {"gravity": [0, -5]},
"bodies": [
{"name": "floor", "type": "static", "chains": [{"name": "ground", "points": [[10, 0], [-10, 0]]}]},
{"name": "coin", "position": [0, 2], "shapes": [{"name": "rim", "circle": {"radius": 0.5}}]},
{"name": "coin", "position": [3, 2], "shapes": [{"circle": {"radius": 0.5}}]}],
"joints": [{"name": "pin", "body_a": 1, "body_b": 2, "distance": {"length": 3}}],
"events": [{"step": 2, "create_bodies": [{"name": "late"}]}, {"step": 3, "destroy_bodies": [1]}]})";

std::string problem_with(std::string_view text)
{
    World world({.gravity = {1, 2}});
    world.create_body({}, circle(1));
    const std::uint64_t before = world.hash();
    const SceneLoadResult result = load_scene_text(world, text, {.name = "level.json"});
    EXPECT_EQ(world.hash(), before) << text;
    return result ? "no problem" : result.problem.text();
}

} // namespace

TEST(LoadScene, gives_ids_by_name_and_by_number)
{
    World world;
    SceneLoadResult result = load_scene_text(world, level);
    ASSERT_TRUE(result) << result.problem.text();
    LoadedScene& scene = *result.scene;
    EXPECT_EQ(world.gravity(), (Vec2{0, -5}));
    EXPECT_EQ(scene.time_step, 0.01f);
    EXPECT_EQ(scene.substeps, 8);
    ASSERT_EQ(scene.bodies.size(), 3u);
    EXPECT_EQ(scene.names.bodies.find("coin"), scene.bodies[1]);
    EXPECT_EQ(scene.names.bodies.all("coin"), (std::vector<BodyId>{scene.bodies[1], scene.bodies[2]}));
    EXPECT_FALSE(scene.names.bodies.find("nothing"));
    EXPECT_EQ(world.shape(scene.names.shapes.find("rim")).body(), scene.bodies[1]);
    EXPECT_EQ(world.chain(scene.names.chains.find("ground")).body(), scene.bodies[0]);
    EXPECT_EQ(scene.names.joints.find("pin"), scene.joints[0]);
}

TEST(LoadScene, plays_the_events_before_their_steps)
{
    World world;
    SceneLoadResult result = load_scene_text(world, level);
    ASSERT_TRUE(result) << result.problem.text();
    LoadedScene& scene = *result.scene;
    const BodyId coin = scene.bodies[1];
    for (int step = 0; step < 2; ++step)
    {
        EXPECT_FALSE(scene.play_events(world, step));
        world.step(scene.time_step, scene.substeps);
    }
    EXPECT_EQ(world.body_count(), 3);
    EXPECT_FALSE(scene.play_events(world, 2));
    EXPECT_EQ(world.body(scene.names.bodies.find("late")).name(), "late");
    world.destroy_body(coin); // the event that would do it finds it gone
    EXPECT_TRUE(scene.has_events());
    EXPECT_FALSE(scene.play_events(world, 3));
    EXPECT_FALSE(scene.has_events());
    EXPECT_EQ(world.body_count(), 3);
}

TEST(LoadScene, adds_to_what_is_there_and_leaves_settings_alone_when_asked)
{
    World world({.gravity = {0, -1}});
    const BodyId own = world.create_body({}, circle(1));
    ASSERT_TRUE(load_scene_text(world, level, {.settings = false}));
    EXPECT_EQ(world.gravity(), (Vec2{0, -1}));
    EXPECT_EQ(world.body_count(), 4);
    EXPECT_TRUE(world.find_body(own));
}

TEST(LoadScene, takes_the_settings_of_the_file)
{
    World world({.length_unit = 0.01f});
    const char* const text = R"({"carom_scene": 1, "bodies": [{"shapes": [{"segment": {"p1": [0, 0], "p2": [0.0001, 0]}},
        {"polygon": {"vertices": [[0, 0], [0.0001, 0], [0, 0.0001]]}}]}],
        "world": {"length_unit": 0.01, "max_pairs": 7, "hit_speed": 3, "continuous": false}})";
    const SceneLoadResult result = load_scene_text(world, text);
    ASSERT_TRUE(result) << result.problem.text();
    EXPECT_EQ(world.max_pairs(), 7);
    EXPECT_EQ(world.hit_speed(), 3);
    EXPECT_FALSE(world.is_continuous());
    const std::string saved = scene_text(world);
    EXPECT_TRUE(validate_scene_text(saved).empty()) << saved;
    World again({.length_unit = 0.01f});
    ASSERT_TRUE(load_scene_text(again, saved));
    EXPECT_EQ(again.hash(), world.hash());
}

TEST(LoadScene, refuses_another_length_unit_than_the_world_s)
{
    const std::string scene = R"({"carom_scene": 1,
"world": {"length_unit": 0.01}, "bodies": [{"shapes": [{"circle": {"radius": 0.1}}]}]})";
    EXPECT_EQ(problem_with(scene), "level.json:2:10: world.length_unit is 0.01, and the world was made with 1; "
                                   "make the world with the file's, or load without the settings");
    World world;
    ASSERT_TRUE(load_scene_text(world, scene, {.settings = false}));
    EXPECT_EQ(world.body_count(), 1);

    // Without its own unit, a file is for worlds of 1. What is loaded without settings must be large enough for the world that is there.
    World ships({.length_unit = 100});
    const std::uint64_t before = ships.hash();
    const std::string small = R"({"carom_scene": 1, "bodies": [{"shapes": [{"segment": {"p1": [0, 0], "p2": [0.05, 0]}}]}]})";
    EXPECT_EQ(load_scene_text(ships, small).problem.field, "world.length_unit");
    EXPECT_EQ(load_scene_text(ships, small, {.settings = false}).problem.field, "bodies[0].shapes[0].segment.p2");
    EXPECT_EQ(ships.hash(), before);
}

TEST(LoadScene, refuses_with_place_and_path_and_changes_nothing)
{
    EXPECT_EQ(problem_with("{\"carom_scene\": 1,\n\"bodies\": [{}, {\"shapes\": [{\"circle\": {\"radius\": -1}}]}]}"),
              "level.json:2:50: bodies[1].shapes[0].circle.radius is -1; give a number > 0 [m]");
    // The engine alone knows that so much mass is too much, after the first body is made.
    EXPECT_EQ(problem_with("{\"carom_scene\": 1, \"bodies\": [{},\n{\"shapes\": [{\"circle\": {\"radius\": 1}, \"density\": 1e25}]}]}")
                  .substr(0, 64),
              "level.json:2:13: bodies[1].shapes[0].density is 1e+25; give a de");
    // An event that would be refused is found when the file is loaded.
    EXPECT_EQ(problem_with("{\"carom_scene\": 1, \"bodies\": [{\"type\": \"static\"}], \"events\": [{\"step\": 9,\n"
                           "\"set_bodies\": [{\"body\": 0, \"linear_velocity\": [1, 0]}]}]}")
                  .substr(0, 56),
              "level.json:2:16: events[0].set_bodies[0].linear_velocity");
    EXPECT_EQ(problem_with(""), "level.json: the file is empty; write {\"carom_scene\": 1, ...}");
}

TEST(LoadScene, reads_paths_and_streams_and_says_why_it_can_not)
{
    World world;
    const SceneLoadResult missing = load_scene(world, std::filesystem::path("/nowhere/level.json"));
    EXPECT_EQ(missing.problem.text(), "/nowhere/level.json: can't be read: No such file or directory");
    EXPECT_EQ(load_scene(world, std::filesystem::path("/")).problem.text(), "/: can't be read: it is a folder; give a file");
    std::istringstream stream(level);
    EXPECT_TRUE(load_scene(world, stream));
}

TEST(LoadScene, is_refused_for_another_world_than_the_scene_s)
{
    World world;
    World other;
    SceneLoadResult result = load_scene_text(world, level);
    ASSERT_TRUE(result);
    EXPECT_THROW(result.scene->play_events(other, 0), UsageError);
}

TEST(SaveScene, comes_back_with_its_names)
{
    World world;
    const SceneLoadResult first = load_scene_text(world, level);
    ASSERT_TRUE(first);
    const std::string text = scene_text(world, {.name = "again", .names = &first.scene->names});
    World again;
    const SceneLoadResult second = load_scene_text(again, text);
    ASSERT_TRUE(second) << second.problem.text();
    EXPECT_EQ(again.hash(), world.hash());
    EXPECT_EQ(second.scene->name, "again");
    EXPECT_TRUE(second.scene->names.joints.find("pin"));
    EXPECT_TRUE(second.scene->names.shapes.find("rim"));
    EXPECT_TRUE(second.scene->names.chains.find("ground"));
}

TEST(SaveScene, says_what_is_lost_and_why_it_can_not_write)
{
    World world;
    world.create_body({}, circle(1));
    world.step(0.01f);
    std::ostringstream out;
    EXPECT_EQ(save_scene(world, out).losses.size(), 1u);
    const SceneSaveResult result = save_scene(world, std::filesystem::path("/nowhere/level.json"));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.problem->text(), "/nowhere/level.json: can't be written: there is no folder \"/nowhere\"");
    EXPECT_THROW(scene_text(world, {.substeps = 0}), UsageError);
}

TEST(ValidateScene, lists_every_problem_in_the_order_of_the_file)
{
    const std::vector<SceneProblem> problems = validate_scene_text(R"({"carom_scene": 1,
"bodies": [{"angle": "up", "type": "dynamo"},
{"position": [1], "size": 3, "shapes": [{}, {"circle": {}}]}], "steps": 0})");
    std::vector<std::string> fields;
    for (const SceneProblem& problem : problems) fields.push_back(std::to_string(problem.line) + " " + problem.field);
    EXPECT_EQ(fields, (std::vector<std::string>{"2 bodies[0].angle", "2 bodies[0].type", "3 bodies[1].position", "3 bodies[1]",
                                                "3 bodies[1].shapes[0]", "3 bodies[1].shapes[1].circle", "3 steps"}));
    EXPECT_EQ(validate_scene_text(R"({"carom_scene": 1, "joints": [{"body_b": 0, "weld": {}}, {"body_b": 1, "weld": {}}]})").size(), 2u);
    EXPECT_TRUE(validate_scene_text(level).empty());
    EXPECT_EQ(validate_scene_text(R"({"a": 1, "b": 2, "c": 3})", 2).size(), 2u);
}

} // namespace carom
