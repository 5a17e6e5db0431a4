// What tests of the drawing share: a window without a display, and colours of its pixels.
#pragma once

#include "gallery/failure.hpp"
#include "gallery/renderer.hpp"
#include "gallery/window.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>

namespace carom::gallery
{

inline constexpr scenes::Color black = scenes::rgb(0, 0, 0);
inline constexpr scenes::Color white = scenes::rgb(1, 1, 1);
inline constexpr scenes::Color red = scenes::rgb(1, 0, 0);
inline constexpr scenes::Color green = scenes::rgb(0, 1, 0);

/// Opens windows that no display shows. Only where there is no OpenGL at all, as without Mesa, its tests are left out.
class OffscreenTest : public ::testing::Test
{
protected:
    void SetUp() override { open({320, 200}); }

    void open(scenes::Viewport size)
    {
        ::setenv("SDL_VIDEODRIVER", "offscreen", 1);
        renderer_.reset();
        window_.reset();
        try
        {
            window_ = std::make_unique<Window>(WindowOptions{.width = size.width, .height = size.height, .vsync = false});
        }
        catch (const Failure& failure)
        {
            FAIL() << "the gallery can't be tested without OpenGL: " << failure.what();
        }
        renderer_ = std::make_unique<Renderer>();
    }

    /// One pixel a metre, the world's origin in the middle.
    Renderer::View view() const
    {
        const scenes::Viewport size = window_->pixels();
        return {.camera = {.center = {}, .height = static_cast<float>(size.height)}, .viewport = size};
    }

    Picture drawn(const scenes::DrawList& list, const Renderer::View& seen, const Theme& theme = Theme())
    {
        renderer_->draw(list, seen, theme);
        return window_->read_back();
    }
    Picture drawn(const scenes::DrawList& list) { return drawn(list, view()); }

    std::unique_ptr<Window> window_;
    std::unique_ptr<Renderer> renderer_; // goes before the window
};

/// An empty picture's list: black.
inline scenes::DrawList black_list()
{
    scenes::DrawList list;
    list.background = black;
    return list;
}

/// Of the pixel that holds a place [pixels from the middle of the picture, y up].
inline scenes::Color color_at(const Picture& picture, Vec2 place)
{
    return picture.at(static_cast<int>(0.5f * static_cast<float>(picture.width) + place.x),
                      static_cast<int>(0.5f * static_cast<float>(picture.height) - place.y));
}

/// How many pixels' worth of red the picture holds.
inline double red_area(const Picture& picture)
{
    double area = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) area += picture.rgba[i] / 255.0;
    return area;
}

} // namespace carom::gallery
