// Sorting by an integer key in linear time; stable, so equal keys keep their order on every machine.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace carom::detail
{

struct SortKey
{
    std::uint32_t key;
    std::uint32_t index; ///< what is sorted
};

/// @param keys     sorted in place
/// @param scratch  as long as keys
/// @param key_bits bits of the keys that may be set
inline void radix_sort(std::span<SortKey> keys, std::span<SortKey> scratch, int key_bits)
{
    std::span<SortKey> from = keys;
    std::span<SortKey> to = scratch.first(keys.size());
    for (int shift = 0; shift < key_bits; shift += 8)
    {
        std::array<std::uint32_t, 257> starts = {};
        for (const SortKey& k : from) ++starts[(k.key >> shift & 255) + 1];
        for (std::size_t i = 1; i < starts.size(); ++i) starts[i] += starts[i - 1];
        for (const SortKey& k : from) to[starts[k.key >> shift & 255]++] = k;
        std::swap(from, to);
    }
    if (from.data() != keys.data()) std::copy(from.begin(), from.end(), keys.begin());
}

} // namespace carom::detail
