// Draws what a scene shows with OpenGL.
#pragma once

#include "gallery/shape_instance.hpp"
#include "gallery/theme.hpp"
#include "scenes/camera.hpp"
#include "scenes/draw_list.hpp"

#include <vector>

namespace carom::gallery
{

/// Draws a scene's draw list: every shape is an instance of one quad whose fragment shader evaluates the signed distance of a rounded
/// polygon of 1 to 8 corners. So edges are smooth and round at every zoom, and nothing is cut into triangles on the processor.
class Renderer
{
public:
    struct View
    {
        scenes::Camera camera;     ///< shows its part of the world in the whole framebuffer
        scenes::Viewport viewport; ///< the framebuffer [pixels]
    };

    struct Counts
    {
        int draw_calls = 0;
        int instances = 0; ///< shapes and lines that the picture shows
    };

    /// Needs the current context of a Window, and must go before it does.
    /// @throws Failure with the driver's words
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Shapes and lines; texts are paint_texts()'s. Clears to the list's background. A camera whose height is not a positive number, and
    /// shapes that are not finite, show nothing.
    void draw(const scenes::DrawList& list, const View& view, const Theme& theme);
    /// Of the last draw().
    Counts last() const { return last_; }

private:
    void make_buffers();
    void upload();

    // Names of OpenGL's objects; 0 is none.
    unsigned program_ = 0;
    unsigned vertex_array_ = 0;
    unsigned frame_indices_ = 0;
    unsigned instance_buffer_ = 0;
    int half_picture_ = -1; ///< the uniform

    std::vector<ShapeInstance> instances_; ///< kept between frames for its memory
    Counts last_;
};

} // namespace carom::gallery
