#include "lab/suites.hpp"

#include <gtest/gtest.h>
#include <set>
#include <stdexcept>

namespace carom::lab
{

TEST(Suites, hold_every_scene_of_the_field_once_and_a_quick_choice)
{
    std::set<std::string> names;
    for (const Suite& suite : suites())
    {
        EXPECT_FALSE(suite.scenes.empty()) << suite.name;
        if (suite.name == "quick" || suite.name == "full") continue;
        for (const SuiteScene& scene : suite.scenes) EXPECT_TRUE(names.insert(scene.name).second) << scene.name;
    }
    EXPECT_EQ(names.size(), field_scenes().size());
    EXPECT_EQ(find_suite("full").scenes.size(), names.size());
    EXPECT_EQ(find_suite("quick").scenes.size(), 12u);
    EXPECT_EQ(find_suite("box2d").scenes.size(), 12u);
}

TEST(Suites, know_what_should_hold)
{
    EXPECT_TRUE(find_suite("box2d").traits_of("large_pyramid").stands);
    EXPECT_TRUE(find_suite("origin").traits_of("origin_2000").keeps_energy);
    EXPECT_TRUE(find_suite("nbody").traits_of("orbits_1000").keeps_momentum);
    EXPECT_FALSE(find_suite("box2d").traits_of("rain").stands);
    EXPECT_THROW(find_suite("box2d").traits_of("nothing"), std::invalid_argument);
    EXPECT_THROW(find_suite("fast"), std::invalid_argument);
}

TEST(Suites, can_be_cut_down_to_some_scenes)
{
    const Suite some = find_suite("box2d").with_scenes({"washer", "rain"});
    ASSERT_EQ(some.scenes.size(), 2u);
    EXPECT_EQ(some.scenes[0].name, "washer");
    EXPECT_EQ(some.name, "box2d");
    EXPECT_THROW(find_suite("box2d").with_scenes({"washer", "rays_1000"}), std::invalid_argument);
}

TEST(Suites, see_shots_step_by_step)
{
    const SuiteScene shots = find_suite("ordinary").with_scenes({"shots"}).scenes.front();
    EXPECT_EQ(shots.samples(), shots.steps);
    EXPECT_LT(find_suite("ordinary").with_scenes({"stack_20"}).scenes.front().samples(), 20);
}

TEST(Suites, the_quick_scenes_can_be_made)
{
    for (const SuiteScene& scene : find_suite("quick").scenes)
    {
        const SceneFile file = scene.make();
        EXPECT_EQ(file.steps, scene.steps) << scene.name;
        EXPECT_GT(body_count(file), 1) << scene.name;
    }
}

} // namespace carom::lab
