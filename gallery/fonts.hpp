// The letters of panels and pictures, in the sizes that are drawn.
#pragma once

struct ImFont;

namespace carom::gallery
{

/// What panels use.
struct Fonts
{
    ImFont* text = nullptr;  ///< 15 points; Dear ImGui's default
    ImFont* title = nullptr; ///< 20 points
};

/// Fills the font atlas of Dear ImGui's current context with DejaVu Sans, or with Dear ImGui's own font where that is not installed.
/// @param ui_scale         Window::ui_scale()
/// @param pixels_per_point Window::pixels_per_point(); letters are made for pixels, so that they are crisp
Fonts load_fonts(float ui_scale, float pixels_per_point);

/// A font's size is the distance of its lines. Other programs, Cairo among them, mean the design's square by it, which in DejaVu is so much smaller.
inline constexpr float line_distance = 1.164f;

/// The font of the atlas whose own size is nearest, so that letters are drawn as they were made and not stretched.
/// @param size [pixels]
ImFont* nearest_font(float size);

} // namespace carom::gallery
