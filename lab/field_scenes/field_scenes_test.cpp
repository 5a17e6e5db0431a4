// Each scene plays at a small size; the measured sizes are those that the field uses.
#include "lab/field_scenes/field_scenes.hpp"

#include "scene_file/player.hpp"
#include "scene_file/reader.hpp"
#include "scene_file/writer.hpp"
#include "scenes/registry.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

namespace carom::lab
{

namespace
{

SceneFile made(std::string_view name, std::optional<int> size = {})
{
    const FieldScene& scene = *find_field_scene(name);
    return make_field_scene(scene, {.size = size.value_or(scene.size.initial)});
}

std::size_t moving_bodies(const SceneFile& file)
{
    return static_cast<std::size_t>(
        std::count_if(file.bodies.begin(), file.bodies.end(), [](const FileBody& body) { return body.def.type == BodyType::Dynamic; }));
}

/// Runs to its end, or as many steps as are given.
std::size_t quarantined_after(FilePlayer& player, int steps)
{
    std::size_t quarantined = 0;
    for (int i = 0; i < steps; ++i) quarantined += player.step().quarantined.size();
    return quarantined;
}

int bodies_beyond(const World& world, Vec2 center, float radius)
{
    const std::vector<BodyId> bodies = world.bodies();
    return static_cast<int>(
        std::count_if(bodies.begin(), bodies.end(), [&](BodyId id) { return distance(world.body(id).center_of_mass(), center) > radius; }));
}

/// How far the bodies are from where the file put them, at most [m].
float largest_shift(const FilePlayer& player)
{
    float largest = 0;
    for (int i = 0; i < player.playback().body_count(); ++i)
    {
        const Vec2 start = player.file().bodies[static_cast<std::size_t>(i)].def.position;
        largest = std::max(largest, distance(player.world().body(player.playback().body(i)).position(), start));
    }
    return largest;
}

} // namespace

TEST(FieldScenes, bear_names_that_no_scene_of_the_gallery_bears)
{
    for (const scenes::SceneInfo& scene : scenes::all_scenes()) EXPECT_EQ(find_field_scene(scene.name), nullptr) << scene.name;
}

TEST(FieldScenes, play_at_a_small_size_to_the_same_bits_through_text)
{
    for (const FieldScene& scene : field_scenes())
    {
        const int size = std::min(scene.size.initial, std::max(scene.size.min, 5));
        const SceneFile file = make_field_scene(scene, {.size = size});
        EXPECT_EQ(file.name, scene.name);
        EXPECT_EQ(file.steps, scene.steps);
        FilePlayer direct(file);
        FilePlayer read(parse_scene_file(scene_file_text(file), scene.name));
        const int steps = std::min(scene.steps, 130); // what spawn_destroy makes goes from step 120 on
        EXPECT_EQ(quarantined_after(direct, steps), 0u) << scene.name;
        quarantined_after(read, steps);
        EXPECT_EQ(direct.world().hash(), read.world().hash()) << scene.name;
        EXPECT_GT(direct.world().body_count(), 1) << scene.name;
    }
}

TEST(FieldScenes, have_names_of_their_own)
{
    std::set<std::string> names;
    for (const FieldScene& scene : field_scenes()) EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    EXPECT_EQ(find_field_scene("nothing"), nullptr);
}

TEST(FieldScenes, refuse_a_size_that_is_out_of_range)
{
    const FieldScene& scene = *find_field_scene("large_pyramid");
    EXPECT_THROW(make_field_scene(scene, {.size = 0}), scenes::SceneError);
    EXPECT_THROW(make_field_scene(scene, {.size = scene.size.max + 1}), scenes::SceneError);
}

TEST(FieldScenes, differ_by_their_seed)
{
    const FieldScene& scene = *find_field_scene("mixed_50");
    const SceneFile one = make_field_scene(scene, {.size = 10, .seed = 1});
    EXPECT_EQ(scene_file_text(one), scene_file_text(make_field_scene(scene, {.size = 10, .seed = 1})));
    EXPECT_NE(scene_file_text(one), scene_file_text(make_field_scene(scene, {.size = 10, .seed = 2})));
}

TEST(FieldScenes, have_the_sizes_of_the_field)
{
    EXPECT_EQ(moving_bodies(made("large_pyramid")), 5050u);
    EXPECT_EQ(moving_bodies(made("many_pyramids")), 400u * 55);
    EXPECT_EQ(moving_bodies(made("smash")), 9601u);
    EXPECT_EQ(moving_bodies(made("spinner")), 6077u); // with the beam
    EXPECT_EQ(moving_bodies(made("tumbler")), 2025u);
    EXPECT_EQ(moving_bodies(made("washer")), 8000u);
    EXPECT_EQ(moving_bodies(made("sleep_piles")), 100u * 55);
    EXPECT_EQ(moving_bodies(made("tile_world")), 8u * 125);
    EXPECT_EQ(made("joint_grid").bodies.size(), 10000u);
    EXPECT_EQ(made("joint_grid").joints.size(), 19800u);
    EXPECT_EQ(made("origin_500").bodies.size(), 1001u);
    EXPECT_EQ(made("orbits_1000").bodies.size(), 1001u);
    EXPECT_EQ(made("rays_1000").rays.size(), 1000u);
    EXPECT_EQ(moving_bodies(made("rays_1000")), 500u);
    EXPECT_EQ(moving_bodies(made("ragdolls_20")), 220u);
    EXPECT_EQ(moving_bodies(made("shots")), 240u + 120u); // half of what they fly at can move
}

TEST(FieldScenes, name_what_an_engine_needs)
{
    EXPECT_EQ(made("orbits_1000").needs, std::vector<std::string>{"n_body_fields"});
    EXPECT_EQ(made("large_pyramid").needs, std::vector<std::string>{});
    EXPECT_EQ(made("spinner", 10).needs, (std::vector<std::string>{"capsules", "rounded_polygons", "one_sided_chains", "revolute_joints"}));
    EXPECT_EQ(made("rain", 2).needs, (std::vector<std::string>{"capsules", "events", "revolute_joints"}));
    EXPECT_EQ(made("rays_1000", 10).needs, (std::vector<std::string>{"capsules", "rays"}));
}

TEST(FieldScenes, stacks_stand)
{
    for (const auto& [name, size] : {std::pair{"stack_20", 20}, {"large_pyramid", 20}, {"many_pyramids", 2}})
    {
        FilePlayer player(made(name, size));
        EXPECT_EQ(quarantined_after(player, player.file().steps), 0u) << name;
        EXPECT_LT(largest_shift(player), 0.1f) << name; // each contact gives by a few millimetres
    }
}

TEST(FieldScenes, the_smashed_squares_sleep_until_they_are_hit)
{
    FilePlayer player(made("smash", 20));
    EXPECT_EQ(player.world().awake_body_count(), 1);
    quarantined_after(player, 30);
    EXPECT_EQ(player.world().awake_body_count(), 1);
    quarantined_after(player, 100);
    EXPECT_GT(player.world().awake_body_count(), 100);
}

TEST(FieldScenes, piles_sleep_and_one_in_four_is_woken)
{
    FilePlayer player(made("sleep_piles", 8));
    quarantined_after(player, 119);
    EXPECT_EQ(player.world().awake_body_count(), 0);
    quarantined_after(player, 2); // the event comes before step 120
    EXPECT_EQ(player.world().awake_body_count(), 2 * 55);
    quarantined_after(player, player.file().steps - 121);
    EXPECT_EQ(player.world().awake_body_count(), 0) << "all rest again at the end";
    EXPECT_LT(largest_shift(player), 0.1f) << "a hop topples nothing";
}

TEST(FieldScenes, the_tile_map_holds_what_runs_over_it)
{
    FilePlayer player(made("tile_world", 40));
    EXPECT_EQ(player.world().body_count(), 8 + 8 * 10);
    EXPECT_EQ(quarantined_after(player, 300), 0u);
    for (int i = 8; i < player.playback().body_count(); ++i)
    {
        const Vec2 start = player.file().bodies[static_cast<std::size_t>(i)].def.position;
        const Vec2 place = player.world().body(player.playback().body(i)).position();
        EXPECT_NEAR(place.y, start.y, 5) << "body " << i << " left its floor";
        EXPECT_GT(place.x, 0);
        EXPECT_LT(place.x, 40);
    }
}

/// A beam that is held back at each body that it pushes, while it keeps the speed that its motor gives it, comes to turn as fast as the motor can,
/// and all but stands still.
TEST(FieldScenes, the_spinner_turns_as_fast_as_its_spin_says)
{
    FilePlayer player(made("spinner", 2000));
    const BodyId beam = player.playback().body(1);
    float told = 0;
    for (int i = 0; i < 60; ++i)
    {
        player.step();
        told += player.world().body(beam).angular_velocity() / 60;
    }
    EXPECT_GT(told, 0.5f) << "it stirs";
    EXPECT_NEAR(player.world().body(beam).angle(), told, 0.1f * told);
}

TEST(FieldScenes, dolls_come_and_go)
{
    FilePlayer player(made("rain", 2));
    quarantined_after(player, 9);
    EXPECT_EQ(player.world().body_count(), 1 + 2 * 275);
    EXPECT_EQ(player.world().joint_count(), 2 * 250);
    quarantined_after(player, 40);
    EXPECT_EQ(player.world().body_count(), 1 + 2 * 275);
    EXPECT_EQ(player.playback().body_count(), 1 + 7 * 275);
}

TEST(FieldScenes, the_player_gets_through_the_level)
{
    FilePlayer player(made("platformer"));
    const int number = static_cast<int>(player.file().bodies.size()) - 1;
    quarantined_after(player, player.file().steps);
    const Vec2 place = player.world().body(player.playback().body(number)).position();
    EXPECT_GT(place.x, 30);
    EXPECT_GT(place.y, -3);
    EXPECT_LT(place.y, 10);
}

TEST(FieldScenes, planets_stay_on_their_circles)
{
    FilePlayer player(made("orbits_1000", 100));
    EXPECT_EQ(quarantined_after(player, 600), 0u);
    ASSERT_EQ(player.playback().body_count(), 101);
    for (int i = 1; i < player.playback().body_count(); ++i)
    {
        const float start = length(player.file().bodies[static_cast<std::size_t>(i)].def.position);
        EXPECT_NEAR(length(player.world().body(player.playback().body(i)).position()), start, 0.03f * start);
    }
}

TEST(SlowFieldScenes, the_measured_pyramid_stands)
{
    FilePlayer player(made("large_pyramid"));
    EXPECT_EQ(quarantined_after(player, player.file().steps), 0u);
    EXPECT_LT(largest_shift(player), 0.5f);
}

TEST(SlowFieldScenes, the_spinner_loses_at_most_two)
{
    FilePlayer player(made("spinner"));
    EXPECT_EQ(quarantined_after(player, player.file().steps), 0u);
    EXPECT_LE(bodies_beyond(player.world(), {}, 40), 2);
}

TEST(SlowFieldScenes, the_drums_keep_all)
{
    FilePlayer tumbler(made("tumbler"));
    EXPECT_EQ(quarantined_after(tumbler, tumbler.file().steps), 0u);
    EXPECT_EQ(bodies_beyond(tumbler.world(), {}, 15), 0);
    FilePlayer washer(made("washer"));
    EXPECT_EQ(quarantined_after(washer, 200), 0u); // a quarter turn
    EXPECT_EQ(bodies_beyond(washer.world(), {}, 14), 0);
}

} // namespace carom::lab
