// The same bits for the same inputs: twice, with every broad phase, and in every build; golden_hashes.hpp holds what they must be.
#include "scenes/registry.hpp"
#include "tests/determinism/golden_hashes.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace carom
{

namespace
{

/// A world in which everything happens: piles, bounces, sensors, fields, things that come and go.
std::uint64_t run_mixed_world(BroadPhaseType first, bool switches)
{
    World world({.broad_phase = first});
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(60, 2));
    world.create_body({.type = BodyType::Static}, segment({-20, 0}, {-25, 10}));
    world.create_body({.type = BodyType::Kinematic, .position = {0, 3}, .angular_velocity = 1}, box(8, 0.5f));
    world.create_body({.type = BodyType::Static, .position = {5, 4}}, box(6, 3), {.is_sensor = true});
    world.add_field(PointField{.center = {0, 8}, .strength = 40, .softening = 1});
    std::vector<BodyId> bodies;
    for (int i = 0; i < 240; ++i)
    {
        const float x = static_cast<float>(i % 17) - 8;
        const float y = 4 + 0.7f * static_cast<float>(i % 29);
        const ShapeDef def = {.material = {.friction = 0.1f * static_cast<float>(i % 7), .restitution = i % 5 == 0 ? 0.7f : 0.0f}};
        const BodyDef body = {.position = {x, y}, .angle = static_cast<float>(i), .angular_velocity = static_cast<float>(i % 3)};
        if (i % 4 == 0)
            bodies.push_back(world.create_body(body, circle(0.3f), def));
        else if (i % 4 == 1)
            bodies.push_back(world.create_body(body, box(0.7f, 0.5f), def));
        else if (i % 4 == 2)
            bodies.push_back(world.create_body(body, capsule({-0.3f, 0}, {0.3f, 0}, 0.2f), def));
        else
            bodies.push_back(world.create_body(body, rounded_box(0.6f, 0.6f, 0.1f), def));
        world.step(1 / 60.0f);
        if (i % 10 == 9) // one goes, another comes
        {
            BodyId& victim = bodies[static_cast<std::size_t>(i) / 2];
            world.destroy_body(victim);
            victim = world.create_body({.position = {x, 25}}, circle(0.2f));
        }
        if (switches && i % 20 == 0) world.set_broad_phase(all_broad_phases[static_cast<std::size_t>(i) / 20 % all_broad_phases.size()]);
    }
    return world.hash();
}

} // namespace

/// Forced by the environment, since scenes make their worlds themselves.
class SimdHash : public testing::TestWithParam<Simd>
{
protected:
    void SetUp() override { setenv("CAROM_SIMD", std::string(name_of(GetParam())).c_str(), 1); }
    void TearDown() override { unsetenv("CAROM_SIMD"); }
};

TEST_P(SimdHash, of_every_scene_is_golden)
{
    if (!is_available(GetParam())) GTEST_SKIP() << "this machine does not have it";
    for (const golden::SceneHash& expected : golden::scenes)
    {
        const auto scene = scenes::make_scene(expected.scene);
        EXPECT_EQ(scene->world().simd(), GetParam());
        for (int i = 0; i < 240; ++i) scene->step();
        EXPECT_EQ(scene->world().hash(), expected.hash) << expected.scene;
    }
    EXPECT_EQ(run_mixed_world(BroadPhaseType::Tree, false), golden::mixed_world);
}

INSTANTIATE_TEST_SUITE_P(All, SimdHash, testing::ValuesIn(all_simd), [](const auto& simd) { return std::string(name_of(simd.param)); });

