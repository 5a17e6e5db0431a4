// How many bytes are in use in each named pool of memory, and how many were at most since somebody last looked.
#pragma once

#include "profile/block_table.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string_view>

namespace carom::profile
{

/// Follows blocks by their address, because a pool's user does not tell a block's size when it gives it back. For any thread.
class PoolTotals
{
public:
    using Clock = std::chrono::steady_clock;

    /// A pool that has changed since the last look.
    struct Change
    {
        const char* pool;         ///< its name; stays as long as the totals
        std::size_t bytes;        ///< in use now
        std::size_t bytes_before; ///< at the last look
        std::size_t peak_bytes;   ///< most since the last look
        Clock::time_point peak_time;
    };

    static constexpr std::size_t max_pools = 64; ///< the last one takes in all that come after

    /// Counts a block. One whose address is in use already is counted anew, with the new size; a null pointer is no block.
    void add(const void* pointer, std::size_t bytes, const char* pool);
    /// Does nothing for an address that it does not know.
    void remove(const void* pointer);

    /// Calls `each(const Change&)` for every pool that has changed since the last look, in the order in which the pools first came.
    template <class Each>
    void look(const Each& each)
    {
        const std::lock_guard lock(mutex_);
        for (std::size_t i = 0; i < pool_count_; ++i)
        {
            Pool& pool = pools_[i];
            if (!pool.has_changed) continue;
            each(Change{pool.name.data(), pool.bytes, pool.bytes_before, pool.peak_bytes, pool.peak_time});
            pool.has_changed = false;
            pool.peak_bytes = pool.bytes_before = pool.bytes;
        }
    }
    /// The next look tells of every pool.
    void mark_all_changed();

private:
    struct Pool
    {
        std::array<char, 64> name = {}; ///< a copy, since a pool may go with its name; a longer one is cut
        std::size_t bytes = 0;
        std::size_t bytes_before = 0;
        std::size_t peak_bytes = 0;
        Clock::time_point peak_time = {};
        bool has_changed = false;
    };
    std::size_t pool_of(std::string_view name);
    void subtract(const BlockTable::Block& block);

    std::mutex mutex_;
    std::array<Pool, max_pools> pools_;
    std::size_t pool_count_ = 0;
    BlockTable blocks_;
};

} // namespace carom::profile
