// Numbers that a row kernel works on: `float` is one lane; a vector type of several lanes offers the same functions.
// A kernel uses only arithmetic operators, comparisons, and what stands here, so that it reads the same for every width. Nothing else is included:
// kernels are compiled for several instruction sets (solver/isa/), and an inline function of another header would come in several versions.
#pragma once

namespace carom::detail
{

/// What a kernel needs to know of its lane type.
template <class F>
struct LaneTraits;

template <>
struct LaneTraits<float>
{
    static constexpr int width = 1;
    using Mask = bool;
    using Double = double;
};

/// As many lanes of double precision, with arithmetic, comparisons and select.
template <class F>
using DoubleOf = typename LaneTraits<F>::Double;

/// Where a comparison of lanes holds.
template <class F>
using MaskOf = typename LaneTraits<F>::Mask;

template <class F>
inline constexpr int lane_width = LaneTraits<F>::width;

/// Lane by lane: where the mask is set the first, else the second.
inline float select(bool mask, float yes, float no) { return mask ? yes : no; }
/// Whether any lane of a mask is set.
inline bool any(bool mask) { return mask; }
/// The mask as bits, that of the first lane lowest.
inline unsigned mask_bits(bool mask) { return mask ? 1 : 0; }
inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
inline float lane_max(float a, float b) { return a > b ? a : b; }
inline float lane_min(float a, float b) { return a < b ? a : b; }
inline float lane_sqrt(float a) { return __builtin_sqrtf(a); }

inline double to_double(float f) { return f; }
/// To the nearest.
inline float to_single(double d) { return static_cast<float>(d); }

/// Lanes that lie one after the other in memory.
template <class F>
F load_lanes(const float* from)
{
    F lanes;
    __builtin_memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

/// One lane of a number, for gather and scatter.
inline float& lane(float& f, int) { return f; }
inline float lane(const float& f, int) { return f; }

} // namespace carom::detail
