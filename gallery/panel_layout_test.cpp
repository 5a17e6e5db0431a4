#include "gallery/panel_layout.hpp"

#include <gtest/gtest.h>

namespace carom::gallery
{

namespace
{

constexpr PanelLayout::Heights below = {.bar = 40, .status = 24};

float width_of(const Rect& rect) { return rect.size().x; }

float share_of_scene(const PanelLayout& layout, Vec2 window)
{
    const Rect scene = layout.places(window, 1, below).scene;
    return scene.size().x * scene.size().y / (window.x * window.y);
}

} // namespace

TEST(PanelLayout, leaves_the_scene_half_of_the_width_at_least)
{
    const PanelLayout layout;
    for (const Vec2 window : {Vec2{1920, 1080}, Vec2{1600, 900}, Vec2{1280, 800}, Vec2{1024, 768}, Vec2{800, 600}, Vec2{400, 300}})
        EXPECT_GE(width_of(layout.places(window, 1, below).scene), 0.5f * window.x) << window.x;
}

TEST(PanelLayout, folds_one_panel_by_itself_at_800_by_600)
{
    const PanelLayout layout;
    const Vec2 window = {800, 600};
    EXPECT_FALSE(layout.is_folded(PanelSide::Left, window, 1));
    EXPECT_TRUE(layout.is_folded(PanelSide::Right, window, 1));
    EXPECT_GT(share_of_scene(layout, window), 0.55f);
    EXPECT_FALSE(layout.is_folded(PanelSide::Right, {1280, 800}, 1));
}

TEST(PanelLayout, opens_the_other_panel_in_place_of_the_first_where_both_do_not_fit)
{
    PanelLayout layout;
    const Vec2 window = {800, 600};
    layout.toggle(PanelSide::Right, window, 1);
    EXPECT_TRUE(layout.is_folded(PanelSide::Left, window, 1));
    EXPECT_FALSE(layout.is_folded(PanelSide::Right, window, 1));
    layout.toggle(PanelSide::Left, window, 1);
    EXPECT_FALSE(layout.is_folded(PanelSide::Left, window, 1));
    EXPECT_TRUE(layout.is_folded(PanelSide::Right, window, 1));
    EXPECT_FALSE(layout.is_folded(PanelSide::Right, {1600, 900}, 1)) << "in a large window both are open again";
}

TEST(PanelLayout, gives_the_room_of_folded_panels_to_the_scene)
{
    PanelLayout layout;
    const Vec2 window = {1600, 900};
    layout.toggle(PanelSide::Left, window, 1);
    layout.toggle(PanelSide::Right, window, 1);
    EXPECT_GT(share_of_scene(layout, window), 0.88f);
    layout.toggle(PanelSide::Left, window, 1);
    EXPECT_FALSE(layout.is_folded(PanelSide::Left, window, 1));
}

TEST(PanelLayout, follows_a_drag_and_keeps_room_for_all)
{
    PanelLayout layout;
    const Vec2 window = {1600, 900};
    layout.drag(PanelSide::Left, 400, window, 1);
    EXPECT_NEAR(width_of(layout.places(window, 1, below).sides[0]), 400, 0.5f);
    layout.drag(PanelSide::Right, 500, window, 1);
    EXPECT_NEAR(width_of(layout.places(window, 1, below).sides[1]), 500, 0.5f);
    EXPECT_NEAR(width_of(layout.places(window, 1, below).sides[0]), 400, 0.5f);
    layout.drag(PanelSide::Left, 5, window, 1);
    EXPECT_GT(width_of(layout.places(window, 1, below).sides[0]), 150) << "narrower it could not be read";
    layout.drag(PanelSide::Left, 5000, window, 1);
    EXPECT_GE(width_of(layout.places(window, 1, below).scene), 0.29f * window.x);
}

TEST(PanelLayout, covers_the_window_without_gaps)
{
    const PanelLayout layout;
    for (const Vec2 window : {Vec2{1600, 900}, Vec2{800, 600}, Vec2{37, 41}, Vec2{1, 1}})
    {
        const PanelLayout::Places p = layout.places(window, 1, below);
        EXPECT_EQ(p.sides[0].max.x, p.scene.min.x);
        EXPECT_EQ(p.sides[1].min.x, p.scene.max.x);
        EXPECT_EQ(p.scene.max.y, p.bar.min.y);
        EXPECT_EQ(p.bar.max.y, p.status.min.y);
        EXPECT_EQ(p.status.max, window);
        EXPECT_GT(width_of(p.scene), 0);
    }
}

} // namespace carom::gallery
