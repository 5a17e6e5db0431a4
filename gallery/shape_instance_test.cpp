// What the graphics card gets: only what shows, in pixels, with edges that stay where they are.
#include "gallery/shape_instance.hpp"

#include <carom/shape.hpp>
#include <cmath>
#include <gtest/gtest.h>

namespace carom::gallery
{

namespace
{

constexpr scenes::Viewport picture{200, 100};
constexpr scenes::Camera camera{.center = {10, 5}, .height = 10}; // 10 pixels a metre; 20 m by 10 m are visible

std::vector<ShapeInstance> instances_of(const scenes::DrawList& list, const scenes::Camera& seen_by = camera)
{
    const Theme theme;
    InstanceMaker maker(seen_by, picture, theme);
    std::vector<ShapeInstance> instances;
    for (const scenes::DrawnLayer& layer : list.layers()) maker.add(layer, instances);
    return instances;
}

std::vector<ShapeInstance> instances_of(const Geometry& geometry, const Transform& transform, const scenes::Paint& paint)
{
    scenes::DrawList list;
    list.shape(scenes::Layer::Bodies, geometry, transform, paint);
    return instances_of(list);
}

constexpr scenes::Paint filled{.fill = scenes::rgb(1, 0.5f, 0), .line = {}};

} // namespace

TEST(ShapeInstance, is_in_pixels_from_the_middle_of_the_picture)
{
    const auto instances =
        instances_of(capsule({-1, 0}, {1, 0}, 0.5f), {.p = {12, 4}, .q = rotation(0.5f * pi)},
                     {.fill = scenes::rgb(1, 0.5f, 0), .line = scenes::with_alpha(scenes::rgb(0, 0, 1), 0.5f), .line_width = 7.2f});
    ASSERT_EQ(instances.size(), 1u);
    const ShapeInstance& it = instances[0];
    EXPECT_EQ(it.count, 2);
    EXPECT_NEAR(it.corners[0].x, 20, 1e-4f);
    EXPECT_NEAR(it.corners[0].y, -20, 1e-4f);
    EXPECT_NEAR(it.corners[1].y, 0, 1e-4f);
    EXPECT_FLOAT_EQ(it.radius, 5);
    EXPECT_FLOAT_EQ(it.half_line, 0.5f);
    EXPECT_EQ(it.fill, 0xff0080ffu);
    EXPECT_EQ(it.line, 0x80ff0000u);
}

TEST(ShapeInstance, is_left_out_when_the_picture_does_not_show_it)
{
    EXPECT_EQ(instances_of(circle(1), {.p = {20.9f, 5}, .q = {}}, filled).size(), 1u);
    EXPECT_EQ(instances_of(circle(1), {.p = {21.2f, 5}, .q = {}}, filled).size(), 0u);
    EXPECT_EQ(instances_of(circle(1), {.p = {10, -1.2f}, .q = {}}, filled).size(), 0u);
    EXPECT_EQ(instances_of(box(1000, 1000), {.p = {10, 5}, .q = {}}, filled).size(), 1u);
    // A wide border reaches farther than the shape.
    EXPECT_EQ(instances_of(circle(1), {.p = {21.2f, 5}, .q = {}}, {.fill = {}, .line = scenes::paper, .line_width = 72}).size(), 1u);
}

TEST(ShapeInstance, of_a_box_far_larger_than_the_picture_keeps_its_near_edge_and_loses_far_corners)
{
    const scenes::Camera close{.center = {}, .height = 0.001f}; // 100,000 pixels a metre
    scenes::DrawList list;
    list.shape(scenes::Layer::Bodies, offset_box(2000, 2000, {0, -1000}), {}, filled); // its upper edge is y = 0
    const auto instances = instances_of(list, close);
    ASSERT_EQ(instances.size(), 1u);
    const auto count = static_cast<std::size_t>(instances[0].count);
    ASSERT_GE(count, 3u);
    float top = -1e9f;
    for (std::size_t i = 0; i < count; ++i)
    {
        const Vec2 a = instances[0].corners[i];
        const Vec2 b = instances[0].corners[(i + 1) % count];
        const Vec2 c = instances[0].corners[(i + 2) % count];
        EXPECT_LE(std::max(std::abs(a.x), std::abs(a.y)), 16385);
        EXPECT_GE(cross(b - a, c - b), 0) << "still counter-clockwise";
        top = std::max(top, a.y);
    }
    EXPECT_EQ(top, 0);
}

TEST(ShapeInstance, of_a_line_far_longer_than_the_picture_keeps_its_course)
{
    const scenes::Camera close{.center = {}, .height = 0.001f};
    scenes::DrawList list;
    list.line(scenes::Layer::Marks, {-1000, -500}, {1000, 500}, scenes::paper);
    list.line(scenes::Layer::Marks, {0, 0}, {1000, 500}, scenes::paper);
    const auto instances = instances_of(list, close);
    ASSERT_EQ(instances.size(), 2u);
    for (const ShapeInstance& it : instances)
    {
        ASSERT_EQ(it.count, 2);
        const Vec2 way = it.corners[1] - it.corners[0];
        EXPECT_NEAR(std::abs(way.y / way.x), 0.5f, 1e-4f);
        EXPECT_NEAR(cross(normalize(way), it.corners[0]), 0, 0.01f) << "passes through the middle";
        EXPECT_LE(length(it.corners[1]), 20000);
    }
    EXPECT_GT(distance(instances[0].corners[0], instances[0].corners[1]), 30000);
    EXPECT_EQ(min(instances[1].corners[0], instances[1].corners[1]), (Vec2{0, 0})) << "the near end stays";
}

} // namespace carom::gallery
