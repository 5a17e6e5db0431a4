// The passes of the narrow phase, once for each instruction set. As in solver/isa/, only raw pointers and plain numbers cross from code that
// every machine can run to code that some can.
#pragma once

#include "geometry/kernels/known_faces.hpp"

#include <carom/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace carom::detail
{

/// So many contacts fit into a batch: one for each bit of a mask.
inline constexpr std::size_t touch_batch = 64;

/// Floats of a shape's bounds: the tight ones and the fat ones.
inline constexpr std::size_t bounds_floats = 8;

/// Pairs of shapes whose bounds are compared.
struct BoundsBatch
{
    const float* bounds = nullptr; ///< by shape
    float margin = 0;              ///< of the tight ones [m]
    std::size_t count = 0;
    std::uint32_t shapes_a[touch_batch] = {};
    std::uint32_t shapes_b[touch_batch] = {};
};

/// A pair a bit; those behind the last pair mean nothing.
struct BoundsResults
{
    std::uint64_t are_separated; ///< the fat ones have parted
    std::uint64_t are_apart;     ///< the tight ones are farther apart than the margin
};

/// Floats of a pose, of a search and of a pair of faces, in the order of LanePose, SearchedAt and FacePair.
inline constexpr std::size_t pose_floats = 8;
inline constexpr std::size_t search_floats = 8;
inline constexpr std::size_t face_pair_floats = 16;

/// Contacts of shapes with faces that are known and face each other.
struct TouchBatch
{
    const float* poses = nullptr;              ///< by body
    const float* searches = nullptr;           ///< by contact
    std::size_t search_stride = search_floats; ///< [floats]
    const float* face_pairs = nullptr;         ///< by contact
    TouchLimits limits = {};
    std::size_t count = 0;
    std::uint32_t contacts[touch_batch] = {};
    std::uint32_t bodies_a[touch_batch] = {};
    std::uint32_t bodies_b[touch_batch] = {};
};

/// One or two points in the world.
struct TouchRow
{
    float arms[8]; ///< from A's and from B's centre of mass to each point [m]
    float normal[2];
    float separation[2]; ///< [m]
};

/// A contact a row and a bit.
struct TouchResults
{
    TouchRow rows[touch_batch];
    std::uint64_t are_known;  ///< that the contact is this; where it is not, the rest means nothing
    std::uint64_t have_lower; ///< the point at the start of the reference face is one
    std::uint64_t have_upper; ///< so is that at its end. When only this one is, it comes first
    std::uint64_t references_are_b;
};

/// The lists of a batch are filled up to a whole number of lanes.
struct TouchPasses
{
    BoundsResults (*compare_bounds)(BoundsBatch& batch);
    void (*touch)(TouchBatch& batch, TouchResults& results);
};

const TouchPasses& scalar_touch_passes();
const TouchPasses& four_lane_touch_passes();
#if defined(__x86_64__)
const TouchPasses& avx2_touch_passes();
#endif

/// The arithmetic is over before sixteen lanes are full: where they are asked for, eight are used.
/// @param simd available, and not Best
const TouchPasses& touch_passes_of(Simd simd);

} // namespace carom::detail
