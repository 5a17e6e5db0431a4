// The card-house scene: it stands by itself, and a ball brings it down.
#include "scenes/registry.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace carom::scenes
{

namespace
{

std::vector<Vec2> places(const Scene& scene, std::size_t cards)
{
    std::vector<Vec2> all;
    const std::vector<BodyId> bodies = scene.world().bodies();
    for (std::size_t i = 1; i <= cards; ++i) all.push_back(scene.world().body(bodies[i]).position());
    return all;
}

/// The way of the card that has moved most [m].
float farthest_way(Scene& scene, std::size_t cards, int steps)
{
    const std::vector<Vec2> before = places(scene, cards);
    for (int i = 0; i < steps; ++i) scene.step();
    const std::vector<Vec2> after = places(scene, cards);
    float farthest = 0;
    for (std::size_t i = 0; i < cards; ++i) farthest = std::max(farthest, distance(before[i], after[i]));
    return farthest;
}

} // namespace

TEST(CardHouse, stands_for_a_minute_without_sleep)
{
    const auto scene = make_scene("card-house");
    scene->world().set_sleep_tuning({.is_enabled = false});
    EXPECT_LT(farthest_way(*scene, 16, 3600), 0.02f);
}

TEST(CardHouse, five_storeys_stand_for_a_minute)
{
    const auto scene = make_scene("card-house", {{"storeys", 5}});
    EXPECT_LT(farthest_way(*scene, 41, 3600), 0.03f);
}

TEST(CardHouse, falls_without_friction)
{
    const auto scene = make_scene("card-house", {{"friction", 0}});
    EXPECT_GT(farthest_way(*scene, 16, 300), 0.5f);
}

TEST(CardHouse, a_ball_brings_it_down)
{
    const auto scene = make_scene("card-house");
    scene->key("space");
    EXPECT_GT(farthest_way(*scene, 16, 300), 0.5f);
}

} // namespace carom::scenes
