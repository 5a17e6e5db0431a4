// What must hold between the parts of a scene file, and what an engine must have to run it.
#pragma once

#include "scene_file/model.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom::scene_file
{

/// Numbers of bodies and joints name what is there at that step, events come by step, the whole file is within its limits, and `needs` leaves
/// nothing out; an empty one is filled in.
/// @param name of the file, for messages
/// @throws SceneFileError
void check(SceneFile& file, const std::string& name);

/// All that check() would refuse, in the order of the file.
/// @param most after so many problems the rest is not looked at, >= 1
std::vector<SceneProblem> problems_of(const SceneFile& file, const std::string& name, int most);

/// What an engine must have to run the scene, of feature_words().
std::vector<std::string> needs_of(const SceneFile& file);

/// All words that `needs` may hold.
std::span<const std::string_view> feature_words();

} // namespace carom::scene_file
