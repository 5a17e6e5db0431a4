// Keeping count of blocks.
#pragma once

#include <carom/memory.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace carom::detail
{

inline void count_allocation(MemoryStats& stats, std::size_t bytes)
{
    stats.bytes += bytes;
    stats.peak_bytes = std::max(stats.peak_bytes, stats.bytes);
    stats.total_bytes += bytes;
    ++stats.blocks;
    ++stats.allocations;
}

inline void count_deallocation(MemoryStats& stats, std::size_t bytes)
{
    stats.bytes -= bytes;
    --stats.blocks;
}

/// The resource that null stands for.
inline std::pmr::memory_resource* or_default(std::pmr::memory_resource* resource)
{
    return resource ? resource : std::pmr::get_default_resource();
}

/// Throws an error; without exceptions, prints it and ends the program.
template <class Error, class... Arguments>
[[noreturn]] void raise(const Arguments&... arguments)
{
#ifdef __cpp_exceptions
    throw Error(arguments...);
#else
    std::fputs(Error(arguments...).what(), stderr);
    std::abort();
#endif
}

} // namespace carom::detail
