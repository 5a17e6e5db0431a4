// Moves each thing of a picture back towards where it was a step ago.
#include "gallery/blend.hpp"

#include <algorithm>
#include <cmath>

namespace carom::gallery
{

namespace
{

using scenes::DrawnLine;
using scenes::DrawnShape;
using scenes::DrawnText;

bool is_near(Vec2 a, Vec2 b, float jump) { return std::abs(a.x - b.x) <= jump && std::abs(a.y - b.y) <= jump; }

Places::ShapePlace place_of(const DrawnShape& shape) { return {shape.transform, shape.geometry.index()}; }
Places::LinePlace place_of(const DrawnLine& line) { return {line.from, line.to}; }
Places::TextPlace place_of(const DrawnText& text) { return {text.position, text.place}; }

template <class Thing, class Place>
void note(const std::vector<Thing>& things, std::vector<Place>& places)
{
    places.resize(things.size());
    std::transform(things.begin(), things.end(), places.begin(), [](const Thing& thing) { return place_of(thing); });
}

void move_back(const Places::ShapePlace& before, DrawnShape& shape, float t, float jump)
{
    if (before.kind != shape.geometry.index() || !is_near(before.transform.p, shape.transform.p, jump)) return;
    shape.transform = between(before.transform, shape.transform, t);
}

void move_back(const Places::LinePlace& before, DrawnLine& line, float t, float jump)
{
    if (!is_near(before.from, line.from, jump) || !is_near(before.to, line.to, jump)) return;
    line.from = lerp(before.from, line.from, t);
    line.to = lerp(before.to, line.to, t);
}

void move_back(const Places::TextPlace& before, DrawnText& text, float t, float jump)
{
    if (before.place != text.place || !is_near(before.position, text.position, jump)) return;
    text.position = lerp(before.position, text.position, t);
}

template <class Place, class Thing>
void move_back(const std::vector<Place>& before, std::vector<Thing>& things, float t, float jump)
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

void Places::note(const scenes::DrawList& list)
{
    for (std::size_t i = 0; i < layers_.size(); ++i)
    {
        const scenes::DrawnLayer& things = list.layers()[i];
        gallery::note(things.shapes, layers_[i].shapes);
        gallery::note(things.lines, layers_[i].lines);
        gallery::note(things.texts, layers_[i].texts);
    }
}

void blend(const Places& before, float t, float jump, scenes::DrawList& list)
{
    if (t >= 1) return;
    for (std::size_t i = 0; i < scenes::layer_count; ++i)
    {
        scenes::DrawnLayer& things = list.layer(static_cast<scenes::Layer>(i));
        move_back(before.layer(i).shapes, things.shapes, t, jump);
        move_back(before.layer(i).lines, things.lines, t, jump);
        move_back(before.layer(i).texts, things.texts, t, jump);
    }
}

} // namespace carom::gallery
