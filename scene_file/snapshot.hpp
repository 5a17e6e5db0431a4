// Writes down a world as it stands.
#pragma once

#include "scene_file/model.hpp"

#include <carom/carom.hpp>

namespace carom::scene_file
{

/// The settings of a world, without its fields.
FileWorld settings_of(const World& world);

/// The bodies, joints, fields and settings of a world as they stand. Of a world that has not been stepped, and whose bodies, shapes and joints were
/// made in the order of the file and never destroyed, the file plays to the same bits; what it can't hold is said in its notes: hooks, forces
/// that wait for the next step, and of a world that has been stepped, its contacts with their impulses.
/// @param names of shapes, chains and joints; null for none
SceneFile snapshot_of(const World& world, const SceneNames* names = nullptr);

} // namespace carom::scene_file
