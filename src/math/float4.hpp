// Four floats at once, by the compilers' vector extensions: SSE2 on any x86-64, NEON, WASM SIMD. Always four lanes, on every machine,
// so that sums over lanes give the same bits everywhere.
#pragma once

#include <cmath>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace carom::detail
{

using Float4 = float __attribute__((vector_size(16)));
using Int4 = int __attribute__((vector_size(16))); ///< also a mask: all bits of a lane, or none

inline Float4 load4(const float (&lanes)[4])
{
    Float4 v;
    std::memcpy(&v, lanes, sizeof v);
    return v;
}

inline Float4 splat4(float f) { return Float4{f, f, f, f}; }

/// Bit i is set where lane i of a mask is.
inline unsigned lane_bits(Int4 mask)
{
#if defined(__SSE2__)
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
    const Int4 bits = mask & Int4{1, 2, 4, 8};
    return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
}

/// Lane by lane the smaller; where a lane of either is not a number, that of b.
inline Float4 min4(Float4 a, Float4 b)
{
#if defined(__SSE2__)
    return reinterpret_cast<Float4>(_mm_min_ps(reinterpret_cast<__m128>(a), reinterpret_cast<__m128>(b)));
#else
    return a < b ? a : b;
#endif
}

/// Lane by lane the larger; where a lane of either is not a number, that of b.
inline Float4 max4(Float4 a, Float4 b)
{
#if defined(__SSE2__)
    return reinterpret_cast<Float4>(_mm_max_ps(reinterpret_cast<__m128>(a), reinterpret_cast<__m128>(b)));
#else
    return a > b ? a : b;
#endif
}

inline Float4 sqrt4(Float4 v)
{
#if defined(__SSE2__)
    return reinterpret_cast<Float4>(_mm_sqrt_ps(reinterpret_cast<__m128>(v)));
#else
    return Float4{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
#endif
}

/// Zero where the mask is not set, whatever the value, also where it is not a number.
inline Float4 zero_unless(Int4 mask, Float4 v) { return reinterpret_cast<Float4>(reinterpret_cast<Int4>(v) & mask); }

} // namespace carom::detail
