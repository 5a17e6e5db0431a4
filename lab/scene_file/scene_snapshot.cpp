// Adds to a world what only its scene knows.
#include "lab/scene_file/scene_snapshot.hpp"

namespace carom::lab
{

SceneFile snapshot_of(const scenes::Scene& scene)
{
    SceneFile file = snapshot_of(scene.world());
    file.name = scene.info().name;
    file.description = scene.info().description;
    file.time_step = scene.time_step();
    file.substeps = scene.parameters().integer("substeps");
    file.view = FileView{scene.camera().center, scene.camera().height};
    if (!scene.info().own_code.empty()) file.notes.push_back("The scene's own code is not in the file: " + scene.info().own_code + ".");
    return file;
}

} // namespace carom::lab
