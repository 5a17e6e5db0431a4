// The recorder behind the back end `chrome`: keeps events in memory, a log a thread, until they are written to a file.
#pragma once

#include "profile/pool_totals.hpp"
#include "profile/thread_log.hpp"

#include <carom/profile.hpp>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace carom::profile
{

/// Pools are followed from the recorder's first day, so that a recording starts with what is in use; events are kept only while it records.
/// All names are kept by address. Every function may be called from any thread.
class ChromeTrace
{
public:
    using Clock = std::chrono::steady_clock;

    ChromeTrace();
    ChromeTrace(const ChromeTrace&) = delete;
    ChromeTrace& operator=(const ChromeTrace&) = delete;

    void start(const TraceOptions& options);
    bool is_recording() const { return is_recording_.load(std::memory_order_relaxed); }
    TraceResult write(const std::string& path);

    void add_zone(const char* name, Clock::time_point start, Clock::time_point end);
    /// Marks a frame, and notes the pools that have changed since the last.
    void add_frame();
    void add_plot(const char* name, double value);
    void add_block(const void* pointer, std::size_t bytes, const char* pool) { pools_.add(pointer, bytes, pool); }
    void remove_block(const void* pointer) { pools_.remove(pointer); }
    void name_thread(const char* name);

private:
    std::shared_ptr<ThreadLog> log_of_this_thread();
    void add(const TraceEvent& event);
    void note_pools(Clock::time_point now);
    void forget_ended_threads();

    const std::uint64_t id_; ///< tells recorders apart, also one that took another's place in memory
    std::atomic<bool> is_recording_ = false;
    std::atomic<std::int64_t> start_ns_ = 0;
    ChunkBudget budget_ = 0;
    PoolTotals pools_;

    std::mutex control_; ///< held by start and write
    bool has_recording_ = false;

    std::mutex threads_mutex_; ///< guards the two below
    std::vector<std::shared_ptr<ThreadLog>> threads_;
    std::uint32_t threads_seen_ = 0;
};

} // namespace carom::profile
