// Counting blocks in and out of their pools.
#include "profile/pool_totals.hpp"

#include <algorithm>

namespace carom::profile
{

std::size_t PoolTotals::pool_of(std::string_view name)
{
    name = name.substr(0, pools_[0].name.size() - 1); // a zero follows
    for (std::size_t i = 0; i < pool_count_; ++i)
    {
        if (name == pools_[i].name.data()) return i;
    }
    if (pool_count_ == max_pools) return max_pools - 1;
    if (pool_count_ == max_pools - 1) name = "other pools";
    std::copy(name.begin(), name.end(), pools_[pool_count_].name.begin());
    return pool_count_++;
}

void PoolTotals::subtract(const BlockTable::Block& block)
{
    pools_[block.pool].bytes -= block.bytes;
    pools_[block.pool].has_changed = true;
}

void PoolTotals::add(const void* pointer, std::size_t bytes, const char* pool_name)
{
    if (!pointer) return;
    const std::lock_guard lock(mutex_);
    if (const auto before = blocks_.remove(pointer)) subtract(*before);
    const std::size_t index = pool_of(pool_name);
    if (!blocks_.insert({pointer, bytes, index})) return;
    Pool& pool = pools_[index];
    pool.bytes += bytes;
    pool.has_changed = true;
    if (pool.bytes <= pool.peak_bytes) return;
    pool.peak_bytes = pool.bytes;
    pool.peak_time = Clock::now();
}

void PoolTotals::remove(const void* pointer)
{
    const std::lock_guard lock(mutex_);
    if (const auto block = blocks_.remove(pointer)) subtract(*block);
}

void PoolTotals::mark_all_changed()
{
    const std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < pool_count_; ++i)
    {
        pools_[i].has_changed = true;
        pools_[i].peak_bytes = pools_[i].bytes_before = pools_[i].bytes;
    }
}

} // namespace carom::profile
