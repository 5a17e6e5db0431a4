// Small widgets that several panels share.
#include "gallery/widgets.hpp"

#include <cfloat>
#include <cstdio>

namespace carom::gallery
{

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
