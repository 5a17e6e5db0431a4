// A grid of round distances over the scene, and a bar that says how long one of them is.
#pragma once

#include "gallery/view.hpp"
#include "scenes/draw_list.hpp"

#include <string>

namespace carom::gallery
{

/// 1, 2 or 5 times a power of ten.
/// @param least [m], > 0
/// @return the smallest such distance that is no shorter [m]
float round_distance(float least);
/// "5 m", "20 cm", "2 km".
std::string distance_text(float metres);

/// Lines across the whole window, and at the lower right of the part that no panel covers the bar.
void draw_grid(const View& view, scenes::DrawList& list);

} // namespace carom::gallery
