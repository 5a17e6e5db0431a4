// Pictures of Cairo as PNG.
#pragma once

#include <ostream>

struct _cairo_surface;

namespace carom::cli
{

/// @param out goes bad when it takes no more bytes; whoever opened it knows why
/// @throws Failure when the picture can't be encoded
void write_png(_cairo_surface* picture, std::ostream& out);

} // namespace carom::cli
