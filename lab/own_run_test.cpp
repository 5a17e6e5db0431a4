#include "lab/own_run.hpp"

#include "lab/field_scenes/field_scenes.hpp"
#include "lab/sampling.hpp"
#include "scene_file/player.hpp"
#include "scene_file/reader.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace carom::lab
{

namespace
{

EngineRun run_text(const char* text, int samples) { return run_carom(parse_scene_file(text, "text"), "text", {.samples = samples}); }

constexpr const char* falling = R"({"carom_scene": 1, "steps": 60, "world": {"gravity": [0, -10]},
    "bodies": [{"shapes": [{"circle": {"radius": 0.5}}]}, {"position": [5, 0], "shapes": [{"circle": {"radius": 0.5}}]}],
    "events": [{"step": 30, "destroy_bodies": [1]}],
    "rays": [{"start": [-5, -5], "sweep": [10, 0]}, {"start": [-5, 50], "sweep": [10, 0]}]})";

} // namespace

TEST(OwnRun, tells_where_the_bodies_of_a_scene_are)
{
    const SceneFile file = []
    {
        SceneFile made = make_field_scene(*find_field_scene("mixed_50"), {.size = 20, .seed = 3});
        made.steps = 30;
        return made;
    }();
    const EngineRun run = run_carom(file, "mixed", {.samples = 3});
    EXPECT_EQ(run.step_ms.size(), 30u);
    ASSERT_EQ(run.samples.size(), 3u);
    EXPECT_EQ(run.samples.back().step, 30);

    FilePlayer player(file);
    for (int i = 0; i < 30; ++i) player.step();
    for (int i = 0; i < player.playback().body_count(); ++i)
    {
        const Vec2 p = player.world().body(player.playback().body(i)).position();
        EXPECT_EQ(run.samples.back().bodies[static_cast<std::size_t>(i)]->y, static_cast<double>(p.y));
    }
}

TEST(OwnRun, the_broad_phase_changes_no_body_and_is_told)
{
    SceneFile file = make_field_scene(*find_field_scene("mixed_50"), {.size = 20, .seed = 3});
    file.steps = 60;
    EngineRun tree = run_carom(file, "mixed");
    EngineRun brute = run_carom(file, "mixed", {.broad_phase = BroadPhaseType::BruteForce});
    EXPECT_GT(brute.counters.at("pairs_tested"), tree.counters.at("pairs_tested"));
    EXPECT_GT(brute.counters.at("memory_bytes"), 0);
    EXPECT_EQ(brute.differences, (std::vector<std::string>{"finds pairs by the broad phase BruteForce"}));
    tree.step_ms = brute.step_ms = {1};
    tree.counters = brute.counters;
    tree.differences = brute.differences;
    EXPECT_EQ(to_json(tree), to_json(brute));
}

TEST(OwnRun, draws_after_each_step_when_it_is_asked_to_and_goes_the_same_way)
{
    SceneFile file = make_field_scene(*find_field_scene("mixed_50"), {.size = 20, .seed = 3});
    file.steps = 10;
    std::vector<std::size_t> shapes;
    const auto draw = [&](const scenes::DrawList& list, const scenes::Camera& camera)
    {
        shapes.push_back(list.layers()[static_cast<std::size_t>(scenes::Layer::Bodies)].shapes.size());
        EXPECT_GT(camera.height, 0);
    };
    EngineRun drawn = run_carom(file, "mixed", {.draw = draw});
    EngineRun plain = run_carom(file, "mixed");
    ASSERT_EQ(shapes.size(), 10u);
    EXPECT_GE(shapes.front(), 20u);
    EXPECT_EQ(shapes.back(), shapes.front()) << "a list is emptied before it is filled anew";
    ASSERT_EQ(drawn.draw_ms.size(), 10u);
    EXPECT_TRUE(plain.draw_ms.empty());
    EXPECT_DOUBLE_EQ(drawn.frame_ms()[3], drawn.step_ms[3] + drawn.draw_ms[3]);
    EXPECT_EQ(plain.frame_ms(), plain.step_ms);
    drawn.draw_ms.clear();
    drawn.step_ms = plain.step_ms = {1};
    drawn.counters = plain.counters;
    EXPECT_EQ(to_json(drawn), to_json(plain));
}

