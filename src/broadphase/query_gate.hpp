// Lets many threads query a structure that has to be brought up to date first.
#pragma once

#include <atomic>
#include <mutex>

namespace carom::detail
{

/// Changes close the gate; the first query after one brings the structure up to date and opens it, while others wait. Changes and queries do
/// not come at the same time. A copy starts closed.
class QueryGate
{
public:
    QueryGate() = default;
    QueryGate(const QueryGate&) {}
    QueryGate& operator=(const QueryGate&)
    {
        close();
        return *this;
    }

    void close() { is_open_.store(false, std::memory_order_relaxed); }

    template <class Prepare>
    void pass(Prepare&& prepare)
    {
        if (is_open_.load(std::memory_order_acquire)) return;
        const std::lock_guard lock(mutex_);
        if (is_open_.load(std::memory_order_relaxed)) return;
        prepare(); // may throw: then the gate stays closed
        is_open_.store(true, std::memory_order_release);
    }

private:
    std::atomic<bool> is_open_ = false;
    std::mutex mutex_;
};

} // namespace carom::detail