TEST(SimdChoice, is_changed_on_a_live_world_and_refused_where_it_is_not_there)
{
    World world({.simd = Simd::Scalar});
    EXPECT_EQ(world.simd(), Simd::Scalar);
    EXPECT_EQ(world.copy().simd(), Simd::Scalar);
    world.set_simd(Simd::Best);
    EXPECT_NE(world.simd(), Simd::Best);
    setenv("CAROM_SIMD", "mmx", 1);
    EXPECT_THROW(World(), UsageError);
    EXPECT_THROW(world.set_simd(Simd::Best), UsageError);
    EXPECT_EQ(World({.simd = Simd::Four}).simd(), Simd::Four) << "the environment is for those that do not choose";
    unsetenv("CAROM_SIMD");
    for (const Simd simd : all_simd)
    {
        EXPECT_EQ(simd_named(name_of(simd)), simd);
        if (is_available(simd)) continue;
        EXPECT_THROW(world.set_simd(simd), UsageError);
    }
    EXPECT_EQ(simd_named("best"), Simd::Best);
    EXPECT_FALSE(simd_named("mmx"));
}

TEST(Determinism, no_broad_phase_shows_in_the_state)
{
    const std::uint64_t expected = run_mixed_world(BroadPhaseType::BruteForce, false);
    for (const BroadPhaseType type : all_broad_phases) EXPECT_EQ(run_mixed_world(type, false), expected) << name_of(type);
}

TEST(Determinism, switching_the_broad_phase_on_a_live_world_disturbs_nothing)
{
    EXPECT_EQ(run_mixed_world(BroadPhaseType::Tree, true), run_mixed_world(BroadPhaseType::Tree, false));
}

TEST(Determinism, the_mixed_world_has_its_golden_hash) { EXPECT_EQ(run_mixed_world(BroadPhaseType::Tree, false), golden::mixed_world); }

class SceneHash : public testing::TestWithParam<golden::SceneHash>
{
};

TEST_P(SceneHash, is_the_same_twice_and_golden)
{
    const golden::SceneHash& expected = GetParam();
    for (int run = 0; run < 2; ++run)
    {
        const std::unique_ptr<scenes::Scene> scene = scenes::make_scene(expected.scene, {}, 1);
        for (int i = 0; i < 240; ++i) scene->step();
        EXPECT_EQ(scene->world().hash(), expected.hash) << expected.scene << std::hex << " 0x" << scene->world().hash();
    }
}

TEST_P(SceneHash, does_not_know_of_a_probe)
{
    /// Looks at everything after every stage.
    struct Probe : StepProbe
    {
        void after_stage(const StepMoment&, const StepView& view) override
        {
            DebugDraw visitor;
            view.debug_draw(visitor);
            ++calls;
        }
        int calls = 0;
    } probe;
    const std::unique_ptr<scenes::Scene> watched = scenes::make_scene(GetParam().scene, {}, 1);
    const std::unique_ptr<scenes::Scene> alone = scenes::make_scene(GetParam().scene, {}, 1);
    for (int i = 0; i < 60; ++i)
    {
        watched->world().step(watched->time_step(), 4, &probe);
        alone->world().step(alone->time_step(), 4);
        ASSERT_EQ(watched->world().hash(), alone->world().hash()) << "step " << i;
    }
    EXPECT_EQ(probe.calls, 60 * (4 + 5 * 4 + 5));
}

TEST_P(SceneHash, depends_on_the_seed_where_the_scene_does)
{
    const std::unique_ptr<scenes::Scene> scene = scenes::make_scene(GetParam().scene, {}, 2);
    for (int i = 0; i < 240; ++i) scene->step();
    EXPECT_NE(scene->world().hash(), GetParam().hash);
}

TEST(Determinism, every_scene_has_a_golden_hash)
{
    for (const scenes::SceneInfo& info : scenes::all_scenes())
        EXPECT_TRUE(std::any_of(golden::scenes.begin(), golden::scenes.end(), [&](const golden::SceneHash& hash) {
            return hash.scene == info.name;
        })) << info.name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, SceneHash, testing::ValuesIn(golden::scenes), [](const auto& scene)
{
    std::string name(scene.param.scene);
    std::replace(name.begin(), name.end(), '-', '_'); // a test's name takes no dash
    return name;
});

} // namespace carom
