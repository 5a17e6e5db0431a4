// What the graphics card gets of a shape or a line: its corners in pixels from the middle of the picture.
#pragma once

#include "gallery/theme.hpp"
#include "scenes/camera.hpp"
#include "scenes/draw_list.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace carom::gallery
{

/// Widths of lines and sizes of texts in a draw list are in 1/720 of the picture's height.
inline constexpr float reference_height = 720;

/// The points within `radius` of a convex polygon of 1 to 8 corners, filled and bordered; the layout is that of the shader's attributes.
/// A disc has 1 corner, a capsule 2; lines have 2 and no radius. `power` is, of a disc, the power of the picture's middle,
/// |corner|^2 - radius^2 [pixels^2], and of a line 1 when its ends are flat and 0 when they are round.
struct ShapeInstance
{
    std::array<Vec2, 8> corners = {}; ///< from the middle of the picture, y up, counter-clockwise [pixels]
    float radius = 0;                 ///< [pixels]
    float half_line = 0;              ///< half of the border's width; 0 for none [pixels]
    float count = 0;                  ///< of corners
    float power = 0;                  ///< see above
    std::uint32_t fill = 0;           ///< red, green, blue, opacity, a byte each from the lowest
    std::uint32_t line = 0;
};
static_assert(sizeof(ShapeInstance) == 88);

/// Takes shapes of the world to the picture, and leaves out what it does not show.
class InstanceMaker
{
public:
    /// @param camera height finite and > 0
    InstanceMaker(const scenes::Camera& camera, scenes::Viewport viewport, const Theme& theme);

    /// Adds the layer's shapes and then its lines, in their order.
    void add(const scenes::DrawnLayer& layer, std::vector<ShapeInstance>& instances);

private:
    /// @return whether the picture shows something of it
    bool place(const scenes::DrawnShape& shape, ShapeInstance& instance);
    bool place(const scenes::DrawnLine& line, ShapeInstance& instance);
    Vec2 to_picture(Vec2 world) const;
    void set_corners(const Geometry& geometry, const Transform& transform, ShapeInstance& instance) const;
    bool is_visible(const ShapeInstance& instance) const;
    bool clip(ShapeInstance& instance) const;
    std::uint32_t packed(scenes::Color color);

    Vec2 center_;         ///< of the picture [m]
    float scale_;         ///< [pixels/m]
    Vec2 half_picture_;   ///< [pixels]
    float half_per_unit_; ///< half a line's width of 1/720 of the picture's height [pixels]
    const Theme& theme_;
    scenes::Color last_color_ = {}; ///< neighbours in a list often share their colour
    std::uint32_t last_packed_ = 0;
};

} // namespace carom::gallery
