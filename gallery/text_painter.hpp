// Writes the texts of a scene over its picture.
#pragma once

#include "gallery/renderer.hpp"

#include <imgui.h>

namespace carom::gallery
{

/// Adds the list's texts to the background of Dear ImGui's current frame, behind all panels. Captions keep to the corners of the free
/// part of the window and break into lines at its width; texts in the world are where the view shows their place. Letters
/// have a rim in the colour of the ground, so that they read on everything.
/// @param view             as it was drawn
/// @param pixels_per_point Window::pixels_per_point()
/// @param free_min, free_max corners of the part of the window that panels leave free [points]
void paint_texts(const scenes::DrawList& list, const Renderer::View& view, const Theme& theme, float pixels_per_point, ImVec2 free_min,
                 ImVec2 free_max);

} // namespace carom::gallery
