// Writes scene files.
#pragma once

#include "scene_file/model.hpp"

#include <filesystem>
#include <ostream>
#include <string>

namespace carom::scene_file
{

/// Writes a scene as JSON: each body, joint, event and ray on a line of its own, numbers with as many digits as they need to come back to the last
/// bit, and no field that is at its default. `needs` is written as needs_of() has it.
/// @throws SceneFileError on a number that is not finite, which JSON can't hold
void write_scene_file(std::ostream& out, const SceneFile& file);
std::string scene_file_text(const SceneFile& file);

/// @throws SceneFileError also when it can't be written
void write_scene_file(const std::filesystem::path& path, const SceneFile& file);

} // namespace carom::scene_file
