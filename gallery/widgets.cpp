// Small widgets that several panels share.
#include "gallery/widgets.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace carom::gallery
{

namespace
{

double as_double(ImGuiDataType type, const void* value)
{
    switch (type)
    {
    case ImGuiDataType_S32: return *static_cast<const int*>(value);
    case ImGuiDataType_S64: return static_cast<double>(*static_cast<const std::int64_t*>(value));
    case ImGuiDataType_Float: return static_cast<double>(*static_cast<const float*>(value));
    default: return *static_cast<const double*>(value);
    }
}

/// How far to the right a slider shows a value, 0 to 1.
float fraction(double value, double min, double max, bool is_logarithmic)
{
    if (!(max > min)) return 0;
    const double t = is_logarithmic && min > 0 && value > 0 ? std::log(value / min) / std::log(max / min) : (value - min) / (max - min);
    return static_cast<float>(std::clamp(t, 0.0, 1.0));
}

/// A line along the lower edge of a slider's field, and a knob on it.
/// @param corner upper left one of the field [points]
void mark_value(ImVec2 corner, float width, float share)
{
    const ImGuiStyle& style = ImGui::GetStyle();
    const float unit = style.FramePadding.y; // the room below the letters
    const float bottom = corner.y + ImGui::GetFrameHeight() - 0.25f * unit;
    const float left = corner.x + 2 * unit;
    const float right = corner.x + width - 2 * unit;
    const float at = left + share * (right - left);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 accent = ImGui::GetColorU32(ImGui::IsItemActive() ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab);
    list.AddRectFilled({left, bottom - 0.5f * unit}, {right, bottom}, ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.4f));
    list.AddRectFilled({left, bottom - 0.5f * unit}, {at, bottom}, accent);
    list.AddRectFilled({at - 1.25f * unit, bottom - 0.9f * unit}, {at + 1.25f * unit, bottom + 0.15f * unit}, accent, 0.4f * unit);
}

} // namespace

bool checkbox(Gallery& gallery, const char* label, bool& value, const char* tip)
{
    const bool is_changed = ImGui::Checkbox(label, &value);
    gallery.widgets.note(label);
    if (tip) tip_of_last(tip);
    return is_changed;
}

bool button(Gallery& gallery, const char* label, const char* tip)
{
    const bool is_pressed = ImGui::Button(label);
    gallery.widgets.note(label);
    if (tip) tip_of_last(tip);
    return is_pressed;
}

bool slider(const char* label, ImGuiDataType type, void* value, const void* min, const void* max, const char* format,
            ImGuiSliderFlags flags)
{
    const float width = ImGui::CalcItemWidth();
    // Dear ImGui's own grab lies under the number.
    ImGui::PushStyleColor(ImGuiCol_SliderGrab, ImVec4(0, 0, 0, 0));
    ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, ImVec4(0, 0, 0, 0));
    const bool is_changed = ImGui::SliderScalar(label, type, value, min, max, format, flags | ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopStyleColor(2);
    const ImVec2 corner = ImGui::GetItemRectMin();
    const bool is_logarithmic = (flags & ImGuiSliderFlags_Logarithmic) != 0;
    mark_value(corner, width, fraction(as_double(type, value), as_double(type, min), as_double(type, max), is_logarithmic));
    return is_changed;
}

bool slider(const char* label, float& value, float min, float max, const char* format, ImGuiSliderFlags flags)
{
    return slider(label, ImGuiDataType_Float, &value, &min, &max, format, flags);
}

bool slider(const char* label, int& value, int min, int max, const char* format)
{
    return slider(label, ImGuiDataType_S32, &value, &min, &max, format, 0);
}

ImVec4 warning_color(ThemeKind theme) { return theme == ThemeKind::Light ? ImVec4(0.72f, 0.13f, 0.10f, 1) : ImVec4(1, 0.55f, 0.45f, 1); }

void flow(float width)
{
    const float end = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width;
    if (end <= ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) ImGui::SameLine();
}

void flow(const char* label) { flow(ImGui::CalcTextSize(label, nullptr, true).x + 2 * ImGui::GetStyle().FramePadding.x); }

void tip_of_last(const std::string& words)
{
    if (!ImGui::IsItemHovered() || words.empty()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool is_meant(bool is_changed)
{
    const bool is_typing = ImGui::IsItemActive() && ImGui::GetIO().WantTextInput;
    return is_changed && !is_typing;
}

void plot(const char* id, const History& history, float height)
{
    const auto value_at = [](void* data, int i) { return (*static_cast<const History*>(data))[static_cast<std::size_t>(i)]; };
    const float most = history.largest();
    ImGui::PushItemWidth(-FLT_MIN);
    ImGui::PlotLines(id, value_at, const_cast<History*>(&history), static_cast<int>(history.size()), 0, nullptr, 0,
                     most > 0 ? 1.1f * most : 1, {0, height});
    ImGui::PopItemWidth();
}

void cell(const std::string& text)
{
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

void right_cell(const std::string& text)
{
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    if (room > 0) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room);
    ImGui::TextUnformatted(text.c_str());
}

void number_cell(const char* format, double value)
{
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    right_cell(text);
}

std::string bytes_text(double bytes)
{
    char text[32];
    if (bytes < 1e3)
        std::snprintf(text, sizeof text, "%.0f B", bytes);
    else if (bytes < 1e6)
        std::snprintf(text, sizeof text, "%.1f kB", bytes / 1e3);
    else
        std::snprintf(text, sizeof text, "%.2f MB", bytes / 1e6);
    return text;
}

void heading(const char* text)
{
    ImGui::Dummy({0, 0.25f * ImGui::GetFontSize()});
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    ImGui::TextUnformatted(text);
    ImGui::PopStyleColor();
    ImGui::Separator();
}

void muted(const std::string& text)
{
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

} // namespace carom::gallery
