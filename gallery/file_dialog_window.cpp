// The window in which a person chooses a scene file.
#include "gallery/panels.hpp"
#include "gallery/widgets.hpp"

#include <algorithm>
#include <imgui_stdlib.h>

namespace carom::gallery
{

namespace
{

/// Opens what was chosen; a file that holds no scene says why, and the dialog stays.
void choose(Gallery& gallery, const std::string& name)
{
    FileDialog& dialog = gallery.dialog;
    const std::optional<std::filesystem::path> file = dialog.choose(name);
    if (!file) return;
    try
    {
        gallery.session.open(SceneSource::of_file(*file));
        dialog.close();
    }
    catch (const std::exception& error)
    {
        dialog.error = error.what();
    }
}

/// A click on a folder enters it; a click on a file takes its name, two clicks open it.
void entry_list(Gallery& gallery)
{
    std::string chosen;
    const auto row = [&](const std::string& name, bool is_folder)
    {
        const std::string label = is_folder ? name + "/" : name;
        const bool is_clicked = ImGui::Selectable(label.c_str(), gallery.dialog.typed == name, ImGuiSelectableFlags_AllowDoubleClick);
        gallery.widgets.note("dialog " + name);
        if (!is_clicked) return;
        if (is_folder || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) chosen = name;
        gallery.dialog.typed = name;
    };
    row("..", true);
    for (const FileDialog::Entry& entry : gallery.dialog.entries()) row(entry.name, entry.is_folder);
    if (gallery.dialog.entries().empty()) muted("No folders and no .json files here.");
    if (!chosen.empty()) choose(gallery, chosen);
}

void path_field(Gallery& gallery)
{
    FileDialog& dialog = gallery.dialog;
    ImGui::PushItemWidth(-FLT_MIN);
    const bool is_entered =
        ImGui::InputTextWithHint("##path", "name or path of a scene file", &dialog.typed, ImGuiInputTextFlags_EnterReturnsTrue);
    gallery.widgets.note("dialog path");
    ImGui::PopItemWidth();
    const bool is_pressed = button(gallery, "Open");
    ImGui::SameLine();
    if (button(gallery, "Cancel", "Esc")) dialog.close();
    if (is_entered || is_pressed) choose(gallery, std::string(dialog.typed));
}

} // namespace

void file_dialog_content(Gallery& gallery)
{
    ImGui::TextDisabled("%s", gallery.dialog.folder().string().c_str());
    // Below the list: the field, the buttons, and the error with up to three lines.
    const float line = ImGui::GetFrameHeightWithSpacing();
    const float below = 2.2f * line + (gallery.dialog.error.empty() ? 0 : 3.5f * ImGui::GetTextLineHeight());
    ImGui::BeginChild("entries", {0, std::max(ImGui::GetContentRegionAvail().y - below, 3 * line)}, true);
    entry_list(gallery);
    ImGui::EndChild();
    path_field(gallery);
    if (gallery.dialog.error.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, warning_color(gallery.theme));
    ImGui::TextWrapped("%s", gallery.dialog.error.c_str());
    ImGui::PopStyleColor();
}

} // namespace carom::gallery
