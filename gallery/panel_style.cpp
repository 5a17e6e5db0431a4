// How panels look: calm surfaces, one accent, roundings of 4 to 6 pixels.
#include "gallery/theme.hpp"

#include <imgui.h>

namespace carom::gallery
{

namespace
{

using scenes::Color;
using scenes::mix;

/// The few colours from which all others follow.
struct Surfaces
{
    Color text;
    Color quiet_text;
    Color panel;
    Color raised; ///< menus and hints, above panels
    Color field;  ///< what values are typed into
    Color edge;
    Color accent;
    Color mark; ///< gives a field, a row or a button more weight, laid over it: white or black
};

constexpr Surfaces dark = {.text = {0.90f, 0.92f, 0.95f, 1},
                           .quiet_text = {0.58f, 0.62f, 0.69f, 1},
                           .panel = {0.086f, 0.098f, 0.129f, 1},
                           .raised = {0.110f, 0.125f, 0.165f, 0.98f},
                           .field = {0.157f, 0.176f, 0.224f, 1},
                           .edge = {0.204f, 0.227f, 0.286f, 1},
                           .accent = {0.302f, 0.565f, 0.996f, 1},
                           .mark = {1, 1, 1, 1}};

constexpr Surfaces light = {.text = {0.11f, 0.13f, 0.17f, 1},
                            .quiet_text = {0.38f, 0.41f, 0.47f, 1},
                            .panel = {0.976f, 0.980f, 0.988f, 1},
                            .raised = {1, 1, 1, 0.99f},
                            .field = {0.910f, 0.922f, 0.945f, 1},
                            .edge = {0.812f, 0.831f, 0.867f, 1},
                            .accent = {0.110f, 0.408f, 0.878f, 1},
                            .mark = {0, 0, 0, 1}};

/// Takes Carom's colours where Dear ImGui has its own kind.
class StyleColors
{
public:
    explicit StyleColors(ImGuiStyle& style) : style_(style) {}
    void set(ImGuiCol which, Color c) { style_.Colors[which] = {c.r, c.g, c.b, c.a}; }

private:
    ImGuiStyle& style_;
};

void set_surfaces(StyleColors colors, const Surfaces& s)
{
    const Color none;
    colors.set(ImGuiCol_Text, s.text);
    colors.set(ImGuiCol_TextDisabled, s.quiet_text);
    colors.set(ImGuiCol_TextSelectedBg, with_alpha(s.accent, 0.35f));
    colors.set(ImGuiCol_WindowBg, s.panel);
    colors.set(ImGuiCol_ChildBg, none);
    colors.set(ImGuiCol_PopupBg, s.raised);
    colors.set(ImGuiCol_ModalWindowDimBg, {0, 0, 0, 0.45f});
    colors.set(ImGuiCol_Border, s.edge);
    colors.set(ImGuiCol_BorderShadow, none);
    colors.set(ImGuiCol_TitleBg, mix(s.panel, s.field, 0.35f));
    colors.set(ImGuiCol_TitleBgActive, mix(s.panel, s.field, 0.7f));
    colors.set(ImGuiCol_TitleBgCollapsed, s.panel);
    colors.set(ImGuiCol_MenuBarBg, s.panel);
    colors.set(ImGuiCol_Separator, s.edge);
    colors.set(ImGuiCol_SeparatorHovered, with_alpha(s.accent, 0.6f));
    colors.set(ImGuiCol_SeparatorActive, s.accent);
    colors.set(ImGuiCol_ScrollbarBg, none);
    colors.set(ImGuiCol_ScrollbarGrab, with_alpha(s.mark, 0.16f));
    colors.set(ImGuiCol_ScrollbarGrabHovered, with_alpha(s.mark, 0.26f));
    colors.set(ImGuiCol_ScrollbarGrabActive, with_alpha(s.mark, 0.36f));
    colors.set(ImGuiCol_ResizeGrip, none);
    colors.set(ImGuiCol_ResizeGripHovered, with_alpha(s.accent, 0.5f));
    colors.set(ImGuiCol_ResizeGripActive, s.accent);
    colors.set(ImGuiCol_TableHeaderBg, s.field);
    colors.set(ImGuiCol_TableBorderStrong, s.edge);
    colors.set(ImGuiCol_TableBorderLight, with_alpha(s.edge, 0.6f));
    colors.set(ImGuiCol_TableRowBg, none);
    colors.set(ImGuiCol_TableRowBgAlt, with_alpha(s.mark, 0.03f));
    colors.set(ImGuiCol_NavHighlight, s.accent);
    colors.set(ImGuiCol_DragDropTarget, s.accent);
}

void set_controls(StyleColors colors, const Surfaces& s)
{
    colors.set(ImGuiCol_FrameBg, s.field);
    colors.set(ImGuiCol_FrameBgHovered, mix(s.field, s.mark, 0.07f));
    colors.set(ImGuiCol_FrameBgActive, mix(s.field, s.accent, 0.25f));
    colors.set(ImGuiCol_Button, mix(s.field, s.mark, 0.03f));
    colors.set(ImGuiCol_ButtonHovered, mix(s.field, s.accent, 0.35f));
    colors.set(ImGuiCol_ButtonActive, mix(s.field, s.accent, 0.6f));
    colors.set(ImGuiCol_CheckMark, s.accent);
    colors.set(ImGuiCol_SliderGrab, mix(s.accent, s.field, 0.15f));
    colors.set(ImGuiCol_SliderGrabActive, s.accent);
    colors.set(ImGuiCol_Header, with_alpha(s.accent, 0.18f));
    colors.set(ImGuiCol_HeaderHovered, with_alpha(s.accent, 0.28f));
    colors.set(ImGuiCol_HeaderActive, with_alpha(s.accent, 0.45f));
    colors.set(ImGuiCol_Tab, mix(s.panel, s.field, 0.6f));
    colors.set(ImGuiCol_TabHovered, mix(s.field, s.accent, 0.45f));
    colors.set(ImGuiCol_TabActive, mix(s.field, s.accent, 0.3f));
    colors.set(ImGuiCol_TabUnfocused, mix(s.panel, s.field, 0.4f));
    colors.set(ImGuiCol_TabUnfocusedActive, mix(s.field, s.accent, 0.15f));
    colors.set(ImGuiCol_PlotLines, s.accent);
    colors.set(ImGuiCol_PlotLinesHovered, mix(s.accent, s.mark, 0.35f));
    colors.set(ImGuiCol_PlotHistogram, s.accent);
    colors.set(ImGuiCol_PlotHistogramHovered, mix(s.accent, s.mark, 0.35f));
}

void set_distances(ImGuiStyle& style)
{
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.CellPadding = {6, 3};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.IndentSpacing = 16;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 10;
    style.WindowBorderSize = 1;
    style.PopupBorderSize = 1;
    style.ChildBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowRounding = 6;
    style.ChildRounding = 5;
    style.PopupRounding = 6;
    style.FrameRounding = 4;
    style.GrabRounding = 4;
    style.TabRounding = 4;
    style.ScrollbarRounding = 6;
    style.WindowTitleAlign = {0, 0.5f};
    style.WindowMenuButtonPosition = ImGuiDir_Right;
    style.SelectableTextAlign = {0, 0.5f};
}

} // namespace

void apply_to_imgui(ThemeKind kind, float ui_scale)
{
    ImGuiStyle style; // afresh: scaling is not to add up
    const Surfaces& surfaces = kind == ThemeKind::Light ? light : dark;
    set_surfaces(StyleColors(style), surfaces);
    set_controls(StyleColors(style), surfaces);
    set_distances(style);
    style.ScaleAllSizes(ui_scale);
    ImGui::GetStyle() = style;
}

} // namespace carom::gallery
