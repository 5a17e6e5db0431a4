// A named scene that is written into a file and read again is the same scene; a file is a scene like any other.
#include "lab/scene_file/file_scene.hpp"

#include "lab/scene_file/scene_snapshot.hpp"
#include "scene_file/everything_test.hpp"
#include "scene_file/reader.hpp"
#include "scene_file/writer.hpp"
#include "scenes/registry.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace carom::lab
{

namespace
{

SceneFile through_text(const SceneFile& file) { return parse_scene_file(scene_file_text(file), "scene.json"); }

/// Steps a scene and its exported file side by side.
void expect_the_same(scenes::Scene& scene, int steps)
{
    FilePlayer player(through_text(snapshot_of(scene)));
    ASSERT_EQ(player.world().hash(), scene.world().hash()) << scene.info().name << " at the start";
    for (int i = 0; i < steps; ++i) scene.step(), player.step();
    EXPECT_EQ(player.world().hash(), scene.world().hash()) << scene.info().name << " after " << steps << " steps";
}

bool mentions(const std::vector<std::string>& notes, const std::string& word)
{
    return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) { return note.find(word) != std::string::npos; });
}

/// A ball over a floor.
SceneFile falling_ball()
{
    SceneFile file;
    file.bodies = {{.def = {.type = BodyType::Static}, .shapes = {{box(50, 1)}}},
                   {.def = {.position = {0, 4}}, .shapes = {{circle(0.5f)}}}};
    return file;
}

} // namespace

TEST(SceneSnapshot, plays_to_the_same_bits)
{
    for (const char* name : {"gravity", "card-house", "arch", "newton-cradle", "chain-terrain", "planets"})
    {
        const auto scene = scenes::make_scene(name);
        expect_the_same(*scene, 120);
    }
    const auto collisions = scenes::make_scene("collisions", {{"circles", 100}, {"boxes", 100}});
    expect_the_same(*collisions, 120);
}

TEST(SceneSnapshot, says_what_it_can_not_hold)
{
    const auto one_way = scenes::make_scene("one-way");
    const SceneFile file = snapshot_of(*one_way);
    EXPECT_TRUE(mentions(file.notes, "hooks"));
    EXPECT_TRUE(mentions(file.notes, "own code"));
}

TEST(SceneSnapshot, of_every_scene_plays_to_the_same_bits_or_says_that_it_does_not)
{
    int played = 0;
    for (const scenes::SceneInfo& info : scenes::all_scenes())
    {
        const auto scene = scenes::make_scene(info.name);
        const SceneFile file = snapshot_of(*scene);
        if (!file.notes.empty()) continue;
        ++played;
        expect_the_same(*scene, 30);
    }
    EXPECT_GE(played, 4);
}

TEST(FileScene, plays_as_the_player_does)
{
    SceneFile file = everything();
    FilePlayer player(file);
    FileScene scene(file, "everything.json");
    for (int i = 0; i < 20; ++i) player.step(), scene.step();
    EXPECT_EQ(scene.world().hash(), player.world().hash());
    EXPECT_EQ(scene.camera().height, 30);
    scenes::DrawList list;
    scene.draw(list);
    EXPECT_EQ(scene.info().name, "everything");
}

TEST(FileScene, takes_the_parameters_of_every_scene)
{
    FileScene scene(falling_ball(), "ball.json", {{"step_rate", 100.0}, {"broad_phase", std::string("Quadtree")}});
    EXPECT_EQ(scene.world().broad_phase(), BroadPhaseType::Quadtree);
    for (int i = 0; i < 10; ++i) scene.step();
    EXPECT_NEAR(scene.time(), 0.1, 1e-6);
    EXPECT_THROW(FileScene(falling_ball(), "ball.json", {{"circles", std::int64_t{3}}}), scenes::SceneError);
}

} // namespace carom::lab
