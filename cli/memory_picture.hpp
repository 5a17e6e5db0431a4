// Draws the memory of a trace.
#pragma once

#include "lab/trace.hpp"

#include <ostream>

namespace carom::cli
{

/// The bytes in use by pool over the time of the trace, stacked, the pool that takes most at the bottom. Past eight pools the smallest
/// ones share a band. At most the first 30 characters of a pool's name are shown.
/// @param trace with at least one pool
/// @param out   gets the picture as PNG; goes bad when it takes no more bytes
/// @throws Failure when there is no memory to encode it
void draw_memory(const lab::Trace& trace, std::ostream& out);

} // namespace carom::cli
