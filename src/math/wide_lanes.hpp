// Lanes in the registers of an instruction set: 4 of SSE2, NEON or WASM, 8 of AVX2, 16 of AVX-512. Which of them there are depends on the flags of
// the file that includes this. Each operation gives the bits that `float` gives in math/lanes.hpp.
#pragma once

#include "math/lanes.hpp"

#include <cstddef>
#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace carom::detail
{

/// Registers as the compilers' vector extensions have them.
template <int Width>
struct Registers;

template <>
struct Registers<4>
{
    using Floats = float __attribute__((vector_size(16)));
    using Ints = int __attribute__((vector_size(16)));
    using Doubles = double __attribute__((vector_size(16)));
    using Longs = long long __attribute__((vector_size(16)));
};

template <>
struct Registers<8>
{
    using Floats = float __attribute__((vector_size(32)));
    using Ints = int __attribute__((vector_size(32)));
    using Doubles = double __attribute__((vector_size(32)));
    using Longs = long long __attribute__((vector_size(32)));
};

template <>
struct Registers<16>
{
    using Floats = float __attribute__((vector_size(64)));
    using Ints = int __attribute__((vector_size(64)));
    using Doubles = double __attribute__((vector_size(64)));
    using Longs = long long __attribute__((vector_size(64)));
};

/// `Width` floats.
template <int Width>
struct Lanes
{
    using Vector = typename Registers<Width>::Floats;

    Lanes() = default;
    explicit Lanes(float all)
    {
        for (int i = 0; i < Width; ++i) v[i] = all;
    }
    Lanes(Vector vector) : v(vector) {}

    Vector v;
};

/// Where a comparison holds: all bits of a lane are set, or none.
template <int Width>
struct LaneMask
{
    typename Registers<Width>::Ints v;
};

/// Two registers of doubles, the lower half of the lanes and the upper: `Width` in all.
template <int Width>
struct DoubleLanes
{
    using Half = typename Registers<Width>::Doubles;

    DoubleLanes() = default;
    explicit DoubleLanes(double all)
    {
        for (int i = 0; i < Width / 2; ++i) low[i] = high[i] = all;
    }
    DoubleLanes(Half low_half, Half high_half) : low(low_half), high(high_half) {}

    Half low;
    Half high;
};

template <int Width>
struct DoubleMask
{
    using Half = typename Registers<Width>::Longs;

    Half low;
    Half high;
};

template <int Width>
struct LaneTraits<Lanes<Width>>
{
    static constexpr int width = Width;
    using Mask = LaneMask<Width>;
    using Double = DoubleLanes<Width>;
};

template <int Width>
Lanes<Width> operator+(Lanes<Width> a, Lanes<Width> b)
{
    return a.v + b.v;
}
template <int Width>
Lanes<Width> operator-(Lanes<Width> a, Lanes<Width> b)
{
    return a.v - b.v;
}
template <int Width>
Lanes<Width> operator*(Lanes<Width> a, Lanes<Width> b)
{
    return a.v * b.v;
}
template <int Width>
Lanes<Width> operator/(Lanes<Width> a, Lanes<Width> b)
{
    return a.v / b.v;
}
template <int Width>
Lanes<Width> operator-(Lanes<Width> a)
{
    return -a.v;
}
template <int Width>
LaneMask<Width> operator>(Lanes<Width> a, Lanes<Width> b)
{
    return {a.v > b.v};
}
template <int Width>
LaneMask<Width> operator<(Lanes<Width> a, Lanes<Width> b)
{
    return {a.v < b.v};
}
template <int Width>
LaneMask<Width> operator&(LaneMask<Width> a, LaneMask<Width> b)
{
    return {a.v & b.v};
}
template <int Width>
LaneMask<Width> operator|(LaneMask<Width> a, LaneMask<Width> b)
{
    return {a.v | b.v};
}
template <int Width>
LaneMask<Width> operator!(LaneMask<Width> a)
{
    return {~a.v};
}
template <int Width>
Lanes<Width> select(LaneMask<Width> mask, Lanes<Width> yes, Lanes<Width> no)
{
    return mask.v ? yes.v : no.v;
}

template <int Width>
DoubleLanes<Width> operator+(const DoubleLanes<Width>& a, const DoubleLanes<Width>& b)
{
    return {a.low + b.low, a.high + b.high};
}
template <int Width>
DoubleLanes<Width> operator-(const DoubleLanes<Width>& a, const DoubleLanes<Width>& b)
{
    return {a.low - b.low, a.high - b.high};
}
template <int Width>
DoubleLanes<Width> operator*(const DoubleLanes<Width>& a, const DoubleLanes<Width>& b)
{
    return {a.low * b.low, a.high * b.high};
}
template <int Width>
DoubleLanes<Width> operator/(const DoubleLanes<Width>& a, const DoubleLanes<Width>& b)
{
    return {a.low / b.low, a.high / b.high};
}
template <int Width>
DoubleLanes<Width> operator-(const DoubleLanes<Width>& a)
{
    return {-a.low, -a.high};
}
template <int Width>
DoubleMask<Width> operator>(const DoubleLanes<Width>& a, const DoubleLanes<Width>& b)
{
    return {a.low > b.low, a.high > b.high};
}
template <int Width>
DoubleMask<Width> operator<(const DoubleLanes<Width>& a, const DoubleLanes<Width>& b)
{
    return {a.low < b.low, a.high < b.high};
}
template <int Width>
DoubleLanes<Width> select(const DoubleMask<Width>& mask, const DoubleLanes<Width>& yes, const DoubleLanes<Width>& no)
{
    return {mask.low ? yes.low : no.low, mask.high ? yes.high : no.high};
}

template <int Width>
DoubleLanes<Width> to_double(Lanes<Width> f)
{
#if defined(__SSE2__)
    if constexpr (Width == 4) return {_mm_cvtps_pd(f.v), _mm_cvtps_pd(_mm_movehl_ps(f.v, f.v))};
#endif
#if defined(__AVX2__)
    if constexpr (Width == 8) return {_mm256_cvtps_pd(_mm256_castps256_ps128(f.v)), _mm256_cvtps_pd(_mm256_extractf128_ps(f.v, 1))};
#endif
#if defined(__AVX512F__)
    if constexpr (Width == 16) return {_mm512_cvtps_pd(_mm512_castps512_ps256(f.v)), _mm512_cvtps_pd(_mm512_extractf32x8_ps(f.v, 1))};
#endif
    DoubleLanes<Width> d;
    for (int i = 0; i < Width / 2; ++i) d.low[i] = static_cast<double>(f.v[i]), d.high[i] = static_cast<double>(f.v[i + Width / 2]);
    return d;
}

template <int Width>
Lanes<Width> to_single(const DoubleLanes<Width>& d)
{
#if defined(__SSE2__)
    if constexpr (Width == 4) return _mm_movelh_ps(_mm_cvtpd_ps(d.low), _mm_cvtpd_ps(d.high));
#endif
#if defined(__AVX2__)
    if constexpr (Width == 8) return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm256_cvtpd_ps(d.low)), _mm256_cvtpd_ps(d.high), 1);
