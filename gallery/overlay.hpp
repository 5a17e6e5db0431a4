// What can be drawn over a scene to see how the engine works.
#pragma once

#include "gallery/step_film.hpp"
#include "scenes/draw_list.hpp"

#include <carom/carom.hpp>

namespace carom::gallery
{

/// What the person wants to see. Bounds and the nodes of the broad phase are parameters of every scene.
struct DrawOptions
{
    bool shapes = true;
    bool is_blended = true; ///< motion between steps
    bool mass_centers = false;
    bool contacts = false; ///< points and normals
    bool impulses = false; ///< of contacts and joints
    bool joints = false;
    bool islands = false; ///< a colour for each set of bodies that touch or are joined
    bool sleep = false;   ///< grey for what sleeps
    bool colors = false;  ///< of the graph of contacts
    bool velocities = false;
    bool names = false;
    bool grid = false; ///< of round distances, with a bar; gallery/grid.hpp draws it
};

/// @param height of the part of the world that is seen [m]
void draw_overlay(const World& world, const DrawOptions& options, float height, scenes::DrawList& list);

/// A moment of a step: all shapes plain, and on them what its stage is about.
void draw_moment(const StepFilm& film, std::size_t moment, float height, scenes::DrawList& list);

/// The outline of a body, for the one that is inspected.
void draw_outline(const World& world, BodyId body, scenes::Color color, scenes::DrawList& list);

} // namespace carom::gallery
