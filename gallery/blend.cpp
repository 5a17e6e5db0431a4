// Moves each thing of a picture back towards where it was a step ago.
#include "gallery/blend.hpp"

#include <cmath>

namespace carom::gallery
{

namespace
{

using scenes::DrawnLine;
using scenes::DrawnShape;
using scenes::DrawnText;
using scenes::Layer;

bool is_near(Vec2 a, Vec2 b, float jump) { return std::abs(a.x - b.x) <= jump && std::abs(a.y - b.y) <= jump; }

void move_back(const DrawnShape& before, DrawnShape& shape, float t, float jump)
{
    if (before.geometry.index() != shape.geometry.index() || !is_near(before.transform.p, shape.transform.p, jump)) return;
    shape.transform = between(before.transform, shape.transform, t);
}

void move_back(const DrawnLine& before, DrawnLine& line, float t, float jump)
{
    if (!is_near(before.from, line.from, jump) || !is_near(before.to, line.to, jump)) return;
    line.from = lerp(before.from, line.from, t);
    line.to = lerp(before.to, line.to, t);
}

void move_back(const DrawnText& before, DrawnText& text, float t, float jump)
{
    if (before.place != text.place || !is_near(before.position, text.position, jump)) return;
    text.position = lerp(before.position, text.position, t);
}

template <class Thing>
void move_back(const std::vector<Thing>& before, std::vector<Thing>& things, float t, float jump)
{
    if (before.size() != things.size()) return;
    for (std::size_t i = 0; i < things.size(); ++i) move_back(before[i], things[i], t, jump);
}

} // namespace

Transform between(const Transform& a, const Transform& b, float t)
{
    const float c = a.q.c + (b.q.c - a.q.c) * t;
    const float s = a.q.s + (b.q.s - a.q.s) * t;
    const float size = std::sqrt(c * c + s * s);
    // Opposite directions have none between them.
    return {lerp(a.p, b.p, t), size > 0.1f ? Rot{c / size, s / size} : b.q};
}

void blend(const scenes::DrawList& before, const scenes::DrawList& after, float t, float jump, scenes::DrawList& blended)
{
    blended = after;
    if (t >= 1) return;
    for (int i = 0; i < scenes::layer_count; ++i)
    {
        const auto layer = static_cast<Layer>(i);
        scenes::DrawnLayer& things = blended.layer(layer);
        move_back(before.layer(layer).shapes, things.shapes, t, jump);
        move_back(before.layer(layer).lines, things.lines, t, jump);
        move_back(before.layer(layer).texts, things.texts, t, jump);
    }
}

} // namespace carom::gallery
