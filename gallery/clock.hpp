// When to step: turns the time that passes for the person into steps of the scene.
#pragma once

namespace carom::gallery
{

class Clock
{
public:
    static constexpr double slowest = 0.01; ///< of `speed`
    static constexpr double fastest = 8;    ///< of `speed`

    /// @param elapsed   since the frame before [s], >= 0
    /// @param time_step of the scene [s], > 0
    /// @return how many steps are due; while paused those that were asked for
    int advance(double elapsed, double time_step);
    /// The steps that were due could not be made in time: forgets them, so that they do not pile up.
    void drop()
    {
        behind_ = 0;
        blend_ = 1;
    }

    bool is_paused() const { return is_paused_; }
    void set_paused(bool is_paused);
    void request_step() { ++requested_; } ///< pauses too
    double speed() const { return speed_; }
    /// @param speed simulated seconds in a second, is kept within slowest and fastest
    void set_speed(double speed);

    /// Where the picture stands between the last two steps: 0 at the one before the last, 1 at the last.
    float blend() const { return blend_; }

private:
    bool is_paused_ = false;
    int requested_ = 0;
    double speed_ = 1;
    double behind_ = 0; ///< time that has passed and was not simulated yet [s]
    float blend_ = 1;
};

} // namespace carom::gallery
