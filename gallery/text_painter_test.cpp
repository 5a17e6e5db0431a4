// Captions keep to the free corners, texts of the world to their place, and all can be read.
#include "gallery/text_painter.hpp"

#include "gallery/testing.hpp"

#include <algorithm>
#include <imgui.h>
#include <limits>

namespace carom::gallery
{

namespace
{

using scenes::DrawList;
using scenes::Place;

/// The pixels that letters touched: from the left and the top, the last ones included.
struct Touched
{
    int left = 1 << 20;
    int top = 1 << 20;
    int right = -1;
    int bottom = -1;
};

class TextPainterTest : public OffscreenTest
{
protected:
    void SetUp() override { open({640, 400}); }

    Picture written(const DrawList& list, ImVec2 free_min, ImVec2 free_max, const Theme& theme = Theme())
    {
        window_->begin_frame();
        renderer_->draw(list, view(), theme);
        paint_texts(list, view(), theme, window_->pixels_per_point(), free_min, free_max);
        window_->end_panels();
        return window_->read_back();
    }
    Touched touched(const DrawList& list, ImVec2 free_min = {0, 0}, ImVec2 free_max = {640, 400})
    {
        const Picture picture = written(list, free_min, free_max);
        Touched result;
        for (int y = 0; y < picture.height; ++y)
        {
            for (int x = 0; x < picture.width; ++x)
            {
                if (picture.at(x, y).g < 0.5f) continue;
                result = {std::min(result.left, x), std::min(result.top, y), std::max(result.right, x), std::max(result.bottom, y)};
            }
        }
        return result;
    }
};

DrawList list_of(scenes::DrawnText text)
{
    DrawList list = black_list();
    list.text(std::move(text));
    return list;
}

} // namespace

TEST_F(TextPainterTest, captions_start_in_the_free_corner)
{
    const Touched everywhere = touched(list_of({.text = "HHH", .size = 36, .place = Place::TopLeft}));
    EXPECT_NEAR(everywhere.left, 12, 4);
    EXPECT_LT(everywhere.top, 30);
    const Touched beside_panels = touched(list_of({.text = "HHH", .size = 36, .place = Place::TopLeft}), {200, 80}, {640, 400});
    EXPECT_NEAR(beside_panels.left, 200 + 8, 4);
    EXPECT_GT(beside_panels.top, 80);
    EXPECT_LT(beside_panels.top, 100);
    const Touched below = touched(list_of({.text = "HHH", .size = 36, .place = Place::BottomLeft}), {200, 80}, {640, 300});
    EXPECT_LT(below.bottom, 300);
    EXPECT_GT(below.top, 260);
}

TEST_F(TextPainterTest, captions_lie_below_each_other_and_from_the_bottom_above)
{
    for (const Place place : {Place::TopLeft, Place::BottomLeft})
    {
        DrawList two = list_of({.text = "HHH", .size = 30, .place = place});
        two.text({.text = "HHH", .size = 30, .place = place});
        const Touched first = touched(list_of({.text = "HHH", .size = 30, .place = place}));
        const Touched both = touched(two);
        EXPECT_GT(both.bottom - both.top, 2 * (first.bottom - first.top));
        EXPECT_EQ(place == Place::TopLeft ? both.top : both.bottom, place == Place::TopLeft ? first.top : first.bottom);
    }
}

TEST_F(TextPainterTest, long_captions_break_at_the_free_width)
{
    const std::string words = "many words that do not fit into a narrow part of the window, and so they go on in the next line";
    const Touched narrow = touched(list_of({.text = words, .size = 30, .place = Place::TopLeft}), {0, 0}, {250, 400});
    const Touched line = touched(list_of({.text = "many", .size = 30, .place = Place::TopLeft}), {0, 0}, {250, 400});
    EXPECT_LT(narrow.right, 250);
    EXPECT_GT(narrow.bottom - narrow.top, 2 * (line.bottom - line.top));
}

TEST_F(TextPainterTest, texts_of_the_world_are_centred_at_their_place)
{
    const Touched text = touched(list_of({.text = "HHHH", .size = 40, .place = Place::World, .position = {100, 50}}));
    EXPECT_NEAR(0.5f * static_cast<float>(text.left + text.right), 420, 2);
    EXPECT_NEAR(0.5f * static_cast<float>(text.top + text.bottom), 150, 3);
}

TEST_F(TextPainterTest, texts_that_are_nowhere_in_the_window_write_nothing)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    DrawList list = black_list();
    for (const Vec2 place : {Vec2{500, 0}, {0, -300}, {1e30f, -1e30f}, {nan, 0}})
        list.text({.text = "HHHH", .size = 40, .place = Place::World, .position = place});
    EXPECT_EQ(touched(list).right, -1);
}

TEST_F(TextPainterTest, letters_are_never_too_small_nor_too_large)
{
    const Touched small = touched(list_of({.text = "H", .size = 1, .place = Place::TopLeft}));
    EXPECT_GE(small.bottom - small.top, 7); // capitals are 0.7 of a size of 12
    const Touched large = touched(list_of({.text = "H", .size = 500, .place = Place::TopLeft}));
    EXPECT_LE(large.bottom - large.top, 24);
}

TEST_F(TextPainterTest, letters_have_a_rim_in_the_colour_of_the_ground)
{
    DrawList list = list_of({.text = "HHHH", .color = white, .size = 40, .place = Place::World, .position = {}});
    list.disc(scenes::Layer::Bodies, {}, 100, {.fill = white, .line = {}}); // white on white
    const Picture picture = written(list, {0, 0}, {640, 400});
    float darkest = 1;
    for (int x = 270; x < 370; ++x) darkest = std::min(darkest, picture.at(x, 200).g);
    EXPECT_LT(darkest, 0.45f);
}

} // namespace carom::gallery
