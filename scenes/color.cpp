// Colours from their place on the colour circle.
#include "scenes/color.hpp"

#include <algorithm>
#include <cmath>

namespace carom::scenes
{

namespace
{

/// One channel of a hue: a wave with flat top and bottom over the colour circle.
float channel(float hue)
{
    const float sector = 6 * (hue - std::floor(hue));
    return std::clamp(std::abs(sector - 3) - 1, 0.0f, 1.0f);
}

} // namespace

Color from_hue(float hue, float saturation, float lightness)
{
    const float chroma = (1 - std::abs(2 * lightness - 1)) * saturation;
    const auto level = [&](float h) { return lightness + chroma * (channel(h) - 0.5f); };
    return rgb(level(hue), level(hue - 1.0f / 3), level(hue + 1.0f / 3));
}

} // namespace carom::scenes
