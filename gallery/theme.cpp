// Colours are split into neutral ones, which carry the ground, walls and letters, and vivid ones, which tell things apart.
#include "gallery/theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace carom::gallery
{

namespace
{

using scenes::Color;

/// Quick brightness, 0 to 1: squares stand for the gamma of 2.2, good enough to move colours by.
float brightness(Color c) { return std::sqrt(0.2126f * c.r * c.r + 0.7152f * c.g * c.g + 0.0722f * c.b * c.b); }

/// How far a colour is from grey, 0 to 1.
float chroma(Color c) { return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}); }

/// 0 for greys and tinted greys, 1 for what has a hue of its own.
float vividness(Color c)
{
    const float t = std::clamp((chroma(c) - 0.15f) / 0.12f, 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// Degrees on the colour circle from red, [0, 360).
float hue_of(Color c)
{
    const float top = std::max({c.r, c.g, c.b});
    const float range = chroma(c);
    if (range <= 0) return 0;
    float sector = 0;
    if (top == c.r)
        sector = (c.g - c.b) / range;
    else if (top == c.g)
        sector = 2 + (c.b - c.r) / range;
    else
        sector = 4 + (c.r - c.g) / range;
    return 60 * (sector < 0 ? sector + 6 : sector);
}

Color clamped(Color c) { return {std::clamp(c.r, 0.0f, 1.0f), std::clamp(c.g, 0.0f, 1.0f), std::clamp(c.b, 0.0f, 1.0f), c.a}; }

/// Lightness turned around, the tint kept: night becomes almost white, slate a light grey-blue, paper almost black.
Color turned_around(Color c)
{
    const float level = brightness(c);
    const float turned = 1.03f - 1.02f * level;
    return clamped({turned + (c.r - level), turned + (c.g - level), turned + (c.b - level), c.a});
}

/// Darkened until it does not vanish on white. Yellows go to amber meanwhile: merely darker ones look like mud.
Color for_white_ground(Color c)
{
    constexpr float brightest = 0.66f;
    constexpr Color amber = scenes::rgb(0.87f, 0.58f, 0.03f);
    const float level = brightness(c);
    if (level <= brightest) return c;
    const Color dark = scenes::mix({0, 0, 0, c.a}, c, brightest / level);
    const float from_yellow = std::abs(hue_of(c) - 52);
    const float yellow = std::clamp(1.6f - from_yellow / 15, 0.0f, 1.0f) * std::clamp((level - brightest) / 0.1f, 0.0f, 1.0f);
    const float pale = std::clamp(c.b - 0.32f, 0.0f, 1.0f); // what was lighter stays lighter
    return scenes::mix(dark, with_alpha(lighter(amber, 0.8f * pale), c.a), yellow);
}

Color for_light_theme(Color c) { return scenes::mix(turned_around(c), for_white_ground(c), vividness(c)); }

/// A stretch of the colour circle and what it becomes.
struct SafeHue
{
    float until; ///< [degrees]
    Color color;
};

/// @source M. Okabe and K. Ito, "Color Universal Design", 2008. Its two blues share a hue; which of them is meant follows from the brightness.
constexpr Color vermilion = scenes::rgb(0.835f, 0.369f, 0.0f);
constexpr Color orange = scenes::rgb(0.902f, 0.624f, 0.0f);
constexpr Color yellow = scenes::rgb(0.941f, 0.894f, 0.259f);
constexpr Color bluish_green = scenes::rgb(0.0f, 0.620f, 0.451f);
constexpr Color sky_blue = scenes::rgb(0.337f, 0.706f, 0.914f);
constexpr Color blue = scenes::rgb(0.0f, 0.447f, 0.698f);
constexpr Color reddish_purple = scenes::rgb(0.800f, 0.475f, 0.655f);
constexpr std::array safe_hues = {SafeHue{22, vermilion}, SafeHue{44, orange},          SafeHue{80, yellow},    SafeHue{183, bluish_green},
                                  SafeHue{265, sky_blue}, SafeHue{345, reddish_purple}, SafeHue{361, vermilion}};

/// The safe colour of a hue. A part of the brightness stays, so that borders and shades remain, but too little to take one for another.
Color safe(Color c)
{
    const float hue = hue_of(c);
    const auto* const stretch = std::find_if(safe_hues.begin(), safe_hues.end(), [&](const SafeHue& s) { return hue < s.until; });
    Color target = stretch->color;
    const float level = brightness(c);
    if (target == sky_blue && level < 0.52f) target = blue;
    const float shift = std::clamp(0.8f * (level - brightness(target)), -0.3f, 0.2f);
    const Color shaded = shift < 0 ? darker(target, -shift / brightness(target)) : lighter(target, shift);
    return with_alpha(shaded, c.a);
}

} // namespace

Color Theme::operator()(Color color) const
{
    if (palette_ == Palette::ColorBlindSafe)
    {
        const float share = vividness(color);
        if (share > 0) color = scenes::mix(color, safe(color), share);
    }
    return kind_ == ThemeKind::Light ? for_light_theme(color) : color;
}

Color Theme::for_text(Color color) const
{
    constexpr float enough = 4.5f;
    const Color ground = (*this)(scenes::night);
    const Color end = kind_ == ThemeKind::Light ? Color{0, 0, 0, color.a} : Color{1, 1, 1, color.a};
    const Color themed = (*this)(color);
    Color result = themed;
    for (int i = 1; i <= 20 && contrast(result, ground) < enough; ++i) result = scenes::mix(themed, end, 0.05f * static_cast<float>(i));
    return result;
}

float luminance(Color color)
{
    const auto linear = [](float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); };
    return 0.2126f * linear(color.r) + 0.7152f * linear(color.g) + 0.0722f * linear(color.b);
}

float contrast(Color a, Color b)
{
    const float l_a = luminance(a) + 0.05f;
    const float l_b = luminance(b) + 0.05f;
    return l_a > l_b ? l_a / l_b : l_b / l_a;
}

} // namespace carom::gallery
