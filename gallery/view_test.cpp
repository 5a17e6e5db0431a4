#include "gallery/view.hpp"

#include <gtest/gtest.h>

namespace carom::gallery
{

namespace
{

void expect_near(Vec2 a, Vec2 b, float tolerance)
{
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
}

View view_of(int width, int height, const Rect& free)
{
    View view;
    view.set_layout({width, height}, free);
    view.set_base({{3, 4}, 18});
    return view;
}

} // namespace

TEST(View, shows_the_whole_picture_of_the_scene_in_the_free_part)
{
    const Rect free = {{300, 0}, {1600, 850}};
    const View view = view_of(1920, 900, free);
    expect_near(view.to_points({3, 4}), {950, 425}, 0.01f);
    for (const Vec2 corner : {Vec2{-16, -9}, Vec2{16, -9}, Vec2{-16, 9}, Vec2{16, 9}})
    {
        const Vec2 at = view.to_points(Vec2{3, 4} + corner);
        EXPECT_GE(at.x, free.min.x - 0.01f);
        EXPECT_LE(at.x, free.max.x + 0.01f);
        EXPECT_GE(at.y, free.min.y - 0.01f);
        EXPECT_LE(at.y, free.max.y + 0.01f);
    }
}

TEST(View, keeps_what_is_under_the_pointer_when_it_zooms)
{
    View view = view_of(1280, 720, {{0, 0}, {1280, 720}});
    const Vec2 pointer = {200, 610};
    const Vec2 world = view.to_world(pointer);
    view.zoom_at(pointer, 2.5f);
    expect_near(view.to_world(pointer), world, 1e-3f);
    EXPECT_NEAR(view.camera().height, 18 / 2.5f, 1e-4f);
    for (int i = 0; i < 200; ++i) view.zoom_at(pointer, 10);
    EXPECT_EQ(view.zoom(), View::most_zoom);
    view.zoom_at(pointer, 0);
    EXPECT_EQ(view.zoom(), View::most_zoom);
    view.reset();
    expect_near(view.camera().center, {3, 4}, 1e-5f);
}

TEST(View, moves_with_the_pointer)
{
    View view = view_of(1280, 720, {{0, 0}, {1280, 720}});
    const Vec2 grabbed = view.to_world({400, 300});
    view.pan({50, -20});
    expect_near(view.to_points(grabbed), {450, 280}, 0.01f);
}

TEST(View, follows_a_place_and_stays_when_it_no_longer_does)
{
    View view = view_of(1280, 720, {{0, 0}, {1280, 720}});
    view.pan({500, 500});
    view.follow(Vec2{20, -5});
    expect_near(view.camera().center, {20, -5}, 1e-4f);
    view.follow(Vec2{21, -5});
    view.set_base({{-7, 0}, 18});
    expect_near(view.camera().center, {21, -5}, 1e-4f);
    view.follow(std::nullopt);
    expect_near(view.camera().center, {21, -5}, 1e-4f);
}

TEST(View, takes_a_window_of_one_point_and_panels_that_cover_all)
{
    View view = view_of(1, 1, {{300, 200}, {-50, 10}});
    EXPECT_GT(view.points_per_metre(), 0);
    expect_near(view.to_world(view.to_points({1, 1})), {1, 1}, 1e-3f);
    view.set_layout({800, 600}, {{500, 0}, {300, 600}});
    EXPECT_GT(view.points_per_metre(), 0);
}

} // namespace carom::gallery
