// Cairo writes the file, under a temporary name beside its place.
#include "gallery/picture.hpp"

#include "gallery/failure.hpp"

#include <cairo.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>

namespace carom::gallery
{

namespace
{

struct DestroySurface
{
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;

/// A file that goes away unless it got its name.
class TemporaryFile
{
public:
    explicit TemporaryFile(const std::filesystem::path& goal)
        : goal_(goal),
          path_(goal.parent_path() / ("." + goal.filename().string() + "." + std::to_string(::getpid()) + ".part"))
    {
    }
    ~TemporaryFile()
    {
        std::error_code ignored;
        if (!path_.empty()) std::filesystem::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

    void move_to_goal()
    {
        std::error_code error;
        std::filesystem::rename(path_, goal_, error);
        if (error) throw Failure("can't write \"" + goal_.string() + "\": " + error.message());
        path_.clear();
    }

private:
    std::filesystem::path goal_;
    std::filesystem::path path_;
};

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
    const auto check = [&](cairo_status_t status)
    {
        if (status != CAIRO_STATUS_SUCCESS) throw Failure("can't write \"" + path.string() + "\": " + cairo_status_to_string(status));
    };
    std::error_code ignored;
    if (!path.has_filename()) throw Failure("can't write \"" + path.string() + "\": give the name of a file");
    if (std::filesystem::is_directory(path, ignored)) throw Failure("can't write \"" + path.string() + "\": it is a folder");
    if (!path.parent_path().empty() && !std::filesystem::is_directory(path.parent_path(), ignored))
        throw Failure("can't write \"" + path.string() + "\": there is no folder \"" + path.parent_path().string() + "\"");

    const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, picture.width, picture.height));
    check(cairo_surface_status(surface.get()));
    copy_rows(picture, surface.get());
    TemporaryFile file(path);
    check(cairo_surface_write_to_png(surface.get(), file.path().c_str()));
    file.move_to_goal();
}

} // namespace carom::gallery
