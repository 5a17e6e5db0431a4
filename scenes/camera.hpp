// Which part of the world a front end shows, and the way between the world's metres and the screen's pixels.
#pragma once

#include <carom/math.hpp>

namespace carom::scenes
{

/// The width follows from the front end's picture.
struct Camera
{
    Vec2 center = {};  ///< what the middle of the picture shows [m]
    float height = 20; ///< of the part of the world that is visible [m]
    float width = 0;   ///< that a narrow picture must show; 0 for 16/9 of the height [m]
};

/// A picture on a screen or in a file.
struct Viewport
{
    int width = 1280; ///< [pixels]
    int height = 720; ///< [pixels]
};

inline float pixels_per_metre(const Camera& camera, Viewport view) { return static_cast<float>(view.height) / camera.height; }

/// @return pixels from the left and from the top
inline Vec2 to_pixels(const Camera& camera, Viewport view, Vec2 world)
{
    const float scale = pixels_per_metre(camera, view);
    return {0.5f * static_cast<float>(view.width) + scale * (world.x - camera.center.x),
            0.5f * static_cast<float>(view.height) - scale * (world.y - camera.center.y)};
}

/// @param pixels from the left and from the top
inline Vec2 to_world(const Camera& camera, Viewport view, Vec2 pixels)
{
    const float scale = pixels_per_metre(camera, view);
    return {camera.center.x + (pixels.x - 0.5f * static_cast<float>(view.width)) / scale,
            camera.center.y - (pixels.y - 0.5f * static_cast<float>(view.height)) / scale};
}

} // namespace carom::scenes
