// Which part of the scene the window shows: the scene's own camera, and how the person moved away from it.
#pragma once

#include "scenes/camera.hpp"

#include <carom/math.hpp>

#include <optional>

namespace carom::gallery
{

/// A rectangle of the window, in points from its top left corner.
struct Rect
{
    Vec2 min;
    Vec2 max;

    Vec2 size() const { return max - min; }
    bool contains(Vec2 p) const { return p.x >= min.x && p.y >= min.y && p.x < max.x && p.y < max.y; }
};

class View
{
public:
    static constexpr float least_zoom = 1e-3f;
    static constexpr float most_zoom = 1e4f;

    /// @param window of the program [points]
    /// @param free   the part that no panel covers; the scene is fitted into it
    void set_layout(scenes::Viewport window, const Rect& free);
    /// Where the scene's own camera looks now, in every frame.
    void set_base(const scenes::Camera& base) { base_ = base; }
    /// A place that stays in the middle, instead of the base's; none ends that.
    void follow(std::optional<Vec2> center);
    bool is_following() const { return followed_.has_value(); }

    /// As if the window showed the scene by itself: for a renderer that knows the whole window's size.
    scenes::Camera camera() const;
    Vec2 to_world(Vec2 points) const { return scenes::to_world(camera(), window_, points); }
    Vec2 to_points(Vec2 world) const { return scenes::to_pixels(camera(), window_, world); }
    float points_per_metre() const;
    float window_aspect() const { return static_cast<float>(window_.width) / static_cast<float>(window_.height); } ///< width over height

    /// The picture moves with the pointer.
    void pan(Vec2 points);
    /// What is under the pointer stays there.
    /// @param factor > 1 comes nearer
    void zoom_at(Vec2 points, float factor);
    void reset();

    const Rect& free() const { return free_; }
    float zoom() const { return zoom_; }

private:
    Vec2 middle() const { return pan_ + (followed_ ? *followed_ : base_.center); }

    scenes::Viewport window_;
    Rect free_ = {{0, 0}, {1280, 720}};
    scenes::Camera base_;
    std::optional<Vec2> followed_;
    Vec2 pan_ = {}; ///< [m]
    float zoom_ = 1;
};

} // namespace carom::gallery
