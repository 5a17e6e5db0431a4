// What a window showed, as pixels in memory, and the way into a file.
#pragma once

#include "scenes/color.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace carom::gallery
{

/// Rows from the top; each pixel is red, green, blue and opacity, a byte each.
struct Picture
{
    int width = 0;  ///< [pixels]
    int height = 0; ///< [pixels]
    std::vector<std::uint8_t> rgba = {};

    /// @param x from the left, 0 to width - 1
    /// @param y from the top, 0 to height - 1
    /// @throws std::out_of_range beyond the picture
    scenes::Color at(int x, int y) const;
};

/// Writes the picture without its opacity, as files::OutputFile does: an earlier file stays until the new one is complete; "-" is standard
/// output.
/// @throws Failure naming the path and the reason; then nothing has changed
void write_png(const Picture& picture, const std::filesystem::path& path);

} // namespace carom::gallery
