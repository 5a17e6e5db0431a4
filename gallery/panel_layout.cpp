// Shares the window's width among two panels and the scene.
#include "gallery/panel_layout.hpp"

#include <algorithm>

namespace carom::gallery
{

namespace
{

constexpr float strip = 26; // of a folded panel, at a scale of 1 [points]

constexpr PanelSide other(PanelSide side) { return side == PanelSide::Left ? PanelSide::Right : PanelSide::Left; }

} // namespace

bool PanelLayout::has_room_for_both(Vec2 window, float scale) const
{
    return scale * (panels_[0].least + panels_[1].least) <= (1 - scene_share()) * window.x;
}

bool PanelLayout::is_folded(PanelSide side, Vec2 window, float scale) const
{
    if (panel(side).is_folded) return true;
    const bool is_alone = panel(other(side)).is_folded || side == last_opened_;
    return !is_alone && !has_room_for_both(window, scale);
}

std::array<float, 2> PanelLayout::widths(Vec2 window, float scale) const
{
    std::array<float, 2> widths;
    float wish = 0;  // of the open panels beyond their least widths
    float least = 0; // of all that is beside the scene
    for (const PanelSide side : {PanelSide::Left, PanelSide::Right})
    {
        const bool is_open = !is_folded(side, window, scale);
        const Panel& p = panel(side);
        widths[static_cast<std::size_t>(side)] = scale * (is_open ? p.least : strip);
        least += widths[static_cast<std::size_t>(side)];
        if (is_open) wish += scale * std::max(p.width - p.least, 0.0f);
    }
    // In a window that is smaller than the panels, all of them shrink.
    const float most = (1 - scene_share()) * window.x;
    const float squeeze = least > most && least > 0 ? most / least : 1;
    const float share = wish > 0 ? std::clamp((most - least) / wish, 0.0f, 1.0f) : 0;
    for (const PanelSide side : {PanelSide::Left, PanelSide::Right})
    {
        float& width = widths[static_cast<std::size_t>(side)];
        width *= squeeze;
        const Panel& p = panel(side);
        if (!is_folded(side, window, scale)) width += share * scale * std::max(p.width - p.least, 0.0f);
    }
    return widths;
}

PanelLayout::Places PanelLayout::places(Vec2 window, float scale, const Heights& below) const
{
    const auto [left, right] = widths(window, scale);
    const float status_top = window.y - std::min(below.status, 0.2f * window.y);
    const float bar_top = status_top - std::min(below.bar, 0.5f * window.y);
    return {.sides = {Rect{{0, 0}, {left, bar_top}}, Rect{{window.x - right, 0}, {window.x, bar_top}}},
            .bar = {{0, bar_top}, {window.x, status_top}},
            .status = {{0, status_top}, window},
            .scene = {{left, 0}, {window.x - right, bar_top}}};
}

void PanelLayout::toggle(PanelSide side, Vec2 window, float scale)
{
    const bool opens = is_folded(side, window, scale);
    panel(side).is_folded = !opens;
    if (opens) last_opened_ = side;
}

void PanelLayout::drag(PanelSide side, float width, Vec2 window, float scale)
{
    was_dragged_ = true;
    const float beside = widths(window, scale)[static_cast<std::size_t>(other(side))];
    const float most = std::max((1 - scene_share()) * window.x - beside, 0.0f) / scale;
    Panel& p = panel(side);
    p.width = std::max(std::min(width / scale, most), p.least);
}

} // namespace carom::gallery
