// Notes and writes down where widgets lie.
#include "gallery/widget_map.hpp"

#include "files/output_file.hpp"
#include "gallery/failure.hpp"

#include <algorithm>
#include <imgui.h>
#include <nlohmann/json.hpp>

namespace carom::gallery
{

void WidgetMap::note(const std::string& name)
{
    if (!is_wanted() || !ImGui::IsItemVisible()) return;
    const ImVec2 min = ImGui::GetItemRectMin();
    const ImVec2 max = ImGui::GetItemRectMax();
    const ImVec2 clip_min = ImGui::GetWindowDrawList()->GetClipRectMin();
    const ImVec2 clip_max = ImGui::GetWindowDrawList()->GetClipRectMax();
    note(name, {{std::max(min.x, clip_min.x), std::max(min.y, clip_min.y)}, {std::min(max.x, clip_max.x), std::min(max.y, clip_max.y)}});
}

void WidgetMap::note(const std::string& name, const Rect& place)
{
    if (is_wanted()) places_[name] = place;
}

void WidgetMap::end_frame()
{
    if (!is_wanted()) return;
    nlohmann::json json = nlohmann::json::object();
    for (const auto& [name, place] : places_) json[name] = {place.min.x, place.min.y, place.max.x, place.max.y};
    std::string text = json.dump();
    if (text == written_) return;
    try
    {
        files::write_file("--widgets", file_, text + "\n", {.is_durable = false});
    }
    catch (const files::FileError& error)
    {
        throw Failure(error.what());
    }
    written_ = std::move(text);
}

} // namespace carom::gallery
