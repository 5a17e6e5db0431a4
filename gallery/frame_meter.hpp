// Where the time of a frame goes: steps, drawing, panels.
#pragma once

#include <array>
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
        for (double FrameTimes::* const part : parts)
        {
            recent_.*part += share * (frame.*part - recent_.*part);
            sum_.*part += frame.*part;
        }
    }

    const FrameTimes& recent() const { return recent_; } ///< means over the last frames
    FrameTimes mean() const                              ///< over all frames
    {
        FrameTimes mean;
        for (double FrameTimes::* const part : parts) mean.*part = frames_ > 0 ? sum_.*part / static_cast<double>(frames_) : 0;
        return mean;
    }

private:
    static constexpr int window = 60;
    static constexpr std::array parts = {&FrameTimes::step,     &FrameTimes::draw,       &FrameTimes::panels, &FrameTimes::present,
                                         &FrameTimes::draw_gpu, &FrameTimes::panels_gpu, &FrameTimes::whole};

    FrameTimes recent_;
    FrameTimes sum_;
    std::uint64_t frames_ = 0;
};

} // namespace carom::gallery
