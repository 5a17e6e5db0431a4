// Reads scene files.
#pragma once

#include "scene_file/model.hpp"
#include "scene_file/text_input.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace carom::scene_file
{

struct ReadResult
{
    SceneFile file;                     ///< to be used only when there are no problems
    std::vector<SceneProblem> problems; ///< in the order of the file
};

/// Reads a file in small blocks, from its first character to its last or to a problem after which it can't go on. Memory grows with what the scene
/// holds, never with what is refused.
/// @param most after so many problems the rest is not looked at, >= 1
ReadResult read(TextInput& input, int most);

/// Reads and checks; the first problem is thrown.
/// @throws SceneFileError
SceneFile read_checked(TextInput& input);
/// @throws SceneFileError when it can't be read, is too large, or holds what is no scene
SceneFile read_scene_file(const std::filesystem::path& path);
/// @param name of the source, for messages
SceneFile parse_scene_file(std::string_view text, const std::string& name);

} // namespace carom::scene_file
