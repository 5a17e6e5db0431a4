// Piles that have to stand.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace carom
{

namespace
{

World world_with_ground()
{
    World world;
    world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(200, 2));
    return world;
}

} // namespace

TEST(Stacking, a_box_dropped_from_4_m_rests)
{
    World world({.gravity = {0, -10}});
    world.create_body({.type = BodyType::Static, .position = {0, -10}}, box(100, 20));
    const BodyId id = world.create_body({.position = {0, 4}}, box(2, 2), {.material = {.friction = 0.3f}});
    for (int i = 0; i < 90; ++i) world.step(dt);
    EXPECT_NEAR(world.body(id).position().y, 1, 0.01);
    EXPECT_NEAR(world.body(id).position().x, 0, 0.01);
    EXPECT_NEAR(world.body(id).angle(), 0, 0.01);
}

TEST(Stacking, ten_boxes_stand_for_a_minute_and_move_under_1_cm)
{
    World world = world_with_ground();
    std::vector<BodyId> boxes;
    std::vector<Vec2> start;
    for (int i = 0; i < 10; ++i)
    {
        start.push_back({0, 0.5f + static_cast<float>(i)});
        boxes.push_back(world.create_body({.position = start.back()}, box(1, 1)));
    }
    for (int step = 0; step < 3600; ++step) world.step(dt);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        EXPECT_LT(distance(world.body(boxes[i]).position(), start[i]), 0.01) << "box " << i;
        EXPECT_NEAR(world.body(boxes[i]).angle(), 0, 0.001);
    }
}

TEST(Stacking, a_pyramid_of_20_rows_stands)
{
    World world = world_with_ground();
    std::vector<BodyId> boxes;
    std::vector<Vec2> start;
    const int rows = 20;
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < rows - row; ++i)
        {
            start.push_back({1.05f * (static_cast<float>(i) - 0.5f * static_cast<float>(rows - row)), 0.5f + static_cast<float>(row)});
            boxes.push_back(world.create_body({.position = start.back()}, box(1, 1)));
        }
    for (int step = 0; step < 1200; ++step) world.step(dt);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        EXPECT_LT(distance(world.body(boxes[i]).position(), start[i]), 0.1) << "box " << i;
        EXPECT_LT(length(world.body(boxes[i]).linear_velocity()), 0.1) << "box " << i;
        EXPECT_NEAR(world.body(boxes[i]).angle(), 0, 0.01) << "box " << i;
    }
}

TEST(Stacking, a_tall_pile_sinks_deeper_without_warm_starting)
{
    // The deepest overlap of 20 boxes after three seconds [m].
    const auto overlap = [](bool warm_starting)
    {
        World world({.solver = {.warm_starting = warm_starting}, .sleep = {.is_enabled = false}});
        world.create_body({.type = BodyType::Static, .position = {0, -1}}, box(200, 2));
        std::vector<BodyId> boxes;
        for (int i = 0; i < 20; ++i) boxes.push_back(world.create_body({.position = {0, 0.5f + static_cast<float>(i)}}, box(1, 1)));
        for (int step = 0; step < 180; ++step) world.step(dt);
        float below = -0.5f; // height of the centre below
        float deepest = 0;
        for (const BodyId id : boxes)
        {
            const float height = world.body(id).position().y;
            deepest = std::max(deepest, below + 1 - height);
            below = height;
        }
        return deepest;
    };
    const float with = overlap(true);
    const float without = overlap(false);
    EXPECT_LT(with, 0.006f);
    EXPECT_GT(without, 3 * with);
}

TEST(Stacking, a_heavy_box_rests_on_a_light_one)
{
    World world = world_with_ground();
    const BodyId light = world.create_body({.position = {0, 0.5f}}, box(1, 1));
    const BodyId heavy = world.create_body({.position = {0, 1.5f}}, box(1, 1), {.density = 200});
    for (int step = 0; step < 500; ++step) world.step(dt);
    EXPECT_NEAR(world.body(light).position().y, 0.5f, 0.1);
    EXPECT_NEAR(world.body(heavy).position().y, 1.5f, 0.1);
    EXPECT_LT(length(world.body(heavy).linear_velocity()), 0.1);
}

/// A floating slab that weighs 10,000 times what stands on it is as good as ground.
TEST(Stacking, ten_boxes_stand_on_a_very_heavy_body)
{
    World world({.sleep = {.is_enabled = false}});
    const BodyId slab = world.create_body({.position = {0, -1}, .gravity_scale = 0}, box(20, 2), {.density = 1e4f});
    std::vector<BodyId> boxes;
    for (int i = 0; i < 10; ++i) boxes.push_back(world.create_body({.position = {0, 0.5f + static_cast<float>(i)}}, box(1, 1)));
    for (int step = 0; step < 500; ++step) world.step(dt);
    const float top = world.body(slab).position().y + 1; // the weight of the boxes moves it by half a millimetre
    EXPECT_NEAR(top, 0, 0.01);
    for (std::size_t i = 0; i < boxes.size(); ++i)
    {
        const Body body = world.body(boxes[i]);
        EXPECT_NEAR(body.position().y, top + 0.5f + static_cast<float>(i), 0.1) << i;
        EXPECT_NEAR(body.position().x, 0, 0.01) << i;
        EXPECT_LT(length(body.linear_velocity()), 0.1) << i;
    }
}

TEST(Stacking, discs_and_capsules_rest_on_the_ground)
{
    World world = world_with_ground();
    const BodyId disc = world.create_body({.position = {0, 1}}, circle(0.5f));
    const BodyId pill = world.create_body({.position = {3, 1}}, capsule({-0.5f, 0}, {0.5f, 0}, 0.25f));
    const BodyId round = world.create_body({.position = {6, 1}}, rounded_box(1, 1, 0.2f));
    for (int step = 0; step < 300; ++step) world.step(dt);
    EXPECT_NEAR(world.body(disc).position().y, 0.5f, 0.005);
    EXPECT_NEAR(world.body(pill).position().y, 0.25f, 0.005);
    EXPECT_NEAR(world.body(round).position().y, 0.5f, 0.005);
    EXPECT_NEAR(world.body(pill).angle(), 0, 0.001);
}

TEST(Stacking, a_segment_carries_from_both_sides)
{
    World world({.gravity = {0, -10}});
    world.create_body({.type = BodyType::Static}, segment({-10, 0}, {10, 0}));
    const BodyId above = world.create_body({.position = {-2, 1}}, box(1, 1));
    const BodyId below = world.create_body({.position = {2, -1}, .gravity_scale = -1}, box(1, 1));
    for (int step = 0; step < 120; ++step) world.step(dt);
    EXPECT_NEAR(world.body(above).position().y, 0.5f, 0.01);
    EXPECT_NEAR(world.body(below).position().y, -0.5f, 0.01);
}

} // namespace carom
