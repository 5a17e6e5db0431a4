// Lines lie in the background, the bar over the bodies.
#include "gallery/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace carom::gallery
{

namespace
{

using scenes::Color;
using scenes::Layer;

constexpr float least_spacing = 44; // of lines [points]
constexpr float least_bar = 80;     // [points]
constexpr Color line_color = {0.55f, 0.65f, 0.85f, 0.13f};
constexpr Color axis_color = {0.55f, 0.65f, 0.85f, 0.38f};
constexpr Color bar_color = {0.92f, 0.94f, 0.97f, 0.95f};

/// Calls draw(place, is axis) for the multiples of a spacing between two places.
template <class Draw>
void for_each_line(float from, float to, float spacing, const Draw& draw)
{
    const double first = std::ceil(static_cast<double>(from) / static_cast<double>(spacing));
    const double last = std::floor(static_cast<double>(to) / static_cast<double>(spacing));
    constexpr double most = 4096; // far out, float can't tell the lines apart
    if (!(last - first < most)) return;
    for (double i = first; i <= last; ++i) draw(static_cast<float>(i * static_cast<double>(spacing)), i == 0);
}

void draw_bar(const View& view, scenes::DrawList& list)
{
    constexpr float margin = 18; // [points]
    constexpr float foot = 5;    // half height of its ends [points]
    const float scale = view.points_per_metre();
    const float metres = round_distance(least_bar / scale);
    const Vec2 corner = view.free().max;
    if (metres * scale + 2 * margin > view.free().size().x) return; // no room
    const auto place = [&](float right, float up) { return view.to_world({corner.x - margin - right, corner.y - margin - up}); };
    const float length = metres * scale;
    list.line(Layer::Marks, place(length, 0), place(0, 0), bar_color, 2);
    for (const float end : {0.0f, length}) list.line(Layer::Marks, place(end, -foot), place(end, foot), bar_color, 2);
    list.text({.text = distance_text(metres),
               .color = bar_color,
               .size = 15,
               .place = scenes::Place::World,
               .position = place(0.5f * length, 14)});
}

} // namespace

float round_distance(float least)
{
    const double power = std::pow(10.0, std::floor(std::log10(static_cast<double>(least))));
    constexpr double nearly = 1 - 1e-6; // 0.1 is not exact
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= nearly * static_cast<double>(least)) return static_cast<float>(factor * power);
    return static_cast<float>(10 * power);
}

std::string distance_text(float metres)
{
    std::array<char, 32> text;
    if (metres >= 1000)
        std::snprintf(text.data(), text.size(), "%g km", static_cast<double>(metres) / 1000);
    else if (metres >= 1)
        std::snprintf(text.data(), text.size(), "%g m", static_cast<double>(metres));
    else if (metres >= 0.01f)
        std::snprintf(text.data(), text.size(), "%g cm", std::round(100 * static_cast<double>(metres)));
    else
        std::snprintf(text.data(), text.size(), "%.3g mm", 1000 * static_cast<double>(metres));
    return text.data();
}

void draw_grid(const View& view, scenes::DrawList& list)
{
    const scenes::Camera camera = view.camera();
    const Vec2 half = 0.5f * camera.height * Vec2{view.window_aspect(), 1};
    const Vec2 min = camera.center - half;
    const Vec2 max = camera.center + half;
    const float spacing = round_distance(least_spacing / view.points_per_metre());
    const auto color = [](bool is_axis) { return is_axis ? axis_color : line_color; };
    for_each_line(min.x, max.x, spacing,
                  [&](float x, bool is_axis) { list.line(Layer::Background, {x, min.y}, {x, max.y}, color(is_axis), 1); });
    for_each_line(min.y, max.y, spacing,
                  [&](float y, bool is_axis) { list.line(Layer::Background, {min.x, y}, {max.x, y}, color(is_axis), 1); });
    draw_bar(view, list);
}

} // namespace carom::gallery
