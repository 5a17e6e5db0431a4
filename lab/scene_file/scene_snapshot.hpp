// Writes down a named scene as it stands.
#pragma once

#include "lab/scene_file/model.hpp"
#include "scene_file/snapshot.hpp"
#include "scenes/scene.hpp"

namespace carom::lab
{

using scene_file::snapshot_of;

/// Its world, with the name, time step, substeps and view of the scene; what the scene's own code does to later steps is said in the notes.
SceneFile snapshot_of(const scenes::Scene& scene);

} // namespace carom::lab
