// The scenes that come with Carom, each in a file of its own. registry.cpp lists them.
#pragma once

#include "scenes/scene.hpp"

namespace carom::scenes
{

SceneInfo planets_scene();
SceneInfo triggers_scene();
SceneInfo collisions_scene();
SceneInfo gravity_scene();
SceneInfo queries_scene();
SceneInfo character_scene();
SceneInfo chain_terrain_scene();
SceneInfo tiles_scene();
SceneInfo one_way_scene();
SceneInfo bullets_scene();
SceneInfo sleep_scene();
SceneInfo bridge_scene();
SceneInfo domino_scene();
SceneInfo newton_cradle_scene();
SceneInfo card_house_scene();
SceneInfo arch_scene();
SceneInfo mass_ratio_scene();
SceneInfo joints_scene();
SceneInfo ragdolls_scene();
SceneInfo car_scene();

} // namespace carom::scenes
