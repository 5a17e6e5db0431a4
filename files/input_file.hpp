// Reading files, with the reason when one can't be read.
#pragma once

#include "files/errors.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

namespace carom::files
{

/// @throws CannotRead naming the file and the reason: `can't read "a.json": No such file or directory`
std::ifstream open_input(const std::filesystem::path& path);

/// The whole of a file.
/// @param most_bytes bounds the memory for a file without an end
/// @throws CannotRead, also when the file is longer
std::string read_text(const std::filesystem::path& path, std::size_t most_bytes);

} // namespace carom::files
