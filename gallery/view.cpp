// Fits the scene into the part of the window that panels leave free.
#include "gallery/view.hpp"

#include <algorithm>
#include <cmath>

namespace carom::gallery
{

namespace
{

/// Scenes are composed for pictures of this shape.
constexpr float aspect = 16.0f / 9;

} // namespace

void View::set_layout(scenes::Viewport window, const Rect& free)
{
    window_ = {std::max(window.width, 1), std::max(window.height, 1)};
    // Whatever the panels leave, a point of the window is there to look at.
    free_.min = {std::clamp(free.min.x, 0.0f, static_cast<float>(window_.width - 1)),
                 std::clamp(free.min.y, 0.0f, static_cast<float>(window_.height - 1))};
    free_.max = {std::clamp(free.max.x, free_.min.x + 1, static_cast<float>(window_.width)),
                 std::clamp(free.max.y, free_.min.y + 1, static_cast<float>(window_.height))};
}

void View::follow(std::optional<Vec2> center)
{
    // When the following begins the body comes to the middle; when it ends the picture stays where it is.
    if (center && !followed_) pan_ = {};
    if (!center && followed_) pan_ = pan_ + *followed_ - base_.center;
    followed_ = center;
}

float View::points_per_metre() const
{
    const Vec2 size = free_.size();
    const float width = base_.width > 0 ? base_.width : aspect * base_.height;
    return zoom_ * std::min(size.y / base_.height, size.x / width);
}

scenes::Camera View::camera() const
{
    const float scale = points_per_metre();
    const Vec2 free_middle = 0.5f * (free_.min + free_.max);
    const Vec2 window_middle = {0.5f * static_cast<float>(window_.width), 0.5f * static_cast<float>(window_.height)};
    const Vec2 aside = free_middle - window_middle;
    return {middle() + Vec2{-aside.x, aside.y} * (1 / scale), static_cast<float>(window_.height) / scale};
}

void View::pan(Vec2 points) { pan_ += Vec2{-points.x, points.y} * (1 / points_per_metre()); }

void View::zoom_at(Vec2 points, float factor)
{
    if (!std::isfinite(factor) || factor <= 0) return;
    const Vec2 before = to_world(points);
    zoom_ = std::clamp(zoom_ * factor, least_zoom, most_zoom);
    pan_ += before - to_world(points);
}

void View::reset()
{
    followed_.reset();
    pan_ = {};
    zoom_ = 1;
}

} // namespace carom::gallery
