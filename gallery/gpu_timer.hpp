// How long the graphics card worked on a part of a frame.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <optional>

namespace carom::gallery
{

/// Asks the card and takes the answer when it comes, a frame or two later, so that nothing waits. Only one timer can run at a time.
class GpuTimer
{
public:
    /// Needs the current context of a Window, and must go before it does.
    GpuTimer();
    ~GpuTimer();
    GpuTimer(const GpuTimer&) = delete;
    GpuTimer& operator=(const GpuTimer&) = delete;

    void begin();
    void end();
    /// The last answer that has come [ms]; empty before the first one. Answers longer than the time since they were asked for are left
    /// out: some drivers give one when they start.
    std::optional<double> latest_ms();

private:
    static constexpr std::size_t ring_size = 4; ///< frames that a card may lag behind; what is asked beyond goes unmeasured

    using Clock = std::chrono::steady_clock;

    void collect();

    std::array<unsigned, ring_size> queries_ = {};
    std::array<Clock::time_point, ring_size> begins_ = {}; ///< when each was asked
    std::size_t asked_ = 0;                                ///< so far; the next one is queries_[asked_ % ring_size]
    std::size_t answered_ = 0;                             ///< so far
    bool is_running_ = false;
    std::optional<double> latest_ms_;
};

} // namespace carom::gallery
