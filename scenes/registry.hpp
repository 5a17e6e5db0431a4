// Finds and makes scenes by name.
#pragma once

#include "scenes/scene.hpp"

namespace carom::scenes
{

/// In the order in which a list shows them.
const std::vector<SceneInfo>& all_scenes();

/// @throws SceneError naming a scene of a similar name, or all of them
const SceneInfo& find_scene(std::string_view name);

/// @param values parameters that differ from their defaults
/// @param seed   equal seeds and values give equal scenes
/// @throws SceneError on an unknown name, a value that does not fit, or values that can't be had together
std::unique_ptr<Scene> make_scene(std::string_view name, const ParameterValues& values = {}, std::uint64_t seed = 1);

/// The scene from its beginning, with the parameters that it has now.
std::unique_ptr<Scene> restarted(const Scene& scene);

} // namespace carom::scenes
