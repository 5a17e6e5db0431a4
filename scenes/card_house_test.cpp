// The card-house scene: it stands by itself, and a ball brings it down.
#include "scenes/registry.hpp"
#include "scenes/scene_testing.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

TEST(CardHouse, stands_for_a_minute_without_sleep)
{
    const auto scene = make_scene("card-house");
    scene->world().set_sleep_tuning({.is_enabled = false});
    EXPECT_LT(farthest_way(*scene, dynamic_bodies(*scene), 3600), 0.02f);
}

TEST(CardHouse, five_storeys_stand_for_a_minute)
{
    const auto scene = make_scene("card-house", {{"storeys", 5}});
    EXPECT_LT(farthest_way(*scene, dynamic_bodies(*scene), 3600), 0.03f);
}

TEST(CardHouse, falls_without_friction)
{
    const auto scene = make_scene("card-house", {{"friction", 0}});
    EXPECT_GT(farthest_way(*scene, dynamic_bodies(*scene), 300), 0.5f);
}

TEST(CardHouse, a_ball_brings_it_down)
{
    const auto scene = make_scene("card-house");
    const std::vector<BodyId> cards = dynamic_bodies(*scene);
    scene->key("space");
    EXPECT_GT(farthest_way(*scene, cards, 300), 0.5f);
}

} // namespace carom::scenes
