// The panels around the scene, and the windows over it.
#pragma once

#include "gallery/gallery.hpp"

#include <array>
#include <string>

namespace carom::gallery
{

/// Lays out everything that is not the scene, and does what the person does to it.
/// @param window  of the program [points]
/// @param scale   how large letters are, 1 on a common screen
/// @return the part of the window that no panel covers
Rect draw_panels(Gallery& gallery, scenes::Viewport window, float scale);

// The parts, each within a panel.
void scene_list(Gallery& gallery, float height);
void scene_story(const Gallery& gallery);
void scene_controls(const Gallery& gallery);
void parameter_list(Gallery& gallery);
void time_bar(Gallery& gallery);
void look_tab(Gallery& gallery);
void measure_tab(Gallery& gallery);
void broad_phase_tab(Gallery& gallery);
void memory_tab(Gallery& gallery);
void body_tab(Gallery& gallery);
void inside_panel(Gallery& gallery);
void help_text(const Gallery& gallery);
void file_dialog_content(Gallery& gallery);
void status_line(Gallery& gallery);

/// A number of the status line, in words.
struct StatusFigure
{
    std::string text;
    const char* tip;
};
std::array<StatusFigure, 5> status_figures(const Gallery& gallery);

} // namespace carom::gallery
