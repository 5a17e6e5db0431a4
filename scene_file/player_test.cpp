// A world that is built from a file is the world that the file was made of, and goes on to the same bits.
#include "scene_file/player.hpp"

#include "scene_file/everything_test.hpp"
#include "scene_file/reader.hpp"
#include "scene_file/schema.hpp"
#include "scene_file/snapshot.hpp"
#include "scene_file/writer.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <random>

namespace carom::scene_file
{

namespace
{

SceneFile through_text(const SceneFile& file) { return parse_scene_file(scene_file_text(file), "scene.json"); }

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

std::string problem_of(const SceneFile& file)
{
    try
    {
        FilePlayer player(file, "scene.json");
        for (int i = 0; i < file.steps; ++i) player.step();
    }
    catch (const SceneFileError& error)
    {
        return error.what();
    }
    return "no problem";
}

} // namespace

TEST(SceneFileWriter, writes_every_field_so_that_it_comes_back)
{
    const std::string text = scene_file_text(everything());
    EXPECT_EQ(scene_file_text(parse_scene_file(text, "everything")), text);

    const auto schema = nlohmann::json::parse(scene_file_schema());
    const auto expect_all_of = [&](const nlohmann::json& object)
    {
        for (const auto& item : object["properties"].items())
            EXPECT_NE(text.find('"' + item.key() + "\":"), std::string::npos) << item.key() << " is not in everything()";
    };
    expect_all_of(schema);
    for (const auto& definition : schema["$defs"]) expect_all_of(definition);
}

TEST(SceneFileWriter, keeps_every_bit_of_a_number)
{
    std::mt19937 random(3);
    SceneFile file;
    for (int i = 0; i < 2000; ++i)
    {
        const float scale =
            std::bit_cast<float>(static_cast<std::uint32_t>(random()) % 0x30000000u + 0x20000000u); // of all sizes up to 10^6 or so
        file.bodies.push_back({.def = {.position = {std::min(scale, 1e6f), -0.0f}}});
    }
    const SceneFile back = through_text(file);
    for (std::size_t i = 0; i < file.bodies.size(); ++i)
    {
        EXPECT_EQ(std::bit_cast<std::uint32_t>(back.bodies[i].def.position.x), std::bit_cast<std::uint32_t>(file.bodies[i].def.position.x));
        EXPECT_TRUE(std::signbit(back.bodies[i].def.position.y));
    }
}

TEST(SceneFileWriter, refuses_numbers_that_JSON_can_not_hold)
{
    SceneFile file = falling_ball();
    file.bodies[1].def.position.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(scene_file_text(file), SceneFileError);
}

TEST(FilePlayer, plays_all_that_a_file_can_hold_to_the_same_bits_each_time)
{
    FilePlayer first(through_text(everything()));
    FilePlayer second(everything());
    for (int i = 0; i < first.file().steps; ++i)
    {
        EXPECT_TRUE(first.step().quarantined.empty());
        second.step();
        ASSERT_EQ(first.world().hash(), second.world().hash()) << "step " << i;
    }
    EXPECT_EQ(first.world().body_count(), 5);
    EXPECT_EQ(first.world().gravity(), (Vec2{0, -5}));
    EXPECT_EQ(first.rays().hits, second.rays().hits);
}

TEST(FilePlayer, does_before_a_step_what_belongs_there)
{
    SceneFile file = falling_ball();
    SetBody stop{.body = 1};
    stop.linear_velocity = Vec2{2, 0};
    stop.gravity_scale = 0.0f;
    file.events = {{.step = 3, .set_bodies = {stop}},
                   {.step = 3, .create_bodies = {{.def = {.position = {9, 9}}}}},
                   {.step = 5, .destroy_bodies = {2, 1}}};
    FilePlayer player(file);
    for (int i = 0; i < 3; ++i) player.step();
    const BodyId ball = player.playback().body(1);
    EXPECT_LT(player.world().body(ball).linear_velocity().y, 0);
    player.step();
    EXPECT_EQ(player.world().body(ball).linear_velocity(), (Vec2{2, 0}));
    EXPECT_EQ(player.world().body_count(), 3);
    player.step();
    player.step();
    EXPECT_FALSE(player.world().find_body(ball));
    EXPECT_EQ(player.world().body_count(), 1);
}

TEST(FilePlayer, leaves_a_joint_alone_that_broke)
{
    SceneFile file = falling_ball();
    file.joints = {{.body_b = 1, .def = {.frame_a = {{0, 4}, {}}, .break_force = 1e-3f}, .spec = RevoluteJoint{}}};
    file.events = {{.step = 9, .set_joints = {{.joint = 0, .motor_speed = 1.0f}}}, {.step = 10, .destroy_joints = {0}}};
    FilePlayer player(file);
    for (int i = 0; i < 12; ++i) player.step();
    EXPECT_EQ(player.world().joint_count(), 0);
}

TEST(FilePlayer, casts_the_rays_after_each_step)
{
    SceneFile file = falling_ball();
    file.rays = {{{-10, 4}, {20, 0}}, {{-10, 100}, {20, 0}}};
    FilePlayer player(file);
    player.step();
    EXPECT_EQ(player.rays().hits, 1);
    EXPECT_NEAR(player.rays().sum_of_fractions, 0.475, 1e-4);
}

TEST(FilePlayer, says_where_in_the_file_the_engine_refuses_something)
{
    SceneFile file = falling_ball();
    file.bodies[1].shapes[0].def.density = 1e25f;
    EXPECT_EQ(problem_of(file).substr(0, 64), "scene.json: bodies[1].shapes[0].density is 1e+25; give a density");
    file = falling_ball();
    SetBody push{.body = 0};
    push.linear_velocity = Vec2{1, 0};
    file.events = {{.step = 1, .set_bodies = {push}}};
    EXPECT_EQ(problem_of(file).substr(0, 51), "scene.json: events[0].set_bodies[0].linear_velocity");
    file = falling_ball();
    file.joints = {{.body_a = 0, .body_b = 1, .spec = RevoluteJoint{.limit = Range{1, -1}}}};
    EXPECT_EQ(problem_of(file), "scene.json: joints[0].limit.lower is 1; give a value that is not above limit.upper");
}

TEST(Snapshot, of_a_world_holds_what_was_set)
{
    FilePlayer player(everything());
    const SceneFile file = snapshot_of(player.world());
    EXPECT_TRUE(file.notes.empty()) << file.notes.front();
    const SceneFile original = everything();
    ASSERT_EQ(file.bodies.size(), original.bodies.size());
    EXPECT_EQ(file.bodies[0].name, "all shapes");
    EXPECT_EQ(file.bodies[0].shapes.size(), 4u);
    EXPECT_EQ(file.bodies[0].chains.size(), 1u);
    EXPECT_EQ(file.bodies[0].chains[0].points, original.bodies[0].chains[0].points);
    EXPECT_TRUE(file.bodies[1].is_awake);
    EXPECT_FALSE(file.bodies[4].is_awake);
    EXPECT_EQ(file.world.fields, original.world.fields);
    EXPECT_EQ(player.world().length_unit(), 0.5f);
    EXPECT_EQ(player.world().max_pairs(), 1000);
    EXPECT_EQ(file.world.length_unit, 0.5f);
    EXPECT_EQ(file.world.max_pairs, 1000);
    EXPECT_EQ(file.joints.size(), original.joints.size());
}

TEST(Snapshot, says_what_it_can_not_hold)
{
    World world;
    const BodyId ball = world.create_body({}, circle(1));
    world.body(ball).apply_force_to_center({1, 0});
    EXPECT_TRUE(mentions(snapshot_of(world).notes, "Forces"));
    world.step(1 / 60.0f);
    EXPECT_TRUE(mentions(snapshot_of(world).notes, "stepped"));
}

TEST(Snapshot, finds_the_angle_from_which_a_rotation_was_made)
{
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i)
    {
        World world;
        const float reach = i % 2 == 0 ? 1e-3f : pi;
        const BodyId body = world.create_body({.angle = reach * (static_cast<float>(random()) * 0x1p-31f - 1)}, circle(1));
        const SceneFile file = snapshot_of(world);
        EXPECT_EQ(rotation(file.bodies[0].def.angle), world.body(body).transform().q);
    }
}

} // namespace carom::scene_file