TEST(OwnRun, says_that_it_steps_on_one_thread)
{
    SceneFile file = make_field_scene(*find_field_scene("stack_20"), {.size = 2, .seed = 1});
    file.steps = 2;
    EXPECT_TRUE(run_carom(file, "stack").differences.empty());
    EXPECT_EQ(run_carom(file, "stack", {.threads = 2}).differences.size(), 1u);
}

TEST(OwnRun, has_null_for_what_was_destroyed)
{
    SceneFile file = make_field_scene(*find_field_scene("spawn_destroy"), {.size = 1, .seed = 1});
    file.steps = 200;
    const EngineRun run = run_carom(file, "spawn", {.samples = 1});
    const auto& bodies = run.samples.back().bodies;
    EXPECT_TRUE(std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return !body; }));
    EXPECT_TRUE(std::any_of(bodies.begin(), bodies.end(), [](const auto& body) { return body.has_value(); }));
}

TEST(OwnRun, tells_where_bodies_are_and_which_are_gone)
{
    const EngineRun run = run_text(falling, 2);
    EXPECT_EQ(run.engine, "carom");
    ASSERT_EQ(run.samples.size(), 2u);
    EXPECT_EQ(run.samples[0].step, 30);
    EXPECT_TRUE(run.samples[0].bodies[1]);
    EXPECT_EQ(run.samples[1].step, 60);
    EXPECT_FALSE(run.samples[1].bodies[1]);
    const double n = 240; // the closed form of the integrator
    ASSERT_TRUE(run.samples[1].bodies[0]);
    EXPECT_NEAR(run.samples[1].bodies[0]->y, -10 * n * (n + 1) / 2 / (n * n), 1e-3);
    EXPECT_NEAR(run.samples[1].bodies[0]->vy, -10, 1e-4);
}

TEST(OwnRun, times_steps_events_and_rays_by_themselves)
{
    const EngineRun run = run_text(falling, 1);
    EXPECT_EQ(run.step_ms.size(), 60u);
    EXPECT_EQ(run.event_ms.size(), 60u);
    EXPECT_EQ(run.ray_ms.size(), 60u);
    EXPECT_EQ(run.ray_hits, 1); // the body is at -5.02
    const EngineRun plain = run_text(R"({"carom_scene": 1, "steps": 3, "bodies": [{}]})", 1);
    EXPECT_EQ(plain.step_ms.size(), 3u);
    EXPECT_TRUE(plain.event_ms.empty());
    EXPECT_TRUE(plain.ray_ms.empty());
    EXPECT_FALSE(plain.ray_hits);
}

TEST(OwnRun, is_the_same_after_a_file)
{
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / ("scene_run_" + std::to_string(getpid()) + ".json");
    const EngineRun run = run_text(falling, 7);
    std::ofstream(file) << to_json(run);
    const EngineRun read = read_run(file);
    std::filesystem::remove(file);
    EXPECT_EQ(to_json(read), to_json(run));
    EXPECT_EQ(read.event_ms, run.event_ms);
    EXPECT_EQ(read.ray_ms, run.ray_ms);
    EXPECT_EQ(read.ray_hits, run.ray_hits);
}

TEST(Sampling, is_at_equal_distances_up_to_the_last_step)
{
    const auto sampled = [](int steps, int samples)
    {
        std::vector<int> list;
        for (int step = 0; step < steps; ++step)
            if (is_sampled(step, steps, samples)) list.push_back(step + 1);
        return list;
    };
    EXPECT_EQ(sampled(37, 4), (std::vector<int>{10, 19, 28, 37}));
    EXPECT_EQ(sampled(100, 1), std::vector<int>{100});
    EXPECT_EQ(sampled(3, 10), (std::vector<int>{1, 2, 3}));
    EXPECT_TRUE(is_sampled(9'999'999, 10'000'000, 1'000'000));
}

} // namespace carom::lab
