// Reads scene files.
#pragma once

#include "scene_file/model.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace carom::scene_file
{

/// @throws SceneFileError when it can't be read, is too large, or holds what is no scene
SceneFile read_scene_file(const std::filesystem::path& path);
/// @param name of the source, for messages
SceneFile parse_scene_file(std::string_view text, const std::string& name);

} // namespace carom::scene_file
