// Lays the panels out around the scene.
#include "gallery/panels.hpp"

#include "gallery/keys.hpp"
#include "gallery/tab_names.hpp"
#include "gallery/widgets.hpp"

#include <algorithm>
#include <array>
#include <imgui_stdlib.h>

namespace carom::gallery
{

namespace
{

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings;

/// Its parts scroll, the panel does not.
bool begin_panel(const char* name, const Rect& place)
{
    ImGui::SetNextWindowPos({place.min.x, place.min.y});
    ImGui::SetNextWindowSize({std::max(place.size().x, 1.0f), std::max(place.size().y, 1.0f)});
    return ImGui::Begin(name, nullptr, fixed | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
}

/// What a panel's layout needs to know of the window.
struct Ground
{
    Vec2 window; ///< size [points]
    float scale; ///< how large letters are, 1 on a common screen
};

/// The edge between a panel and the scene: it can be dragged.
void edge(Gallery& gallery, PanelSide side, const Rect& place, const Ground& ground)
{
    const float width = 0.6f * ImGui::GetStyle().WindowPadding.x;
    const bool is_left = side == PanelSide::Left;
    const float left = is_left ? place.size().x - width : 0.0f;
    const ImVec2 cursor = ImGui::GetCursorPos();
    ImGui::SetCursorPos({left, 0});
    ImGui::InvisibleButton("edge", {width, std::max(place.size().y, 1.0f)});
    gallery.widgets.note(is_left ? "left edge" : "right edge");
    if (ImGui::IsItemHovered() || ImGui::IsItemActive())
    {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        const ImVec2 from = {place.min.x + left, place.min.y};
        const ImU32 color = ImGui::GetColorU32(ImGui::IsItemActive() ? ImGuiCol_SeparatorActive : ImGuiCol_SeparatorHovered);
        ImGui::GetWindowDrawList()->AddRectFilled(from, {from.x + width, place.max.y}, color);
    }
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1))
    {
        const float x = ImGui::GetIO().MousePos.x;
        gallery.layout.drag(side, is_left ? x - place.min.x : place.max.x - x, ground.window, ground.scale);
    }
    ImGui::SetCursorPos(cursor);
}

/// An arrow that folds a panel, or opens it; it points to where the panel's edge will go.
void fold_button(Gallery& gallery, PanelSide side, const Ground& ground)
{
    const bool is_left = side == PanelSide::Left;
    const bool is_folded = gallery.layout.is_folded(side, ground.window, ground.scale);
    if (ImGui::ArrowButton(is_left ? "fold left" : "fold right", is_left == is_folded ? ImGuiDir_Right : ImGuiDir_Left))
        gallery.layout.toggle(side, ground.window, ground.scale);
    gallery.widgets.note(is_left ? "fold left" : "fold right");
    tip_of_last(is_left ? "the list of scenes and the parameters (F2)" : "what is drawn, times, broad phase, memory, body (F3)");
}

/// A strip with the button that brings the panel back.
void folded_panel(Gallery& gallery, PanelSide side, const Rect& place, const Ground& ground)
{
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(1, ImGui::GetStyle().WindowPadding.y));
    if (begin_panel(side == PanelSide::Left ? "Scenes folded" : "Side folded", place)) fold_button(gallery, side, ground);
    ImGui::End();
    ImGui::PopStyleVar();
}

void scene_panel(Gallery& gallery, const Rect& place, const Ground& ground)
{
    if (begin_panel("Scenes", place))
    {
        edge(gallery, PanelSide::Left, place, ground);
        ImGui::PushItemWidth(-ImGui::GetFrameHeight() - ImGui::GetStyle().ItemSpacing.x);
        ImGui::InputTextWithHint("##search", "search scenes", &gallery.search);
        gallery.widgets.note("search");
        ImGui::PopItemWidth();
        ImGui::SameLine();
        fold_button(gallery, PanelSide::Left, ground);
        scene_list(gallery, 0.36f * place.size().y);
        if (button(gallery, "Open file...", "a scene file (Ctrl O); it can also be dropped on the window")) gallery.dialog.open();
        ImGui::BeginChild("story");
        scene_story(gallery);
        parameter_list(gallery);
        heading("Controls");
        scene_controls(gallery);
        ImGui::EndChild();
    }
    ImGui::End();
}

/// Narrow tabs, so that all of them have room. The bar and each tab take it when they begin.
void push_tab_padding()
{
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.7f * padding.x, padding.y));
}