#endif
#if defined(__AVX512F__)
    if constexpr (Width == 16) return _mm512_insertf32x8(_mm512_castps256_ps512(_mm512_cvtpd_ps(d.low)), _mm512_cvtpd_ps(d.high), 1);
#endif
    Lanes<Width> f;
    for (int i = 0; i < Width / 2; ++i) f.v[i] = static_cast<float>(d.low[i]), f.v[i + Width / 2] = static_cast<float>(d.high[i]);
    return f;
}

template <int Width>
unsigned mask_bits(LaneMask<Width> mask)
{
#if defined(__SSE2__)
    if constexpr (Width == 4) return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask.v)));
#endif
#if defined(__AVX2__)
    if constexpr (Width == 8) return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask.v)));
#endif
#if defined(__AVX512F__)
    if constexpr (Width == 16) return static_cast<unsigned>(_mm512_movepi32_mask(reinterpret_cast<__m512i>(mask.v)));
#endif
    unsigned bits = 0;
    for (int i = 0; i < Width; ++i) bits |= mask.v[i] != 0 ? 1u << i : 0u;
    return bits;
}

template <int Width>
bool any(LaneMask<Width> mask)
{
    return mask_bits(mask) != 0;
}

// The instructions for the larger and the smaller give the second where either is not a number or both are zero, as `a > b ? a : b` does. A
// comparison and a blend in their place cost half of the speed.

template <int Width>
Lanes<Width> lane_max(Lanes<Width> a, Lanes<Width> b)
{
#if defined(__SSE2__)
    if constexpr (Width == 4) return _mm_max_ps(a.v, b.v);
#endif
#if defined(__AVX2__)
    if constexpr (Width == 8) return _mm256_max_ps(a.v, b.v);
#endif
#if defined(__AVX512F__)
    if constexpr (Width == 16) return _mm512_max_ps(a.v, b.v);
#endif
    return a.v > b.v ? a.v : b.v;
}

template <int Width>
Lanes<Width> lane_min(Lanes<Width> a, Lanes<Width> b)
{
#if defined(__SSE2__)
    if constexpr (Width == 4) return _mm_min_ps(a.v, b.v);
#endif
#if defined(__AVX2__)
    if constexpr (Width == 8) return _mm256_min_ps(a.v, b.v);
#endif
#if defined(__AVX512F__)
    if constexpr (Width == 16) return _mm512_min_ps(a.v, b.v);
#endif
    return a.v < b.v ? a.v : b.v;
}

