// Places texts as the command line's pictures do, and takes letters in the size that is there.
#include "gallery/text_painter.hpp"

#include "gallery/fonts.hpp"
#include "gallery/shape_instance.hpp"

#include <algorithm>
#include <array>
#include <cfloat>

namespace carom::gallery
{

namespace
{

using scenes::Color;
using scenes::DrawnText;
using scenes::Place;

constexpr float smallest = 12;         // of a caption [points]
constexpr float smallest_in_world = 9; // of a text among the bodies, which must not run into the next one [points]
constexpr float largest = 30;          // [points]
constexpr float margin = 18;           // in 1/720 of the fitted picture's height

ImU32 packed(Color c) { return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, c.a}); }

/// How a text looks and what room it takes.
struct Letters
{
    ImFont* font;
    float size;    ///< of a line [points]
    float width;   ///< where lines break; 0 for never [points]
    ImVec2 extent; ///< [points]
};

class Painter
{
public:
    Painter(const Renderer::View& view, const Theme& theme, Color rim, float pixels_per_point, ImVec2 free_min, ImVec2 free_max)
        : view_(view),
          theme_(theme),
          rim_(rim),
          pixels_per_point_(pixels_per_point),
          free_min_(free_min),
          free_max_(free_max)
    {
        // Scenes are composed for pictures of 16 to 9, and fitted into the free part as such.
        const float fitted = std::min(free_max.y - free_min.y, (free_max.x - free_min.x) * 9 / 16);
        unit_ = std::max(fitted, 1.0f) / reference_height;
        ui_scale_ = std::max(ImGui::GetFontSize() / 15, 1.0f);
        top_ = free_min.y + margin * unit_;
        bottom_ = free_max.y - margin * unit_;
    }

    void paint(const DrawnText& text)
    {
        const Letters letters = letters_for(text);
        const float line_space = 0.2f * letters.size;
        ImVec2 place{free_min_.x + margin * unit_, top_};
        if (text.place == Place::TopLeft) top_ += letters.extent.y + line_space;
        if (text.place == Place::BottomLeft)
        {
            place.y = bottom_ - letters.extent.y;
            bottom_ = place.y - line_space;
        }
        if (text.place == Place::World)
        {
            const Vec2 middle = to_pixels(view_.camera, view_.viewport, text.position) / pixels_per_point_;
            place = {middle.x - 0.5f * letters.extent.x, middle.y - 0.5f * letters.extent.y};
            if (!is_visible(place, letters.extent)) return;
        }
        write(text, letters, place);
    }

private:
    Letters letters_for(const DrawnText& text) const
    {
        const float least = text.place == Place::World ? smallest_in_world : smallest;
        const float wanted = std::clamp(unit_ * text.size, least * ui_scale_, largest * ui_scale_);
        Letters letters{.font = nearest_font(line_distance * wanted * pixels_per_point_), .size = 0, .width = 0, .extent = {}};
        letters.size = letters.font->FontSize / pixels_per_point_;
        if (text.place != Place::World) letters.width = std::max(free_max_.x - free_min_.x - 2 * margin * unit_, 4 * letters.size);
        letters.extent = letters.font->CalcTextSizeA(letters.size, FLT_MAX, letters.width, text.text.c_str());
        return letters;
    }

    /// False also for what is not finite.
    static bool is_visible(ImVec2 place, ImVec2 extent)
    {
        const ImVec2 window = ImGui::GetIO().DisplaySize;
        return place.x < window.x && place.y < window.y && place.x + extent.x > 0 && place.y + extent.y > 0;
    }

    void write(const DrawnText& text, const Letters& letters, ImVec2 place) const
    {
        ImDrawList& list = *ImGui::GetBackgroundDrawList();
        const char* const begin = text.text.c_str();
        const char* const end = begin + text.text.size();
        const Color letter_color = theme_.for_text(text.color);
        const ImU32 rim = packed(with_alpha(rim_, 0.45f * text.color.a));
        const float step = std::max(1.0f, letters.size / 18);
        constexpr std::array<Vec2, 8> around = {Vec2{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
        for (const Vec2 way : around)
            list.AddText(letters.font, letters.size, {place.x + step * way.x, place.y + step * way.y}, rim, begin, end, letters.width);
        list.AddText(letters.font, letters.size, place, packed(letter_color), begin, end, letters.width);
    }

    const Renderer::View& view_;
    const Theme& theme_;
    Color rim_;
    float pixels_per_point_;
    ImVec2 free_min_;
    ImVec2 free_max_;
    float unit_ = 1;     ///< 1/720 of the fitted picture's height [points]
    float ui_scale_ = 1; ///< of the panels' letters
    float top_ = 0;      ///< where the next caption from the top goes [points]
    float bottom_ = 0;
};

} // namespace

void paint_texts(const scenes::DrawList& list, const Renderer::View& view, const Theme& theme, float pixels_per_point, ImVec2 free_min,
                 ImVec2 free_max)
{
    Painter painter(view, theme, theme(list.background), pixels_per_point, free_min, free_max);
    for (const scenes::DrawnLayer& layer : list.layers())
    {
        for (const DrawnText& text : layer.texts) painter.paint(text);
    }
}

} // namespace carom::gallery
