#include "gallery/overlay.hpp"

#include "gallery/theme.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace carom::gallery
{

namespace
{

using scenes::DrawList;
using scenes::Layer;

DrawList drawn(const World& world, const DrawOptions& options, float height)
{
    DrawList list;
    draw_overlay(world, options, height, list);
    return list;
}

std::vector<std::string> names_in(const DrawList& list)
{
    std::vector<std::string> names;
    for (const scenes::DrawnText& text : list.layer(Layer::Captions).texts) names.push_back(text.text);
    return names;
}

} // namespace

TEST(Overlay, writes_as_many_names_as_can_be_read)
{
    World world({.gravity = {}});
    for (int i = 0; i < 1000; ++i) world.create_body({.position = {static_cast<float>(i), 0.5f}}, circle(0.4f));
    world.create_body({.position = {10, 50}, .name = "far"}, circle(0.4f));
    const DrawOptions options{.names = true};
    EXPECT_EQ(names_in(drawn(world, options, 20)).size(), 1001u);
    const std::vector<std::string> names = names_in(drawn(world, options, 2000));
    EXPECT_LE(names.size(), 14u) << "a short name takes 100 m of this picture";
    EXPECT_GE(names.size(), 9u);
    EXPECT_EQ(names.front(), "#0") << "the first of those that crowd";
    EXPECT_EQ(names.back(), "far");
}

TEST(Overlay, tints_each_island_and_each_sleeper)
{
    World world({.gravity = {0, -10}});
    world.create_body({.type = BodyType::Static}, box(50, 1));
    for (const float x : {-10.0f, 10.0f})
        for (const float y : {1.0f, 2.0f}) world.create_body({.position = {x, y}}, box(1, 1));
    for (int i = 0; i < 20; ++i) world.step(1 / 60.0f);
    const DrawList islands = drawn(world, {.islands = true}, 20);
    const auto& shapes = islands.layer(Layer::Bodies).shapes;
    ASSERT_EQ(shapes.size(), 4u) << "the ground is in none";
    EXPECT_EQ(shapes[0].paint.fill, shapes[1].paint.fill);
    EXPECT_EQ(shapes[2].paint.fill, shapes[3].paint.fill);
    EXPECT_NE(shapes[0].paint.fill, shapes[2].paint.fill);
    EXPECT_TRUE(drawn(world, {.sleep = true}, 20).layer(Layer::Bodies).shapes.empty());
    for (int i = 0; i < 200; ++i) world.step(1 / 60.0f);
    ASSERT_EQ(world.awake_body_count(), 0);
    EXPECT_EQ(drawn(world, {.sleep = true}, 20).layer(Layer::Bodies).shapes.size(), 4u);
}

TEST(Overlay, joins_bodies_to_their_contacts_in_the_colour_of_the_graph)
{
    World world({.gravity = {0, -10}});
    world.create_body({.type = BodyType::Static}, box(50, 1));
    for (const float y : {0.99f, 1.98f}) world.create_body({.position = {0, y}}, circle(0.5f));
    world.step(1 / 60.0f);
    const DrawList list = drawn(world, {.colors = true}, 20);
    const auto& lines = list.layer(Layer::Marks).lines;
    ASSERT_EQ(lines.size(), 3u) << "two at the contact of the discs, one at the ground's";
    std::vector<scenes::Color> colors;
    for (const scenes::DrawnLine& line : lines)
        if (std::find(colors.begin(), colors.end(), line.color) == colors.end()) colors.push_back(line.color);
    EXPECT_EQ(colors.size(), 2u) << "both contacts push the lower disc";
}

TEST(Overlay, outlines_a_body_that_is_there)
{
    World world;
    const BodyId body = world.create_body({}, circle(1));
    DrawList list;
    draw_outline(world, body, scenes::paper, list);
    EXPECT_EQ(list.layer(Layer::Marks).shapes.size(), 1u);
    world.destroy_body(body);
    draw_outline(world, body, scenes::paper, list);
    EXPECT_EQ(list.layer(Layer::Marks).shapes.size(), 1u);
}

TEST(Overlay, dims_what_lies_under_its_marks)
{
    World world;
    world.create_body({.position = {0, 1}}, circle(0.5f));
    DrawList plain;
    plain.disc(Layer::Bodies, {0, 1}, 0.5f, {.fill = scenes::rgb(1, 1, 1), .line = scenes::rgb(0, 1, 0)});
    plain.line(Layer::Marks, {}, {1, 1}, scenes::rgb(1, 0, 0));
    const auto brightness = [](const DrawList& list) { return luminance(list.layer(Layer::Bodies).shapes[0].paint.fill); };
    DrawList list = plain;
    draw_overlay(world, {.contacts = true}, 20, list);
    EXPECT_LT(brightness(list), 0.4f * brightness(plain));
    EXPECT_LT(list.layer(Layer::Marks).lines[0].color.r, 0.6f);
    list = plain;
    draw_overlay(world, {.names = true}, 20, list);
    EXPECT_EQ(brightness(list), brightness(plain)) << "names have rims and need no dark ground";
}

TEST(Overlay, keeps_the_points_of_a_crowd_apart)
{
    // Boxes of 1 m, in a picture of 100 m and in one of 10 m.
    World world({.gravity = {0, -10}, .sleep = {.is_enabled = false}});
    world.create_body({.type = BodyType::Static, .position = {0, -0.5f}}, box(200, 1));
    for (int i = 0; i < 50; ++i) world.create_body({.position = {static_cast<float>(i), 0.5f}}, box(0.95f, 1));
    for (int i = 0; i < 5; ++i) world.step(1 / 60.0f);
    for (const float height : {10.0f, 100.0f})
    {
        const DrawList list = drawn(world, {.contacts = true}, height);
        const auto& dots = list.layer(Layer::Marks).shapes;
        ASSERT_GE(dots.size(), 100u);
        for (const scenes::DrawnShape& dot : dots) EXPECT_LE(std::get<Circle>(dot.geometry).radius, std::min(0.18f, 0.0046f * height));
        EXPECT_GE(std::get<Circle>(dots[0].geometry).radius, 0.0015f * height) << "it must be seen";
    }
}

} // namespace carom::gallery
