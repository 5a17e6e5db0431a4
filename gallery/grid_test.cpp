#include "gallery/grid.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace carom::gallery
{

namespace
{

using scenes::DrawList;
using scenes::Layer;

/// A window of 1000 x 800 points whose lower 100 points a panel covers.
View view_of(float height)
{
    View view;
    view.set_layout({1000, 800}, {{0, 0}, {1000, 700}});
    view.set_base({.center = {3, 2}, .height = height});
    return view;
}

} // namespace

TEST(Grid, has_round_distances)
{
    EXPECT_FLOAT_EQ(round_distance(0.9f), 1);
    EXPECT_FLOAT_EQ(round_distance(1.1f), 2);
    EXPECT_FLOAT_EQ(round_distance(2.1f), 5);
    EXPECT_FLOAT_EQ(round_distance(5.1f), 10);
    EXPECT_FLOAT_EQ(round_distance(0.1f), 0.1f);
    EXPECT_FLOAT_EQ(round_distance(0.03f), 0.05f);
    EXPECT_FLOAT_EQ(round_distance(1234), 2000);
}

TEST(Grid, says_distances_in_a_fitting_unit)
{
    EXPECT_EQ(distance_text(5), "5 m");
    EXPECT_EQ(distance_text(0.2f), "20 cm");
    EXPECT_EQ(distance_text(2000), "2 km");
    EXPECT_EQ(distance_text(0.005f), "5 mm");
}

TEST(Grid, lines_are_round_distances_apart_at_every_zoom)
{
    for (const float height : {0.05f, 1.0f, 20.0f, 3000.0f})
    {
        const View view = view_of(height);
        DrawList list;
        draw_grid(view, list);
        const auto& lines = list.layer(Layer::Background).lines;
        ASSERT_GT(lines.size(), 10u) << height;
        ASSERT_LT(lines.size(), 80u) << height;
        const float spacing = lines[1].from.x - lines[0].from.x;
        EXPECT_NEAR(spacing, round_distance(0.999f * spacing), 1e-3f * spacing);
        EXPECT_GE(spacing * view.points_per_metre(), 40);
        EXPECT_NEAR(std::remainder(lines[0].from.x, spacing), 0, 5e-2f * spacing) << "to the precision of float";
    }
}

TEST(Grid, the_bar_is_as_long_as_it_says_and_lies_beside_the_panels)
{
    const View view = view_of(20);
    DrawList list;
    draw_grid(view, list);
    const auto& bar = list.layer(Layer::Marks).lines.front();
    EXPECT_EQ(distance_text(bar.to.x - bar.from.x), list.layer(Layer::Captions).texts.front().text);
    const Vec2 end = view.to_points(bar.to);
    EXPECT_LT(end.y, 700);
    EXPECT_GT(end.y, 650);
    EXPECT_GT(end.x, 950);
    EXPECT_LT(end.x, 1000);
}

} // namespace carom::gallery
