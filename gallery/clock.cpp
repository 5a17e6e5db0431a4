// Adds up the time that passed and takes whole steps from it.
#include "gallery/clock.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom::gallery
{

int Clock::advance(double elapsed, double time_step)
{
    // After a pause of the whole program, as when its window was hidden, nothing is made up for.
    constexpr double longest_frame = 0.1; // [s]
    if (requested_ > 0) is_paused_ = true;
    if (is_paused_)
    {
        blend_ = 1;
        behind_ = 0;
        return std::exchange(requested_, 0);
    }
    behind_ += speed_ * std::clamp(elapsed, 0.0, longest_frame);
    // A frame as long as the step must give one step, whatever the last bits of both say.
    const double steps = std::floor(behind_ / time_step + 1e-6);
    behind_ = std::max(behind_ - steps * time_step, 0.0);
    blend_ = static_cast<float>(std::min(behind_ / time_step, 1.0));
    return static_cast<int>(steps);
}

void Clock::set_paused(bool is_paused)
{
    is_paused_ = is_paused;
    requested_ = 0;
}

void Clock::set_speed(double speed) { speed_ = std::isfinite(speed) ? std::clamp(speed, slowest, fastest) : 1; }

} // namespace carom::gallery
