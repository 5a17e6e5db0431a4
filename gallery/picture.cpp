// Cairo encodes the picture into an output file.
#include "gallery/picture.hpp"

#include "files/output_file.hpp"
#include "gallery/failure.hpp"

#include <cairo.h>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>

namespace carom::gallery
{

namespace
{

struct DestroySurface
{
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;

/// Cairo keeps a pixel as one number, 0x00rrggbb.
void copy_rows(const Picture& picture, cairo_surface_t* surface)
{
    cairo_surface_flush(surface);
    std::uint8_t* const rows = cairo_image_surface_get_data(surface);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface));
    const auto width = static_cast<std::size_t>(picture.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y)
    {
        auto* const row = reinterpret_cast<std::uint32_t*>(rows + y * stride); // Cairo aligns its rows for this
        for (std::size_t x = 0; x < width; ++x)
        {
            const std::uint8_t* const p = &picture.rgba[4 * (y * width + x)];
            row[x] = static_cast<std::uint32_t>(p[0]) << 16 | static_cast<std::uint32_t>(p[1]) << 8 | static_cast<std::uint32_t>(p[2]);
        }
    }
    cairo_surface_mark_dirty(surface);
}

cairo_status_t write_bytes(void* out, const unsigned char* bytes, unsigned int count)
{
    std::ostream& stream = *static_cast<std::ostream*>(out);
    return stream.write(reinterpret_cast<const char*>(bytes), count) ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

} // namespace

scenes::Color Picture::at(int x, int y) const
{
    if (x < 0 || x >= width || y < 0 || y >= height)
        throw std::out_of_range("pixel (" + std::to_string(x) + ", " + std::to_string(y) + ") of a picture of " + std::to_string(width) +
                                " x " + std::to_string(height));
    const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    const auto level = [&](std::size_t k) { return static_cast<float>(rgba[i + k]) / 255; };
    return {level(0), level(1), level(2), level(3)};
}

void write_png(const Picture& picture, const std::filesystem::path& path)
{
    const auto check = [](cairo_status_t status)
    {
        if (status != CAIRO_STATUS_SUCCESS) throw Failure(std::string("can't encode the picture: ") + cairo_status_to_string(status));
    };
    try
    {
        files::OutputFile file("", path);
        const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height));
        check(cairo_surface_status(surface.get()));
        copy_rows(picture, surface.get());
        const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), write_bytes, &file.stream());
        if (file.stream()) check(status); // or else commit() knows why
        file.commit();
    }
    catch (const files::FileError& error)
    {
        throw Failure(error.what());
    }
}

} // namespace carom::gallery
