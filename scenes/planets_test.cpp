// The planet scene: orbits, suns, collisions, the camera.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

std::vector<float> distances_from_sun(const World& world)
{
    std::vector<float> all;
    Vec2 sun;
    for (const BodyId id : world.bodies())
    {
        if (world.body(id).name() == "sun") sun = world.body(id).position();
    }
    for (const BodyId id : world.bodies())
    {
        if (world.body(id).name() == "planet") all.push_back(distance(world.body(id).position(), sun));
    }
    return all;
}

int count_named(const World& world, std::string_view name)
{
    int count = 0;
    for (const BodyId id : world.bodies()) count += world.body(id).name() == name;
    return count;
}

} // namespace

TEST(Planets, orbits_are_circular)
{
    const auto scene = make_scene("planets");
    const std::vector<float> before = distances_from_sun(scene->world());
    step(*scene, 600);
    const std::vector<float> after = distances_from_sun(scene->world());
    ASSERT_EQ(before.size(), 250u);
    ASSERT_EQ(after.size(), 250u);
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i] / before[i], 1, 0.02);
}

TEST(Planets, the_sun_feels_nothing_of_planets_until_everything_pulls)
{
    const auto calm = make_scene("planets");
    step(*calm, 60);
    EXPECT_EQ(calm->world().body(calm->world().bodies().front()).position(), (Vec2{}));

    const auto mutual = make_scene("planets", {{"n_body", true}});
    step(*mutual, 60);
    EXPECT_NE(mutual->world().body(mutual->world().bodies().front()).position(), (Vec2{}));
}

TEST(Planets, the_pointer_adds_planets_and_suns)
{
    const auto scene = make_scene("planets", {{"planets", 0}});
    click(*scene, {20, 0});
    click(*scene, {0, 80}, PointerEvent::Button::Right);
    EXPECT_EQ(count_named(scene->world(), "planet"), 1);
    EXPECT_EQ(count_named(scene->world(), "sun"), 2);
    const BodyView planet = scene->world().body(scene->world().bodies()[1]);
    EXPECT_NEAR(planet.linear_velocity().x, 0, 1e-3);
    EXPECT_NEAR(planet.linear_velocity().y, std::sqrt(3000.0 / 20), 0.05); // sqrt(G M / d), but for the softening
}

TEST(Planets, two_suns_circle_each_other)
{
    const auto scene = make_scene("planets", {{"planets", 0}});
    click(*scene, {30, 0}, PointerEvent::Button::Right);
    const auto separation = [&]
    {
        const std::vector<BodyId> suns = scene->world().bodies();
        return distance(scene->world().body(suns[0]).position(), scene->world().body(suns[1]).position());
    };
    for (int i = 0; i < 600; ++i)
    {
        scene->step();
        ASSERT_NEAR(separation(), 30, 0.6);
    }
}

TEST(Planets, the_camera_follows_the_nearest_sun)
{
    const auto scene = make_scene("planets", {{"planets", 0}});
    click(*scene, {30, 0}, PointerEvent::Button::Right);
    scene->key("f");
    step(*scene, 100);
    EXPECT_GT(length(scene->camera().center), 0.5f);
    EXPECT_EQ(scene->camera().center, scene->world().body(scene->world().bodies()[0]).position());
}

TEST(Planets, planets_pass_through_each_other_unless_they_collide)
{
    const auto contacts = [](bool collide)
    {
        const auto scene = make_scene("planets", {{"collide", collide}});
        std::size_t count = 0;
        for (int i = 0; i < 120; ++i)
        {
            scene->step();
            count += scene->world().events().contact_begin.size();
        }
        return count;
    };
    EXPECT_EQ(contacts(false), 0u);
    EXPECT_GT(contacts(true), 0u);
}

TEST(Planets, switching_collisions_acts_at_once)
{
    const auto scene = make_scene("planets");
    scene->set_parameter("collide", true);
    std::size_t count = 0;
    for (int i = 0; i < 120; ++i)
    {
        scene->step();
        count += scene->world().events().contact_begin.size();
    }
    EXPECT_GT(count, 0u);
}

TEST(Planets, a_planet_that_is_flung_far_away_is_taken_away)
{
    const auto scene = make_scene("planets", {{"planets", 3}});
    World& world = scene->world();
    world.body(world.bodies()[1]).set_transform({6000, 0}, 0);
    scene->step();
    EXPECT_EQ(count_named(world, "planet"), 2);
    DrawList list;
    EXPECT_NO_THROW(scene->draw(list));
}

} // namespace carom::scenes
