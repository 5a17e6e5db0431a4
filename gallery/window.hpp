// The window: SDL opens it, OpenGL draws in it, Dear ImGui lays panels over it.
#pragma once

#include "gallery/fonts.hpp"
#include "gallery/picture.hpp"
#include "scenes/camera.hpp"

#include <memory>
#include <string>

struct SDL_Window;
union SDL_Event;
struct ImGuiContext;

namespace carom::gallery
{

struct WindowOptions
{
    std::string title = "Carom";
    int width = 1280;  ///< [points], >= 1; no more than the screen has
    int height = 720;  ///< [points], >= 1; no more than the screen has
    bool vsync = true; ///< present() waits for the screen
};

/// A window with OpenGL 3.3 and Dear ImGui in it. With SDL_VIDEODRIVER=offscreen it needs no display.
/// A frame is: handle() every event, begin_frame(), draw, end_panels(), perhaps read_back(), present(). One window at a time; what holds
/// objects of OpenGL (Renderer, GpuTimer) must go before the window does.
class Window
{
public:
    /// @throws Failure when there is no display or no OpenGL 3.3, saying what was found and what helps
    explicit Window(const WindowOptions& options);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    scenes::Viewport size() const;   ///< [points], as pointer events count; >= 1 each
    scenes::Viewport pixels() const; ///< of the framebuffer, >= 1 each
    float pixels_per_point() const;  ///< 1, but more on screens with very small pixels where the system counts in points
    float ui_scale() const;          ///< how much larger than on a screen of 96 dots an inch letters should be, 1 to 3; 1 without a display
    ImFont* title_font() const;      ///< larger letters for titles; valid until the next begin_frame()

    /// Hands the event to Dear ImGui. Sizes follow the window by themselves.
    void handle(const SDL_Event& event);
    /// Begins a frame of Dear ImGui; clears nothing.
    void begin_frame();
    /// Draws the panels over what was drawn since.
    void end_panels();
    /// Shows the frame.
    void present();

    void set_title(const std::string& title);
    void set_full_screen(bool full_screen);
    bool is_full_screen() const;

    /// What the framebuffer holds now, before present().
    Picture read_back() const;

private:
    struct Video
    {
        Video();
        ~Video();
        Video(const Video&) = delete;
        Video& operator=(const Video&) = delete;
    };
    struct Release
    {
        void operator()(SDL_Window* window) const;
        void operator()(void* gl_context) const;
        void operator()(ImGuiContext* context) const;
    };

    void load_letters();

    Video video_;
    std::unique_ptr<SDL_Window, Release> window_;
    std::unique_ptr<void, Release> gl_;
    std::unique_ptr<ImGuiContext, Release> imgui_;
    float ui_scale_ = 1;
    float letters_for_ = 0; ///< pixels per point that the letters in the atlas are made for
    Fonts fonts_;
};

} // namespace carom::gallery
