// Writes down a world as it stands.
#pragma once

#include "lab/scene_file/model.hpp"
#include "scenes/scene.hpp"

#include <carom/carom.hpp>

namespace carom::lab
{

/// The bodies, joints, fields and settings of a world as they stand. Of a world that has not been stepped, and whose bodies, shapes and joints were
/// made in the order of the file and never destroyed, the file plays to the same bits; what it can't hold is said in its notes: hooks, forces
/// that wait for the next step, and of a world that has been stepped, its contacts with their impulses.
SceneFile snapshot_of(const World& world);

/// With the name, time step, substeps and view of the scene; what the scene's own code does to later steps is said in the notes.
SceneFile snapshot_of(const scenes::Scene& scene);

} // namespace carom::lab
