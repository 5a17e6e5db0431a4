// Draws what a scene shows into a picture in memory, with Cairo.
#pragma once

#include "scenes/camera.hpp"
#include "scenes/draw_list.hpp"

#include <cstddef>
#include <memory>
#include <ostream>
#include <span>

struct _cairo;
struct _cairo_surface;

namespace carom::cli
{

enum class Quality
{
    Fine, ///< smooth edges
    Quick ///< a pixel is covered or not, and curves are coarse
};

/// A picture that can be drawn again and again.
class Canvas
{
public:
    /// @throws Failure when there is no memory for it
    explicit Canvas(scenes::Viewport size, Quality quality = Quality::Fine);

    scenes::Viewport size() const { return size_; }
    /// Paints over all that was there.
    void draw(const scenes::DrawList& list, const scenes::Camera& camera);
    /// Rows from the top; each pixel is blue, green, red, and a byte without meaning.
    std::span<const std::byte> pixels();
    /// As PNG. The stream goes bad when it takes no more bytes.
    /// @throws Failure when there is no memory to encode it
    void write(std::ostream& out);

private:
    struct Release
    {
        void operator()(_cairo_surface* surface) const;
        void operator()(_cairo* context) const;
    };

    void draw_layer(const scenes::DrawnLayer& layer, const scenes::Camera& camera);
    void draw_texts(const scenes::DrawList& list, const scenes::Camera& camera);

    scenes::Viewport size_;
    std::unique_ptr<_cairo_surface, Release> surface_;
    std::unique_ptr<_cairo, Release> context_;
};

} // namespace carom::cli
