// The line below everything: what frames and steps take, what the scene holds, and where the pointer is.
#include "gallery/panels.hpp"
#include "gallery/widgets.hpp"

#include <cstdio>

namespace carom::gallery
{

namespace
{

template <class... Values>
std::string words(const char* format, Values... values)
{
    char text[64];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

/// "1 contact", "2 contacts".
std::string count_words(int count, const char* one, const char* many) { return words("%d %s", count, count == 1 ? one : many); }

std::string place_words(const std::optional<Vec2>& place)
{
    if (!place) return "pointer not over the scene";
    return words("x %.2f m, y %.2f m", static_cast<double>(place->x), static_cast<double>(place->y));
}

} // namespace

std::array<StatusFigure, 5> status_figures(const Gallery& gallery)
{
    const double frame = gallery.frames.recent().whole;
    const StageMeter& meter = gallery.session.meter();
    return {{{words("frame %.1f ms", frame), "from frame to frame, mean of the last ones"},
             {words("step %.3f ms", meter.now().step_ms), "mean of the last steps"},
             {count_words(gallery.session.scene().world().body_count(), "body", "bodies"), "that the world holds"},
             {count_words(meter.latest().contacts, "contact", "contacts"), "pairs of shapes that touch, in the last step"},
             {place_words(gallery.pointer_place), "where the pointer is in the scene"}}};
}

void status_line(Gallery& gallery)
{
    constexpr float column = 9.5f; // width of a figure [letters' height]
    float at = ImGui::GetStyle().WindowPadding.x;
    for (const StatusFigure& figure : status_figures(gallery))
    {
        ImGui::SameLine(at);
        ImGui::TextDisabled("%s", figure.text.c_str());
        tip_of_last(figure.tip);
        at += column * ImGui::GetFontSize();
    }
}

} // namespace carom::gallery
