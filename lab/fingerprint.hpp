// Tells by a few characters whether two files or programs are the same.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace carom::lab
{

/// 16 hexadecimal digits: the FNV-1a hash of the bytes. Meant for mistakes, not for forgers.
std::string fingerprint_of(std::string_view bytes);

/// Of the bytes of a file; empty when it can't be read.
std::string fingerprint_of_file(const std::filesystem::path& file);

} // namespace carom::lab
