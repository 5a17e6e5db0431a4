// How long the graphics card worked on a part of a frame.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

namespace carom::gallery
{

/// Asks the card for the time before and after, and takes the answers when they come, a frame or two later, so that nothing waits. A
/// software renderer works when it likes: what it says is only a hint.
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
    /// The last answer that has come [ms]; empty before the first one.
    std::optional<double> latest_ms();

private:
    static constexpr std::size_t ring_size = 4; ///< frames that a card may lag behind; what is asked beyond goes unmeasured

    struct Pair
    {
        unsigned begin = 0;
        unsigned end = 0;
    };

    void collect();

    std::array<Pair, ring_size> queries_ = {};
    std::size_t asked_ = 0;    ///< so far; the next one is queries_[asked_ % ring_size]
    std::size_t answered_ = 0; ///< so far
    bool is_running_ = false;
    std::optional<double> latest_ms_;
};

} // namespace carom::gallery
