// The program: a window, a gallery, and the frames that join them.
#pragma once

#include "gallery/frame_meter.hpp"
#include "gallery/gallery.hpp"
#include "gallery/gpu_timer.hpp"
#include "gallery/options.hpp"
#include "gallery/renderer.hpp"
#include "gallery/window.hpp"

#include <chrono>
#include <iosfwd>

union SDL_Event;

namespace carom::gallery
{

class App
{
public:
    /// @throws Failure, SceneError
    explicit App(const Options& options);

    /// Frames until the person ends it, or as many as the options say.
    void run();
    /// What the parts of a frame took, as text or JSON.
    void report(std::ostream& out) const;

private:
    using SteadyClock = std::chrono::steady_clock;

    void frame();
    void advance(double seconds, FrameTimes& times);
    void show(FrameTimes& times);
    void handle_events();
    void handle(const SDL_Event& event);
    bool is_over_panel(Vec2 point) const;
    void lay_out();
    void draw_scene();
    void draw_marks(scenes::DrawList& list) const;
    void update_window();
    double elapsed(SteadyClock::time_point now);

    Options options_;
    Window window_;
    Renderer renderer_;
    GpuTimer draw_timer_;
    GpuTimer panel_timer_;
    Gallery gallery_;
    Theme theme_;
    SteadyClock::time_point last_frame_;
    int frame_ = 0;           ///< counted from 0
    Vec2 pointer_ = {-1, -1}; ///< [points]
    std::string title_;
};

/// The whole program.
/// @param arguments without its name
/// @return exit status: 0 done, 1 failed, 2 bad usage
int run_gallery(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

} // namespace carom::gallery
