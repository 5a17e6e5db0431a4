// The functions that make the scenes, and what several of them need. Each makes bodies and joints; the list in field_scenes.cpp gives the name, the
// description and the number of steps.
#pragma once

#include "lab/field_scenes/field_scenes.hpp"
#include "scenes/random.hpp"

namespace carom::lab
{

// Piles.
SceneFile large_pyramid(const FieldSetup& setup);
SceneFile many_pyramids(const FieldSetup& setup);
SceneFile compounds(const FieldSetup& setup);
SceneFile junkyard(const FieldSetup& setup);
SceneFile smash(const FieldSetup& setup);
// Large worlds of which little is busy.
SceneFile tile_world(const FieldSetup& setup);
SceneFile sleep(const FieldSetup& setup);
// Machines.
SceneFile joint_grid(const FieldSetup& setup);
SceneFile spinner(const FieldSetup& setup);
SceneFile tumbler(const FieldSetup& setup);
SceneFile washer(const FieldSetup& setup);
// Ragdolls.
SceneFile rain(const FieldSetup& setup);
SceneFile ragdolls(const FieldSetup& setup);
// What games do.
SceneFile mixed(const FieldSetup& setup);
SceneFile platformer(const FieldSetup& setup);
SceneFile stack(const FieldSetup& setup);
SceneFile rays(const FieldSetup& setup);
SceneFile spawn_and_destroy(const FieldSetup& setup);
SceneFile shots(const FieldSetup& setup);
// Without gravity, or with that of a sun.
SceneFile bouncing(const FieldSetup& setup);
SceneFile orbits(const FieldSetup& setup);

/// A body with one shape.
FileBody body_of(const BodyDef& def, const Geometry& geometry, const ShapeDef& shape = {});
/// A static body without shapes.
FileBody ground_body();
/// Adds a body and tells its number. Only for scenes whose events create none before.
int add(SceneFile& file, FileBody body);
/// Adds boxes of 1 m that touch each other, each row on the gaps of the one below; the top one comes last.
/// @param foot left end of the lowest row
void add_pyramid(SceneFile& file, Vec2 foot, int rows);
/// A floor and two walls on it, open above.
/// @param half_width of the inside [m]
FileBody open_box(float half_width, float height, const ShapeDef& shape = {});
/// A circle, a box, a capsule, or a polygon of up to 8 corners that fits into a circle of this radius [m].
Geometry mixed_geometry(int kind, float radius, scenes::Random& random);

} // namespace carom::lab
