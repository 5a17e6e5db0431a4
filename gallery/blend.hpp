// A picture between two steps, so that motion is smooth whatever the rates of steps and frames.
#pragma once

#include "scenes/draw_list.hpp"

namespace carom::gallery
{

/// What is seen at a time between two pictures of one scene. Things are told apart by their place in the list. A list that has another length
/// than before, a thing of another kind, and one that jumped are shown as they are in `after`.
/// @param t         0 gives the places of `before`, 1 those of `after`
/// @param jump      farther than this nothing moves in a step [m]
/// @param blended   is replaced; keeps its memory
void blend(const scenes::DrawList& before, const scenes::DrawList& after, float t, float jump, scenes::DrawList& blended);

/// The transform between two, turning the short way.
Transform between(const Transform& a, const Transform& b, float t);

} // namespace carom::gallery
