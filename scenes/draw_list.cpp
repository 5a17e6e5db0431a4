// Gathers what a front end is to draw.
#include "scenes/draw_list.hpp"

#include <utility>

namespace carom::scenes
{

namespace
{

Circle scaled_shape(Circle c, float factor)
{
    c.radius *= factor;
    return c;
}

Capsule scaled_shape(const Capsule& c, float factor)
{
    const Vec2 middle = 0.5f * (c.p1 + c.p2);
    return {lerp(middle, c.p1, factor), lerp(middle, c.p2, factor), factor * c.radius};
}

Segment scaled_shape(const Segment& s, float factor)
{
    const Vec2 middle = 0.5f * (s.p1 + s.p2);
    return {lerp(middle, s.p1, factor), lerp(middle, s.p2, factor)};
}

Polygon scaled_shape(Polygon p, float factor)
{
    for (Vec2& v : p.vertices) v = lerp(p.centroid, v, factor);
    p.radius *= factor;
    return p;
}

} // namespace

Geometry scaled(const Geometry& geometry, float factor)
{
    return std::visit([&](const auto& shape) { return Geometry(scaled_shape(shape, factor)); }, geometry);
}

void DrawList::shape(Layer layer, const Geometry& geometry, const Transform& transform, const Paint& paint)
{
    this->layer(layer).shapes.emplace_back(geometry, transform, paint); // made in place: a shape is 200 bytes
}

void DrawList::disc(Layer layer, Vec2 center, float radius, const Paint& paint)
{
    shape(layer, Circle{.center = {}, .radius = radius}, {.p = center, .q = {}}, paint);
}

void DrawList::box(Layer layer, const Aabb& box, const Paint& paint)
{
    // Not by carom::box(), which refuses boxes that are too thin for the solver: what is drawn may be any size.
    Polygon p;
    p.vertices = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    p.normals = {Vec2{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    p.centroid = box.center();
    p.count = 4;
    shape(layer, p, {}, paint);
}

void DrawList::line(Layer layer, Vec2 from, Vec2 to, Color color, float width)
{
    this->layer(layer).lines.push_back({from, to, color, width});
}

void DrawList::text(DrawnText text) { layer(Layer::Captions).texts.push_back(std::move(text)); }

void DrawList::clear()
{
    for (DrawnLayer& layer : layers_)
    {
        layer.shapes.clear();
        layer.lines.clear();
        layer.texts.clear();
    }
    background = night;
}

} // namespace carom::scenes