template <int Width>
Lanes<Width> lane_sqrt(Lanes<Width> a)
{
#if defined(__SSE2__)
    if constexpr (Width == 4) return _mm_sqrt_ps(a.v);
#endif
#if defined(__AVX2__)
    if constexpr (Width == 8) return _mm256_sqrt_ps(a.v);
#endif
#if defined(__AVX512F__)
    if constexpr (Width == 16) return _mm512_sqrt_ps(a.v);
#endif
    Lanes<Width> root;
    for (int i = 0; i < Width; ++i) root.v[i] = __builtin_sqrtf(a.v[i]);
    return root;
}

template <int Width>
float lane(const Lanes<Width>& lanes, int i)
{
    return lanes.v[i];
}

#if defined(__SSE2__) && !defined(__AVX2__)

/// The first four floats of four bodies, and four columns of them: x of each, y of each, ...
template <class Tag>
struct Quad
{
    __m128 x, y, z, w;
};

/// Rows to columns.
template <class Tag>
Quad<Tag> transposed(Quad<Tag> q)
{
    const __m128 xy_01 = _mm_unpacklo_ps(q.x, q.y);
    const __m128 xy_23 = _mm_unpacklo_ps(q.z, q.w);
    const __m128 zw_01 = _mm_unpackhi_ps(q.x, q.y);
    const __m128 zw_23 = _mm_unpackhi_ps(q.z, q.w);
    return {_mm_movelh_ps(xy_01, xy_23), _mm_movehl_ps(xy_23, xy_01), _mm_movelh_ps(zw_01, zw_23), _mm_movehl_ps(zw_23, zw_01)};
}

#endif

#if defined(__AVX2__)

/// Eight floats of eight records, or their columns.
template <class Tag>
struct Octet
{
    __m256 f0, f1, f2, f3, f4, f5, f6, f7;
};

/// Rows to columns.
template <class Tag>
Octet<Tag> transposed(const Octet<Tag>& rows)
{
    // Pairs of rows: floats 0 and 1 (and 4 and 5), floats 2 and 3 (and 6 and 7).
    const __m256 lo_01 = _mm256_unpacklo_ps(rows.f0, rows.f1), hi_01 = _mm256_unpackhi_ps(rows.f0, rows.f1);
    const __m256 lo_23 = _mm256_unpacklo_ps(rows.f2, rows.f3), hi_23 = _mm256_unpackhi_ps(rows.f2, rows.f3);
    const __m256 lo_45 = _mm256_unpacklo_ps(rows.f4, rows.f5), hi_45 = _mm256_unpackhi_ps(rows.f4, rows.f5);
    const __m256 lo_67 = _mm256_unpacklo_ps(rows.f6, rows.f7), hi_67 = _mm256_unpackhi_ps(rows.f6, rows.f7);
    // Four rows a float: float k in the lower half, float k + 4 in the upper.
    constexpr int first = _MM_SHUFFLE(1, 0, 1, 0), second = _MM_SHUFFLE(3, 2, 3, 2);
    const __m256 f0_a = _mm256_shuffle_ps(lo_01, lo_23, first), f0_b = _mm256_shuffle_ps(lo_45, lo_67, first);
    const __m256 f1_a = _mm256_shuffle_ps(lo_01, lo_23, second), f1_b = _mm256_shuffle_ps(lo_45, lo_67, second);
    const __m256 f2_a = _mm256_shuffle_ps(hi_01, hi_23, first), f2_b = _mm256_shuffle_ps(hi_45, hi_67, first);
    const __m256 f3_a = _mm256_shuffle_ps(hi_01, hi_23, second), f3_b = _mm256_shuffle_ps(hi_45, hi_67, second);
    constexpr int lower = 0x20, upper = 0x31;
    return {_mm256_permute2f128_ps(f0_a, f0_b, lower), _mm256_permute2f128_ps(f1_a, f1_b, lower), _mm256_permute2f128_ps(f2_a, f2_b, lower),
            _mm256_permute2f128_ps(f3_a, f3_b, lower), _mm256_permute2f128_ps(f0_a, f0_b, upper), _mm256_permute2f128_ps(f1_a, f1_b, upper),
            _mm256_permute2f128_ps(f2_a, f2_b, upper), _mm256_permute2f128_ps(f3_a, f3_b, upper)};
}

/// @param stride of a record [floats]
template <class Tag>
Octet<Tag> gather_octet(const float* records, std::size_t stride, const std::uint32_t* indices)
{
    const auto record = [&](std::size_t i) { return _mm256_loadu_ps(records + stride * indices[i]); };
    return transposed<Tag>({record(0), record(1), record(2), record(3), record(4), record(5), record(6), record(7)});
}

#endif

} // namespace carom::detail
