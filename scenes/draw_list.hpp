// What a scene looks like, as plain data that any front end can draw: a window, an image file, a web page.
#pragma once

#include "scenes/color.hpp"

#include <carom/math.hpp>
#include <carom/shape.hpp>

#include <array>
#include <string>
#include <vector>

namespace carom::scenes
{

/// Drawn in this order, the later over the earlier.
enum class Layer
{
    Background, ///< behind everything: stars, the broad phase's squares
    Trails,     ///< where bodies have been
    Bodies,     ///< the bodies
    Marks,      ///< what is said about bodies: flashes, bounds
    Captions    ///< text
};
inline constexpr int layer_count = 5;

/// How a shape is filled and bordered; an invisible colour leaves that part out.
struct Paint
{
    Color fill = {};
    Color line = {};
    float line_width = 1.5f; ///< in 1/720 of the picture's height, so that it looks alike at every zoom and size
};

struct DrawnShape
{
    Geometry geometry;
    Transform transform; ///< from the shape's frame to the world
    Paint paint;
};

struct DrawnLine
{
    Vec2 from; ///< [m]
    Vec2 to;   ///< [m]
    Color color;
    float width = 1.5f; ///< in 1/720 of the picture's height
};

enum class Place
{
    World,     ///< centred at a point of the world
    TopLeft,   ///< lines below each other from this corner of the picture
    BottomLeft ///< lines above each other from this corner
};

struct DrawnText
{
    std::string text;
    Color color = paper;
    float size = 18; ///< height of the letters, in 1/720 of the picture's height
    Place place = Place::TopLeft;
    Vec2 position = {}; ///< for Place::World [m]
};

/// Within a layer the shapes come first, then the lines, then the texts, each in their order.
struct DrawnLayer
{
    std::vector<DrawnShape> shapes;
    std::vector<DrawnLine> lines;
    std::vector<DrawnText> texts;
};

class DrawList
{
public:
    void shape(Layer layer, const Geometry& geometry, const Transform& transform, const Paint& paint);
    void disc(Layer layer, Vec2 center, float radius, const Paint& paint);
    void box(Layer layer, const Aabb& box, const Paint& paint);
    void line(Layer layer, Vec2 from, Vec2 to, Color color, float width = 1.5f);
    void text(DrawnText text);

    /// Empties the list and keeps its memory for the next frame.
    void clear();

    Color background = night;
    const DrawnLayer& layer(Layer layer) const { return layers_[static_cast<std::size_t>(layer)]; }
    DrawnLayer& layer(Layer layer) { return layers_[static_cast<std::size_t>(layer)]; }
    const std::array<DrawnLayer, layer_count>& layers() const { return layers_; }

private:
    std::array<DrawnLayer, layer_count> layers_;
};

/// The same shape, smaller or larger about its middle.
Geometry scaled(const Geometry& geometry, float factor);

} // namespace carom::scenes
