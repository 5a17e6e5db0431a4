// Dark and light, and colours that everybody can tell apart.
#pragma once

#include "scenes/color.hpp"

namespace carom::gallery
{

enum class ThemeKind
{
    Dark,
    Light
};

enum class Palette
{
    Scene,         ///< the colours that scenes ask for
    ColorBlindSafe ///< vivid ones become the nearest of the eight colours of Okabe and Ito
};

/// Turns the colours that scenes ask for, which are made for a dark ground, into those of a theme and a palette. Opacity is kept.
class Theme
{
public:
    explicit Theme(ThemeKind kind = ThemeKind::Dark, Palette palette = Palette::Scene) : kind_(kind), palette_(palette) {}

    ThemeKind kind() const { return kind_; }
    Palette palette() const { return palette_; }

    scenes::Color operator()(scenes::Color color) const;
    /// The same for letters: also moved away from the theme's ground until they can be read on it (contrast of at least 4.5).
    scenes::Color for_text(scenes::Color color) const;

private:
    ThemeKind kind_;
    Palette palette_;
};

/// Brightness as the eye weighs it, from 0 black to 1 white: the relative luminance of WCAG 2. Opacity is ignored.
float luminance(scenes::Color color);
/// How well two colours stand out from each other, 1 to 21; text needs 4.5. The contrast ratio of WCAG 2.
float contrast(scenes::Color a, scenes::Color b);

/// Sets colours, roundings and distances of Dear ImGui's current context.
/// @param ui_scale Window::ui_scale()
void apply_to_imgui(ThemeKind kind, float ui_scale);

} // namespace carom::gallery
