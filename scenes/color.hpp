// Colours, and the few that all scenes share.
#pragma once

namespace carom::scenes
{

/// Red, green, blue and opacity, each 0 to 1. The default is invisible.
struct Color
{
    float r = 0;
    float g = 0;
    float b = 0;
    float a = 0;

    friend constexpr bool operator==(const Color&, const Color&) = default;
};

constexpr Color rgb(float r, float g, float b) { return {r, g, b, 1}; }
constexpr Color with_alpha(Color c, float alpha) { return {c.r, c.g, c.b, alpha}; }
/// From `a` at t = 0 to `b` at t = 1.
constexpr Color mix(Color a, Color b, float t)
{
    return {a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t, a.a + (b.a - a.a) * t};
}
constexpr Color darker(Color c, float amount) { return mix(c, {0, 0, 0, c.a}, amount); }
constexpr Color lighter(Color c, float amount) { return mix(c, {1, 1, 1, c.a}, amount); }

/// A colour from its place on the colour circle.
/// @param hue        0 to 1: red, yellow, green, cyan, blue, magenta, red; other values wrap around
/// @param saturation 0 grey to 1 vivid
/// @param lightness  0 black to 1 white
Color from_hue(float hue, float saturation, float lightness);

inline constexpr Color night = rgb(0.055f, 0.063f, 0.086f); ///< the background of every scene
inline constexpr Color slate = rgb(0.21f, 0.24f, 0.31f);    ///< walls and ground
inline constexpr Color paper = rgb(0.90f, 0.92f, 0.95f);    ///< text
inline constexpr Color fresh = rgb(0.25f, 0.90f, 0.45f);    ///< a touch that began
inline constexpr Color gone = rgb(1.00f, 0.30f, 0.30f);     ///< a touch that ended

} // namespace carom::scenes
