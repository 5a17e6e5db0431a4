// Equality that tells -0 from 0: for tests that lanes of every width give the same numbers.
#pragma once

#include <bit>
#include <cstdint>

namespace carom::detail
{

inline bool same_bits(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }

} // namespace carom::detail
