// Lays the panels out around the scene.
#include "gallery/panels.hpp"

#include "gallery/keys.hpp"
#include "gallery/tab_names.hpp"
#include "gallery/widgets.hpp"

#include <algorithm>
#include <array>

namespace carom::gallery
{

namespace
{

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings;

bool begin_panel(const char* name, const Rect& place)
{
    ImGui::SetNextWindowPos({place.min.x, place.min.y});
    ImGui::SetNextWindowSize({std::max(place.size().x, 1.0f), std::max(place.size().y, 1.0f)});
    return ImGui::Begin(name, nullptr, fixed);
}

void scene_panel(Gallery& gallery, const Rect& place)
{
    if (begin_panel("Scenes", place))
    {
        scene_list(gallery, 0.36f * place.size().y);
        ImGui::BeginChild("story");
        scene_story(gallery);
        parameter_list(gallery);
        heading("Controls");
        scene_controls(gallery);
        ImGui::EndChild();
    }
    ImGui::End();
}

void tab(Gallery& gallery, const char* name, void (*content)(Gallery&))
{
    const bool is_wanted = gallery.wanted_tab == name;
    const bool is_open = ImGui::BeginTabItem(name, nullptr, is_wanted ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
    if (is_wanted) gallery.wanted_tab.clear();
    gallery.widgets.note(std::string("tab ") + name);
    if (!is_open) return;
    ImGui::BeginChild(name);
    content(gallery);
    ImGui::EndChild();
    ImGui::EndTabItem();
}

void side_panel(Gallery& gallery, const Rect& place)
{
    if (begin_panel("Side", place) && ImGui::BeginTabBar("tabs"))
    {
        constexpr std::array contents = {look_tab, measure_tab, broad_phase_tab, memory_tab, body_tab};
        static_assert(contents.size() == tab_names.size());
        for (std::size_t i = 0; i < contents.size(); ++i) tab(gallery, tab_names[i], contents[i]);
        ImGui::EndTabBar();
    }
    ImGui::End();
}

void bottom_panel(Gallery& gallery, const Rect& place)
{
    if (begin_panel("Time", place)) time_bar(gallery);
    gallery.bar_height = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y + ImGui::GetStyle().WindowPadding.y;
    ImGui::End();
}

/// The window that is being laid out lies over the scene.
void note_floating(Gallery& gallery)
{
    const ImVec2 place = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    gallery.floating.push_back({{place.x, place.y}, {place.x + size.x, place.y + size.y}});
}

/// Over the scene, at the bottom of the free part.
void inside_window(Gallery& gallery, const Rect& free)
{
    const float margin = 0.6f * ImGui::GetFontSize();
    ImGui::SetNextWindowPos({free.min.x + margin, free.max.y - margin}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({std::max(free.size().x - 2 * margin, 60.0f), 0});
    ImGui::Begin("Inside a step", nullptr, fixed);
    inside_panel(gallery);
    note_floating(gallery);
    ImGui::End();
}

void message_window(Gallery& gallery, const Rect& free)
{
    const float margin = 0.6f * ImGui::GetFontSize();
    ImGui::SetNextWindowPos({0.5f * (free.min.x + free.max.x), free.min.y + margin}, ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize({std::min(32 * ImGui::GetFontSize(), std::max(free.size().x, 60.0f)), 0});
    ImGui::Begin("Message", nullptr, fixed | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::TextWrapped("%s", gallery.session.message().c_str());
    if (button(gallery, "Close")) gallery.session.say({});
    note_floating(gallery);
    ImGui::End();
}

void help_window(Gallery& gallery, scenes::Viewport window)
{
    const auto width = static_cast<float>(window.width);
    const auto height = static_cast<float>(window.height);
    ImGui::SetNextWindowPos({0.5f * width, 0.5f * height}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(width, 46 * ImGui::GetFontSize()), std::min(height, 56 * ImGui::GetFontSize())});
    ImGui::SetNextWindowFocus();
    if (ImGui::Begin("Help", &gallery.shows_help, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse))
        help_text(gallery);
    note_floating(gallery);
    ImGui::End();
}

} // namespace

void help_text(const Gallery& gallery)
{
    const auto begin = [](const char* name)
    {
        if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingStretchProp)) return false;
        ImGui::TableSetupColumn("input", ImGuiTableColumnFlags_WidthFixed, 12 * ImGui::GetFontSize());
        ImGui::TableSetupColumn("what", ImGuiTableColumnFlags_WidthStretch);
        return true;
    };
    const auto row = [](const char* input, const char* what)
    {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", input);
        cell(what);
    };
    heading("Pointer");
    if (begin("pointer"))
    {
        for (const PointerHelp& help : pointer_help()) row(help.input, help.what);
        ImGui::EndTable();
    }
    heading("Keys");
    if (begin("keys"))
    {
        for (const KeyAction& action : key_actions()) row(action.label, action.what);
        row("Esc", "close this help, let the picked body go, and leave a step that is looked into");
        row("arrows", "while you look inside a step: back and forth");
        ImGui::EndTable();
    }
    heading(gallery.session.scene().info().title.c_str());
    scene_controls(gallery);
}

Rect draw_panels(Gallery& gallery, scenes::Viewport window, float scale)
{
    const Vec2 size = {static_cast<float>(window.width), static_cast<float>(window.height)};
    Rect free = {{0, 0}, size};
    gallery.floating.clear();
    if (gallery.shows_panels)
    {
        const float left = std::min(270 * scale, 0.3f * size.x);
        const float right = std::min(380 * scale, 0.36f * size.x);
        const float bottom = std::min(gallery.bar_height > 0 ? gallery.bar_height : 72 * scale, 0.5f * size.y);
        free = {{left, 0}, {size.x - right, size.y - bottom}};
        scene_panel(gallery, {{0, 0}, {left, size.y}});
        side_panel(gallery, {{size.x - right, 0}, size});
        bottom_panel(gallery, {{left, size.y - bottom}, {size.x - right, size.y}});
    }
    if (gallery.session.is_inside()) inside_window(gallery, free);
    if (!gallery.session.message().empty()) message_window(gallery, free);
    if (gallery.shows_help) help_window(gallery, window);
    gallery.widgets.note("scene", free);
    return free;
}

} // namespace carom::gallery
