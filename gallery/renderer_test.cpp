// Shapes are drawn where the world has them, as large as they are, smooth and in order.
#include "gallery/testing.hpp"

#include <carom/shape.hpp>
#include <cmath>
#include <limits>

namespace carom::gallery
{

namespace
{

using scenes::DrawList;
using scenes::Layer;
using scenes::Paint;

class RendererTest : public OffscreenTest
{
protected:
    /// Red on black, one pixel a metre.
    Picture drawn_shape(const Geometry& geometry, const Transform& transform = {}, const Paint& paint = {.fill = red, .line = {}})
    {
        DrawList list = black_list();
        list.shape(Layer::Bodies, geometry, transform, paint);
        return drawn(list);
    }
};

} // namespace

TEST_F(RendererTest, discs_have_their_place_and_area)
{
    const Picture picture = drawn_shape(circle(40, {10, 0}), {.p = {20, 15}, .q = rotation(0.5f * pi)}); // centre at (20, 25)
    EXPECT_EQ(color_at(picture, {20, 25}), red);
    EXPECT_EQ(color_at(picture, {20, 64}), red);
    EXPECT_EQ(color_at(picture, {-18, 25}), red);
    EXPECT_EQ(color_at(picture, {20, 67}), black);
    EXPECT_EQ(color_at(picture, {49, 54}), black);
    const double area = std::acos(-1.0) * 40 * 40;
    EXPECT_NEAR(red_area(picture), area, 0.01 * area);
}

TEST_F(RendererTest, polygons_of_every_number_of_corners_have_their_area)
{
    for (int corners = 3; corners <= 8; ++corners)
    {
        std::vector<Vec2> points;
        for (int i = 0; i < corners; ++i)
        {
            const SinCos v = sin_cos(2 * pi * static_cast<float>(i) / static_cast<float>(corners));
            points.push_back(60 * Vec2{v.cos, v.sin});
        }
        for (const float radius : {0.0f, 12.0f})
        {
            const Polygon polygon = convex_hull(points, radius);
            const double area = static_cast<double>(mass_of(polygon, 1).mass);
            const Picture picture = drawn_shape(polygon, {.p = {3, -5}, .q = rotation(0.4f)});
            EXPECT_NEAR(red_area(picture), area, 0.01 * area) << corners << " corners, radius " << radius;
        }
    }
}

TEST_F(RendererTest, boxes_turn_counter_clockwise_and_rounded_corners_are_round)
{
    const Picture bar = drawn_shape(box(120, 20), {.p = {}, .q = rotation(0.25f * pi)});
    EXPECT_EQ(color_at(bar, {36, 36}), red);
    EXPECT_EQ(color_at(bar, {-36, -36}), red);
    EXPECT_EQ(color_at(bar, {36, -36}), black);
    const Picture rounded = drawn_shape(rounded_box(120, 120, 30));
    EXPECT_EQ(color_at(rounded, {58, 0}), red);
    EXPECT_EQ(color_at(rounded, {50, 50}), red);
    EXPECT_EQ(color_at(rounded, {56, 56}), black);
}

TEST_F(RendererTest, capsules_have_round_ends)
{
    const Picture picture = drawn_shape(capsule({-50, 0}, {50, 0}, 20));
    EXPECT_EQ(color_at(picture, {68, 0}), red);
    EXPECT_EQ(color_at(picture, {0, -18}), red);
    EXPECT_EQ(color_at(picture, {67, 17}), black);
    const double area = static_cast<double>(mass_of(capsule({-50, 0}, {50, 0}, 20), 1).mass);
    EXPECT_NEAR(red_area(picture), area, 0.01 * area);
}

TEST_F(RendererTest, borders_lie_on_the_edge_half_inside)
{
    // 36 units of 1/720 of 200 pixels are 10 pixels.
    const Paint paint{.fill = red, .line = green, .line_width = 36};
    for (const Geometry& geometry : {Geometry(box(100, 100)), Geometry(circle(50)),
                                     Geometry(convex_hull(std::array<Vec2, 5>{{{50, -50}, {50, 50}, {-50, 50}, {-50, -50}, {0, -60}}}))})
    {
        const Picture picture = drawn_shape(geometry, {}, paint);
        EXPECT_EQ(color_at(picture, {0, 0}), red);
        EXPECT_EQ(color_at(picture, {43, 0}), red);
        EXPECT_EQ(color_at(picture, {46.5f, 0}), green);
        EXPECT_EQ(color_at(picture, {53.5f, 0}), green);
        EXPECT_EQ(color_at(picture, {57, 0}), black);
    }
}

TEST_F(RendererTest, shapes_without_a_fill_show_what_is_behind_and_their_whole_border)
{
    const Paint paint{.fill = {}, .line = red, .line_width = 14.4f}; // 4 pixels
    const Picture frame = drawn_shape(box(100, 60), {.p = {}, .q = rotation(0.3f)}, paint);
    EXPECT_EQ(color_at(frame, {0, 0}), black);
    const double frame_area = 4 * 2 * (100 + 60) + (std::acos(-1.0) - 4) * 4; // the outer corners are round
    EXPECT_NEAR(red_area(frame), frame_area, 0.01 * frame_area);
    const Picture ring = drawn_shape(circle(50), {}, paint);
    EXPECT_EQ(color_at(ring, {0, 0}), black);
    const double ring_area = 4 * 2 * std::acos(-1.0) * 50;
    EXPECT_NEAR(red_area(ring), ring_area, 0.01 * ring_area);
}

TEST_F(RendererTest, segments_and_lines_are_as_wide_as_asked)
{
    const Picture edge = drawn_shape(segment({-50, 10}, {50, 10}), {}, {.fill = red, .line = red, .line_width = 21.6f}); // 6 pixels
    EXPECT_EQ(color_at(edge, {0, 12.5f}), red);
    EXPECT_EQ(color_at(edge, {0, 14.5f}), black);

    DrawList list = black_list();
    list.line(Layer::Marks, {-50, -30}, {50, 30}, red, 10.8f); // 3 pixels
    const double length = std::hypot(100.0, 60.0);
    EXPECT_NEAR(red_area(drawn(list)), 3 * length + std::acos(-1.0) * 2.25, 0.01 * 3 * length);
}

TEST_F(RendererTest, translucent_lines_that_follow_each_other_show_no_joints)
{
    DrawList list = black_list();
    for (int i = -5; i < 5; ++i)
    {
        const auto x = 10.3f * static_cast<float>(i);
        list.line(Layer::Trails, {x, 0}, {x + 10.3f, 0}, with_alpha(red, 0.5f), 36); // 10 pixels
    }
    const Picture picture = drawn(list);
    for (float x = -40; x < 40; ++x) EXPECT_NEAR(color_at(picture, {x, 0}).r, 0.5f, 0.13f) << "at " << x;
}

TEST_F(RendererTest, later_shapes_cover_earlier_ones_and_layers_have_their_order)
{
    DrawList list = black_list();
    list.line(Layer::Bodies, {-90, 0}, {90, 0}, white, 36);
    list.disc(Layer::Marks, {60, 0}, 10, {.fill = red, .line = {}});
    list.disc(Layer::Bodies, {0, 20}, 30, {.fill = red, .line = {}});
    list.disc(Layer::Bodies, {0, 40}, 30, {.fill = green, .line = {}});
    list.disc(Layer::Background, {60, 0}, 30, {.fill = green, .line = {}});
    const Picture picture = drawn(list);
    EXPECT_EQ(color_at(picture, {0, 30}), green);
    EXPECT_EQ(color_at(picture, {0, 7}), red);
    EXPECT_EQ(color_at(picture, {0, 0}), white); // lines over shapes of their layer
    EXPECT_EQ(color_at(picture, {60, 0}), red);
    EXPECT_EQ(color_at(picture, {60, 20}), green);
    EXPECT_EQ(renderer_->last().draw_calls, 1);
    EXPECT_EQ(renderer_->last().instances, 5);
}

TEST_F(RendererTest, translucent_fills_blend_with_what_is_behind)
{
    DrawList list = black_list();
    list.background = white;
    list.disc(Layer::Bodies, {}, 50, {.fill = with_alpha(red, 0.25f), .line = {}});
    const scenes::Color c = color_at(drawn(list), {});
    EXPECT_NEAR(c.r, 1, 0.01f);
    EXPECT_NEAR(c.g, 0.75f, 0.01f);
    EXPECT_NEAR(c.b, 0.75f, 0.01f);
}

TEST_F(RendererTest, what_is_smaller_than_a_pixel_is_as_faint_as_it_is_small)
{
    DrawList list;
    for (const float radius : {0.2f, 0.5f, 1.0f, 2.0f})
    {
        list.clear();
        list.background = black;
        for (int x = -20; x < 20; ++x)
        {
            for (int y = -15; y < 15; ++y)
                list.disc(Layer::Bodies, {6.37f * static_cast<float>(x), 6.13f * static_cast<float>(y)}, radius, {.fill = red, .line = {}});
        }
        const double area = 40 * 30 * std::acos(-1.0) * static_cast<double>(radius * radius);
        EXPECT_NEAR(red_area(drawn(list)), area, 0.04 * area) << "discs of radius " << radius;
    }

    list.clear();
    list.background = black;
    list.shape(Layer::Bodies, box(200, 0.25f), {.p = {0.3f, 0.2f}, .q = rotation(0.2f)}, {.fill = red, .line = {}});
    EXPECT_NEAR(red_area(drawn(list)), 50, 5);

    list.clear();
    list.background = black;
    list.line(Layer::Bodies, {-70, -40}, {70, 50}, red, 1.8f); // half a pixel
    const double length = std::hypot(140.0, 90.0);
    EXPECT_NEAR(red_area(drawn(list)), 0.5 * length, 0.1 * length);
}

TEST_F(RendererTest, edges_of_huge_shapes_stay_where_they_are)
{
    // 100,000 pixels a metre: the shapes are millions of pixels wide and their edges pass near the middle of the picture.
    const Renderer::View close{.camera = {.center = {}, .height = 0.002f}, .viewport = window_->pixels()};
    const std::array geometries = {Geometry(circle(1000, {-1000, 0})), Geometry(offset_box(2000, 2000, {-1000, 0})),
                                   Geometry(capsule({-10, -500}, {-10, 500}, 10)),
                                   Geometry(convex_hull(std::array<Vec2, 5>{{{0, -100}, {0, 100}, {-100, 200}, {-300, 0}, {-100, -200}}}))};
    for (const Geometry& geometry : geometries)
    {
        DrawList list = black_list();
        list.shape(Layer::Bodies, geometry, {}, {.fill = red, .line = {}});
        const Picture picture = drawn(list, close);
        for (const float y : {-90.0f, 0.0f, 90.0f})
        {
            EXPECT_EQ(color_at(picture, {-3, y}), red) << "shape " << geometry.index();
            EXPECT_EQ(color_at(picture, {3, y}), black) << "shape " << geometry.index();
        }
    }
}

TEST_F(RendererTest, far_from_the_origin_pictures_are_the_same)
{
    const auto picture_at = [&](Vec2 origin)
    {
        DrawList list = black_list();
        list.shape(Layer::Bodies, box(10, 6), {.p = origin + Vec2{3, 2}, .q = rotation(0.3f)}, {.fill = red, .line = green});
        list.disc(Layer::Bodies, origin + Vec2{-5, 1}, 4, {.fill = red, .line = green});
        list.line(Layer::Marks, origin, origin + Vec2{8, -3}, white);
        return drawn(list, {.camera = {.center = origin, .height = 20}, .viewport = window_->pixels()});
    };
    EXPECT_EQ(picture_at({0, 0}).rgba, picture_at({262144, -131072}).rgba); // powers of two, where float has the same offsets
}

TEST_F(RendererTest, what_is_not_finite_or_has_no_height_shows_nothing)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    DrawList list = black_list();
    list.disc(Layer::Bodies, {nan, 0}, 10, {.fill = red, .line = {}});
    list.disc(Layer::Bodies, {0, 0}, infinity, {.fill = red, .line = {}});
    list.line(Layer::Bodies, {0, 0}, {infinity, nan}, red);
    list.shape(Layer::Bodies, box(20, 20), {.p = {}, .q = {.c = nan, .s = 0}}, {.fill = red, .line = {}});
    EXPECT_EQ(red_area(drawn(list)), 0);
    list.disc(Layer::Bodies, {}, 10, {.fill = red, .line = {}});
    for (const float height : {0.0f, -5.0f, nan, infinity})
    {
        EXPECT_EQ(red_area(drawn(list, {.camera = {.center = {}, .height = height}, .viewport = window_->pixels()})), 0);
        EXPECT_EQ(renderer_->last().draw_calls, 0);
    }
    EXPECT_GT(red_area(drawn(list)), 300);
}

TEST_F(RendererTest, a_picture_of_one_pixel_has_the_colour_of_what_is_there)
{
    open({1, 1});
    DrawList list = black_list();
    list.disc(Layer::Bodies, {}, 5, {.fill = red, .line = {}});
    const Picture picture = drawn(list);
    EXPECT_EQ(picture.at(0, 0), red);
    EXPECT_EQ(picture.rgba.size(), 4u * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
}

TEST_F(RendererTest, colours_are_those_of_the_theme)
{
    DrawList list;
    list.disc(Layer::Bodies, {}, 50, {.fill = scenes::gone, .line = {}});
    const Theme theme(ThemeKind::Light, Palette::ColorBlindSafe);
    const Picture picture = drawn(list, view(), theme);
    const auto expect_near = [](scenes::Color a, scenes::Color b)
    {
        EXPECT_NEAR(a.r, b.r, 0.01f);
        EXPECT_NEAR(a.g, b.g, 0.01f);
        EXPECT_NEAR(a.b, b.b, 0.01f);
    };
    expect_near(color_at(picture, {}), theme(scenes::gone));
    expect_near(color_at(picture, {80, 80}), theme(scenes::night));
}

} // namespace carom::gallery
