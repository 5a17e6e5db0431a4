// Where the time of a frame goes: steps, drawing, panels.
#pragma once

#include "gallery/history.hpp"

#include <cstdint>

namespace carom::gallery
{

/// Times of one frame [ms]. What the graphics processor takes it takes beside the others, and it is known a few frames later.
struct FrameTimes
{
    double step = 0;       ///< all steps of the frame
    double draw = 0;       ///< gathering the picture and handing it to OpenGL
    double panels = 0;     ///< laying out the panels and handing them to OpenGL
    double present = 0;    ///< handing the frame to the screen, and waiting for it; a software renderer draws here
    double draw_gpu = 0;   ///< the picture
    double panels_gpu = 0; ///< the panels
    double whole = 0;      ///< from frame to frame, waiting for the screen included
};

class FrameMeter
{
public:
    void add(const FrameTimes& frame)
    {
        ++frames_;
        const double share = frames_ < window ? 1.0 / static_cast<double>(frames_) : 1.0 / window;
        const auto blend = [share](double& mean, double value) { mean += share * (value - mean); };
        blend(recent_.step, frame.step);
        blend(recent_.draw, frame.draw);
        blend(recent_.panels, frame.panels);
        blend(recent_.present, frame.present);
        blend(recent_.draw_gpu, frame.draw_gpu);
        blend(recent_.panels_gpu, frame.panels_gpu);
        blend(recent_.whole, frame.whole);
        sum_.step += frame.step;
        sum_.draw += frame.draw;
        sum_.panels += frame.panels;
        sum_.present += frame.present;
        sum_.draw_gpu += frame.draw_gpu;
        sum_.panels_gpu += frame.panels_gpu;
        sum_.whole += frame.whole;
        whole_.add(frame.whole);
    }

    const FrameTimes& recent() const { return recent_; } ///< means over the last frames
    FrameTimes mean() const                              ///< over all frames
    {
        const double n = frames_ > 0 ? static_cast<double>(frames_) : 1;
        return {sum_.step / n, sum_.draw / n, sum_.panels / n, sum_.present / n, sum_.draw_gpu / n, sum_.panels_gpu / n, sum_.whole / n};
    }
    std::uint64_t frames() const { return frames_; }
    const History& whole() const { return whole_; }

private:
    static constexpr int window = 60;

    FrameTimes recent_;
    FrameTimes sum_;
    History whole_;
    std::uint64_t frames_ = 0;
};

} // namespace carom::gallery