void tab(Gallery& gallery, const char* name, void (*content)(Gallery&))
{
    const bool is_wanted = gallery.wanted_tab == name;
    push_tab_padding();
    const bool is_open = ImGui::BeginTabItem(name, nullptr, is_wanted ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
    ImGui::PopStyleVar();
    if (is_wanted) gallery.wanted_tab.clear();
    gallery.widgets.note(std::string("tab ") + name);
    if (!is_open) return;
    ImGui::BeginChild(name);
    content(gallery);
    ImGui::EndChild();
    ImGui::EndTabItem();
}

void side_panel(Gallery& gallery, const Rect& place, const Ground& ground)
{
    if (begin_panel("Side", place))
    {
        edge(gallery, PanelSide::Right, place, ground);
        fold_button(gallery, PanelSide::Right, ground);
        ImGui::SameLine();
        push_tab_padding();
        const bool has_tabs = ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyScroll);
        ImGui::PopStyleVar();
        if (has_tabs)
        {
            constexpr std::array contents = {look_tab, measure_tab, broad_phase_tab, memory_tab, body_tab};
            static_assert(contents.size() == tab_names.size());
            for (std::size_t i = 0; i < contents.size(); ++i) tab(gallery, tab_names[i], contents[i]);
            ImGui::EndTabBar();
        }
    }
    ImGui::End();
}

void bottom_panel(Gallery& gallery, const Rect& place)
{
    if (begin_panel("Time", place)) time_bar(gallery);
    gallery.layout.bar_height = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y + ImGui::GetStyle().WindowPadding.y;
    ImGui::End();
}

float status_height() { return ImGui::GetTextLineHeight() + 0.6f * ImGui::GetFontSize(); }

void status_panel(Gallery& gallery, const Rect& place)
{
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ImGui::GetStyle().WindowPadding.x, 0.3f * ImGui::GetFontSize()));
    if (begin_panel("Status", place)) status_line(gallery);
    gallery.widgets.note("status", place);
    ImGui::End();
    ImGui::PopStyleVar();
}

PanelLayout::Heights heights_below(const Gallery& gallery, float scale)
{
    PanelLayout::Heights heights;
    const bool has_bar = gallery.shows_panels && !gallery.layout.is_bar_folded;
    if (has_bar) heights.bar = gallery.layout.bar_height > 0 ? gallery.layout.bar_height : 72 * scale;
    if (gallery.shows_status) heights.status = status_height();
    return heights;
}

void side(Gallery& gallery, PanelSide which, const Rect& place, const Ground& ground)
{
    if (gallery.layout.is_folded(which, ground.window, ground.scale)) return folded_panel(gallery, which, place, ground);
    which == PanelSide::Left ? scene_panel(gallery, place, ground) : side_panel(gallery, place, ground);
}

/// The panels around the scene.
/// @return what they leave of the window
Rect panels_around(Gallery& gallery, const Ground& ground)
{
    const PanelLayout::Places places = gallery.layout.places(ground.window, ground.scale, heights_below(gallery, ground.scale));
    if (gallery.shows_status) status_panel(gallery, places.status);
    if (!gallery.shows_panels) return {{0, 0}, {ground.window.x, places.bar.max.y}};
    if (!gallery.layout.is_bar_folded) bottom_panel(gallery, places.bar);
    for (const PanelSide which : {PanelSide::Left, PanelSide::Right})
        side(gallery, which, places.sides[static_cast<std::size_t>(which)], ground);
    return places.scene;
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

void dialog_window(Gallery& gallery, scenes::Viewport window)
{
    const Vec2 size = {static_cast<float>(window.width), static_cast<float>(window.height)};
    ImGui::SetNextWindowPos({0.5f * size.x, 0.5f * size.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({std::min(size.x, 36 * ImGui::GetFontSize()), std::min(size.y, 32 * ImGui::GetFontSize())});
    bool stays = true;
    if (ImGui::Begin("Open a scene file", &stays, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse))
        file_dialog_content(gallery);
    note_floating(gallery);
    ImGui::End();
    if (!stays) gallery.dialog.close();
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
    const Ground ground = {{static_cast<float>(window.width), static_cast<float>(window.height)}, scale};
    gallery.window_size = ground.window;
    gallery.ui_scale = scale;
    gallery.floating.clear();
    const Rect free = panels_around(gallery, ground);
    if (gallery.session.is_inside()) inside_window(gallery, free);
    if (!gallery.session.message().empty()) message_window(gallery, free);
    if (gallery.dialog.is_open()) dialog_window(gallery, window);
    if (gallery.shows_help) help_window(gallery, window);
    gallery.widgets.note("scene", free);
    return free;
}

} // namespace carom::gallery
