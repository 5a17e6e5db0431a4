// Draws the memory of a trace.
#pragma once

#include "lab/trace.hpp"

#include <filesystem>

namespace carom::cli
{

/// The bytes in use by pool over the time of the trace, stacked, the pool that takes most at the bottom. Past eight pools the smallest
/// ones share a band. At most the first 30 characters of a pool's name are shown.
/// @param trace with at least one pool
/// @param path  the picture, in the format PNG
/// @throws Failure when it can't be written
void draw_memory(const lab::Trace& trace, const std::filesystem::path& path);

} // namespace carom::cli
