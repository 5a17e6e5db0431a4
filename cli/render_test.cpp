// Shapes are drawn where the world has them, pixel by pixel.
#include "cli/render.hpp"

#include <array>
#include <gtest/gtest.h>

namespace carom::cli
{

namespace
{

constexpr scenes::Camera camera{.center = {10, 5}, .height = 10}; // 10 pixels a metre in a picture of 100 pixels
constexpr scenes::Viewport size{200, 100};

struct Pixel
{
    int r, g, b;
    friend bool operator==(const Pixel&, const Pixel&) = default;
};

constexpr Pixel black{0, 0, 0};
constexpr Pixel red{255, 0, 0};

Pixel pixel_at(Canvas& canvas, Vec2 world)
{
    const Vec2 place = to_pixels(camera, size, world);
    const auto offset = 4 * (static_cast<std::size_t>(place.y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(place.x));
    const std::span<const std::byte> pixels = canvas.pixels();
    return {static_cast<int>(pixels[offset + 2]), static_cast<int>(pixels[offset + 1]), static_cast<int>(pixels[offset])};
}

/// A red shape on black.
Canvas drawn(const Geometry& geometry, const Transform& transform, Quality quality = Quality::Fine)
{
    scenes::DrawList list;
    list.background = scenes::rgb(0, 0, 0);
    list.shape(scenes::Layer::Bodies, geometry, transform, {.fill = scenes::rgb(1, 0, 0), .line = scenes::rgb(1, 0, 0)});
    Canvas canvas(size, quality);
    canvas.draw(list, camera);
    return canvas;
}

} // namespace

TEST(Render, circles_are_where_the_world_has_them)
{
    Canvas canvas = drawn(circle(2, {1, 0}), {.p = {8, 6}, .q = rotation(0.5f * pi)}); // centre at (8, 7)
    EXPECT_EQ(pixel_at(canvas, {8, 7}), red);
    EXPECT_EQ(pixel_at(canvas, {8, 8.8f}), red);
    EXPECT_EQ(pixel_at(canvas, {6.2f, 7}), red);
    EXPECT_EQ(pixel_at(canvas, {8, 4.7f}), black);
    EXPECT_EQ(pixel_at(canvas, {9.7f, 8.7f}), black);
}

TEST(Render, boxes_turn_counter_clockwise)
{
    Canvas canvas = drawn(box(6, 1), {.p = {10, 5}, .q = rotation(0.25f * pi)});
    EXPECT_EQ(pixel_at(canvas, {11.8f, 6.8f}), red);
    EXPECT_EQ(pixel_at(canvas, {8.2f, 3.2f}), red);
    EXPECT_EQ(pixel_at(canvas, {11.8f, 3.2f}), black);
}

TEST(Render, rounded_corners_are_round)
{
    Canvas canvas = drawn(rounded_box(6, 6, 1.5f), {.p = {10, 5}, .q = {}});
    EXPECT_EQ(pixel_at(canvas, {12.8f, 5}), red);
    EXPECT_EQ(pixel_at(canvas, {10, 7.8f}), red);
    EXPECT_EQ(pixel_at(canvas, {12.4f, 7.4f}), red);
    EXPECT_EQ(pixel_at(canvas, {12.85f, 7.85f}), black);
}

TEST(Render, capsules_have_round_ends)
{
    Canvas canvas = drawn(capsule({-3, 0}, {3, 0}, 1), {.p = {10, 5}, .q = {}});
    EXPECT_EQ(pixel_at(canvas, {13.8f, 5}), red);
    EXPECT_EQ(pixel_at(canvas, {6.2f, 5}), red);
    EXPECT_EQ(pixel_at(canvas, {10, 5.8f}), red);
    EXPECT_EQ(pixel_at(canvas, {13.85f, 5.85f}), black);
}

TEST(Render, quick_pictures_show_the_same_without_smooth_edges)
{
    const auto between = [](Quality quality)
    {
        Canvas canvas = drawn(circle(3), {.p = {10, 5}, .q = {}}, quality);
        EXPECT_EQ(pixel_at(canvas, {10, 5}), red);
        EXPECT_EQ(pixel_at(canvas, {12.7f, 5}), red);
        EXPECT_EQ(pixel_at(canvas, {12.6f, 7.6f}), black);
        int count = 0;
        for (float x = 5; x < 15; x += 0.1f)
            for (float y = 0.1f; y < 10; y += 0.1f) count += pixel_at(canvas, {x, y}) != red && pixel_at(canvas, {x, y}) != black;
        return count;
    };
    EXPECT_GT(between(Quality::Fine), 30);
    EXPECT_EQ(between(Quality::Quick), 0);
}

TEST(Render, each_picture_starts_afresh)
{
    Canvas canvas = drawn(circle(2), {.p = {10, 5}, .q = {}});
    scenes::DrawList empty;
    empty.background = scenes::rgb(0, 0, 0);
    canvas.draw(empty, camera);
    EXPECT_EQ(pixel_at(canvas, {10, 5}), black);
}

TEST(Render, texts_leave_their_letters)
{
    scenes::DrawList list;
    list.background = scenes::rgb(0, 0, 0);
    list.text({.text = "HHHH", .size = 100, .place = scenes::Place::World, .position = {10, 5}});
    Canvas canvas(size);
    canvas.draw(list, camera);
    int bright = 0;
    for (float x = 7; x < 13; x += 0.1f) bright += pixel_at(canvas, {x, 5}).g > 128;
    EXPECT_GT(bright, 5);
    EXPECT_EQ(pixel_at(canvas, {10, 9}), black);
}

} // namespace carom::cli
