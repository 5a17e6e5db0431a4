// Finds DejaVu Sans where distributions put it.
#include "gallery/fonts.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <imgui.h>
#include <system_error>

namespace carom::gallery
{

namespace
{

constexpr std::array places = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",      // Debian, Ubuntu
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",    // Fedora
    "/usr/share/fonts/TTF/DejaVuSans.ttf",                  // Arch
    "/usr/share/fonts/truetype/DejaVuSans.ttf",             // openSUSE
    "/usr/share/fonts/dejavu/DejaVuSans.ttf",               // Gentoo, Alpine
    "/usr/local/share/fonts/dejavu/DejaVuSans.ttf",         // FreeBSD
    "/run/current-system/sw/share/X11/fonts/DejaVuSans.ttf" // NixOS
};

constexpr float text_size = 15;  // [points]
constexpr float title_size = 20; // [points]
/// Sizes beside those two for the texts of a picture [points].
constexpr std::array picture_sizes = {14.0f, 17.0f, 19.0f, 21.0f, 23.0f, 26.0f, 30.0f, 35.0f};

/// Latin, Greek, dashes and quotes, arrows, signs of mathematics, and the shapes that buttons show.
constexpr std::array<ImWchar, 13> glyphs = {0x0020, 0x00FF, 0x0391, 0x03C9, 0x2010, 0x2026, 0x2190,
                                            0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

const char* installed_font()
{
    std::error_code ignored;
    for (const char* place : places)
    {
        if (std::filesystem::is_regular_file(place, ignored)) return place;
    }
    return nullptr;
}

/// @param size [pixels]
ImFont* add_font(const char* file, float size)
{
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    ImFontConfig config;
    config.OversampleH = 2; // letters may start at halves of a pixel
    config.OversampleV = 1;
    ImFont* const font = file ? atlas.AddFontFromFileTTF(file, size, &config, glyphs.data()) : nullptr;
    if (font) return font;
    config.SizePixels = size;
    return atlas.AddFontDefault(&config);
}

} // namespace

Fonts load_fonts(float ui_scale, float pixels_per_point)
{
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    const char* const file = installed_font();
    const auto in_pixels = [&](float points) { return std::round(points * ui_scale * pixels_per_point); };
    Fonts fonts;
    fonts.text = add_font(file, in_pixels(text_size));
    fonts.title = add_font(file, in_pixels(title_size));
    for (const float size : picture_sizes) add_font(file, in_pixels(size));
    io.FontDefault = fonts.text;
    io.FontGlobalScale = 1 / pixels_per_point;
    return fonts;
}

ImFont* nearest_font(float size)
{
    ImFont* best = ImGui::GetFont();
    for (ImFont* font : ImGui::GetIO().Fonts->Fonts)
    {
        if (std::abs(font->FontSize - size) < std::abs(best->FontSize - size)) best = font;
    }
    return best;
}

} // namespace carom::gallery
