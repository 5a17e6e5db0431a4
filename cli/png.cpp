// Hands Cairo's bytes on to a stream.
#include "cli/png.hpp"

#include "cli/errors.hpp"

#include <cairo.h>

#include <string>

namespace carom::cli
{

namespace
{

cairo_status_t write_bytes(void* out, const unsigned char* bytes, unsigned int count)
{
    std::ostream& stream = *static_cast<std::ostream*>(out);
    return stream.write(reinterpret_cast<const char*>(bytes), count) ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

} // namespace

void write_png(_cairo_surface* picture, std::ostream& out)
{
    const cairo_status_t status = cairo_surface_write_to_png_stream(picture, write_bytes, &out);
    if (status != CAIRO_STATUS_SUCCESS && out) throw Failure(std::string("can't encode the picture: ") + cairo_status_to_string(status));
}

} // namespace carom::cli
