// Colours, the camera, and what a draw list holds.
#include "scenes/draw_list.hpp"

#include "scenes/camera.hpp"

#include <gtest/gtest.h>

namespace carom::scenes
{

TEST(Color, hues_are_the_primary_colours)
{
    EXPECT_EQ(from_hue(0, 1, 0.5f), rgb(1, 0, 0));
    EXPECT_NEAR(from_hue(1.0f / 3, 1, 0.5f).g, 1, 1e-6);
    EXPECT_NEAR(from_hue(1.0f / 3, 1, 0.5f).r, 0, 1e-5);
    EXPECT_NEAR(from_hue(2.0f / 3, 1, 0.5f).b, 1, 1e-6);
    EXPECT_EQ(from_hue(0.4f, 0, 0.3f), rgb(0.3f, 0.3f, 0.3f));
    EXPECT_NEAR(from_hue(1.25f, 0.6f, 0.5f).g, from_hue(0.25f, 0.6f, 0.5f).g, 1e-5);
}

TEST(Camera, pixels_and_metres_are_each_others_inverse)
{
    const Camera camera{.center = {3, -2}, .height = 10};
    const Viewport view{1280, 720};
    EXPECT_EQ(to_pixels(camera, view, {3, -2}), (Vec2{640, 360}));
    EXPECT_EQ(to_pixels(camera, view, {3, 3}).y, 0);
    const Vec2 there_and_back = to_world(camera, view, to_pixels(camera, view, {5.5f, 1.25f}));
    EXPECT_NEAR(there_and_back.x, 5.5f, 1e-5);
    EXPECT_NEAR(there_and_back.y, 1.25f, 1e-5);
}

TEST(DrawList, keeps_layers_apart_and_forgets_when_cleared)
{
    DrawList list;
    list.disc(Layer::Bodies, {1, 2}, 0.5f, {.fill = paper});
    list.line(Layer::Marks, {}, {1, 1}, paper);
    list.text({.text = "hello"});
    EXPECT_EQ(list.layer(Layer::Bodies).shapes.size(), 1u);
    EXPECT_EQ(list.layer(Layer::Marks).lines.size(), 1u);
    EXPECT_EQ(list.layer(Layer::Captions).texts.size(), 1u);
    list.clear();
    for (const DrawnLayer& layer : list.layers()) EXPECT_TRUE(layer.shapes.empty() && layer.lines.empty() && layer.texts.empty());
}

TEST(DrawList, draws_boxes_of_any_size)
{
    DrawList list;
    list.box(Layer::Marks, {{1, 2}, {1, 2}}, {.line = paper});
    list.box(Layer::Marks, {{0, 0}, {1e-5f, 3}}, {.line = paper});
    const auto& thin = std::get<Polygon>(list.layer(Layer::Marks).shapes[1].geometry);
    EXPECT_EQ(thin.vertices[2], (Vec2{1e-5f, 3}));
}

TEST(DrawList, scales_shapes_about_their_middle)
{
    EXPECT_EQ(std::get<Circle>(scaled(circle(2, {1, 1}), 0.5f)).radius, 1);
    EXPECT_EQ(std::get<Circle>(scaled(circle(2, {1, 1}), 0.5f)).center, (Vec2{1, 1}));
    const auto small = std::get<Polygon>(scaled(offset_box(2, 2, {5, 0}), 0.5f));
    EXPECT_NEAR(aabb_of(small, {}).min.x, 4.5f, 1e-5);
    EXPECT_NEAR(aabb_of(small, {}).max.y, 0.5f, 1e-5);
    const auto bar = std::get<Capsule>(scaled(capsule({0, 0}, {4, 0}, 1), 0.5f));
    EXPECT_EQ(bar.p1, (Vec2{1, 0}));
    EXPECT_EQ(bar.radius, 0.5f);
}

} // namespace carom::scenes
