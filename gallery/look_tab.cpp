// What is drawn and how: overlays, colours, the camera, and what Shift and the left button make.
#include "gallery/keys.hpp"
#include "gallery/overlay_names.hpp"
#include "gallery/panels.hpp"
#include "gallery/widgets.hpp"

#include <array>

namespace carom::gallery
{

namespace
{

/// One of the scene's own parameters, as a checkbox.
void parameter_checkbox(Gallery& gallery, const char* label, const std::string& parameter, const char* tip)
{
    bool value = gallery.session.scene().parameters().boolean(parameter);
    if (checkbox(gallery, label, value, tip)) gallery.session.set_parameter(parameter, value);
}

void overlay_boxes(Gallery& gallery)
{
    if (!ImGui::BeginTable("overlays", 2)) return;
    for (const OverlayName& overlay : overlays)
    {
        ImGui::TableNextColumn();
        checkbox(gallery, overlay.name, gallery.draw.*overlay.option, overlay.tip);
    }
    ImGui::TableNextColumn();
    parameter_checkbox(gallery, "bounds", "show_bounds", "bounds of shapes: tight, and as the broad phase sees them (B)");
    ImGui::TableNextColumn();
    checkbox(gallery, "status line", gallery.shows_status, "times, counts and the pointer's place, at the bottom of the window (F5)");
    ImGui::TableNextColumn();
    parameter_checkbox(gallery, "broad phase", "show_squares", "the squares of the quadtree, or the boxes of the tree (Q)");
    ImGui::EndTable();
}

void colors(Gallery& gallery)
{
    bool is_light = gallery.theme == ThemeKind::Light;
    if (checkbox(gallery, "light theme", is_light)) gallery.theme = is_light ? ThemeKind::Light : ThemeKind::Dark;
    bool is_safe = gallery.palette == Palette::ColorBlindSafe;
    if (checkbox(gallery, "colour-blind safe", is_safe,
                 "the scene's colours become those of Okabe and Ito, which nearly everybody can tell apart"))
        gallery.palette = is_safe ? Palette::ColorBlindSafe : Palette::Scene;
}

void camera(Gallery& gallery)
{
    if (button(gallery, "Reset camera", "Home")) press_key(gallery, SDLK_HOME, false, false);
    ImGui::SameLine();
    const bool is_following = static_cast<bool>(gallery.session.watched());
    if (button(gallery, is_following ? "Stop following##follow" : "Follow body##follow", "the body that the inspector shows (V)"))
        gallery.toggle_follow();
    ImGui::SameLine();
    ImGui::TextDisabled("zoom %.2g", static_cast<double>(gallery.view.zoom()));
}

void spawn(Gallery& gallery)
{
    SpawnOptions& spawn = gallery.hand.spawn;
    muted("Shift and the left button make a body; pull back to throw it.");
    constexpr std::array names = {"circle", "box", "capsule", "pentagon"};
    auto kind = static_cast<int>(spawn.kind);
    ImGui::PushItemWidth(9 * ImGui::GetFontSize());
    if (ImGui::Combo("kind", &kind, names.data(), static_cast<int>(names.size()))) spawn.kind = static_cast<SpawnOptions::Kind>(kind);
    gallery.widgets.note("spawn kind");
    slider("size", spawn.size, 0.05f, 20, "%.2f m", ImGuiSliderFlags_Logarithmic);
    gallery.widgets.note("spawn size");
    slider("density", spawn.density, 0.01f, 100, "%.2f kg/m2", ImGuiSliderFlags_Logarithmic);
    slider("friction", spawn.friction, 0, 2, "%.2f");
    slider("restitution", spawn.restitution, 0, 1, "%.2f");
    ImGui::PopItemWidth();
}

} // namespace

void look_tab(Gallery& gallery)
{
    heading("Draw");
    overlay_boxes(gallery);
    heading("Colours");
    colors(gallery);
    heading("Camera");
    camera(gallery);
    heading("New bodies");
    spawn(gallery);
}

} // namespace carom::gallery
