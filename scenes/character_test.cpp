// The character scene: the course can be walked, by itself and by keys.
#include "scenes/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace carom::scenes
{

namespace
{

/// The player is the only capsule.
Vec2 player(const Scene& scene)
{
    DrawList list;
    scene.draw(list);
    for (const DrawnShape& shape : list.layer(Layer::Marks).shapes)
        if (std::holds_alternative<Capsule>(shape.geometry)) return shape.transform.p;
    ADD_FAILURE() << "no player";
    return {};
}

} // namespace

TEST(CharacterScene, it_walks_the_whole_course_by_itself)
{
    const auto scene = make_scene("character");
    float farthest = -100;
    float highest = -100;
    for (int i = 0; i < 6000; ++i)
    {
        scene->step();
        if (i % 10 != 0) continue;
        const Vec2 at = player(*scene);
        farthest = std::max(farthest, at.x);
        highest = std::max(highest, at.y);
        ASSERT_GT(at.y, -2) << "it is never lost below the pit";
    }
    EXPECT_GT(farthest, 10.5f) << "past the lift";
    EXPECT_LT(highest, 5.5f) << "but not up the steep slope";
}

TEST(CharacterScene, keys_take_over)
{
    const auto scene = make_scene("character");
    scene->key("down");
    for (int i = 0; i < 60; ++i) scene->step();
    const Vec2 rest = player(*scene);
    for (int i = 0; i < 60; ++i) scene->step();
    EXPECT_EQ(player(*scene), rest);
    scene->key("right");
    for (int i = 0; i < 20; ++i) scene->step();
    EXPECT_NEAR(player(*scene).x - rest.x, 1, 0.02f);
    scene->key("left");
    for (int i = 0; i < 20; ++i) scene->step();
    EXPECT_NEAR(player(*scene).x, rest.x, 0.02f);
    scene->key("up");
    scene->step();
    EXPECT_GT(player(*scene).y, rest.y + 0.05f);
    scene->key("h");
    EXPECT_LT(player(*scene).x, -11.7f);
}

TEST(CharacterScene, crates_are_pushed_aside)
{
    const auto scene = make_scene("character", {{"push_force", 5000}});
    const auto rightmost_crate = [&]
    {
        float x = -100;
        for (const BodyId body : scene->world().bodies())
            if (scene->world().body(body).type() == BodyType::Dynamic) x = std::max(x, scene->world().body(body).position().x);
        return x;
    };
    for (int i = 0; i < 60; ++i) scene->step();
    const float before = rightmost_crate();
    for (int i = 0; i < 1200; ++i) scene->step();
    EXPECT_GT(rightmost_crate(), before + 0.3f);
}

} // namespace carom::scenes
