// The passes over lists of masses, once for each instruction set. As in solver/isa/, only raw pointers and plain numbers cross from code that
// every machine can run to code that some can.
#pragma once

#include "fields/kernels/pull.hpp"

#include <carom/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace carom::detail
{

/// Masses that act on a few points near each other. What fills up the last eight pulls nothing.
struct PullList
{
    const float* body_x;
    const float* body_y;
    const float* body_pull;
    std::size_t bodies; ///< a multiple of eight
    const GroupBlock* groups;
    std::size_t group_blocks;
};

struct PullPasses
{
    /// The sum of all pulls at each target.
    /// @param around what the list does not hold
    /// @param targets, pulls x and y of each
    void (*sum)(const PullList& list, const LocalPull& around, const float* targets, std::size_t count, const PullLimits& limits,
                float* pulls);
    /// Adds groups to a series.
    /// @param groups group_floats of each
    /// @param which, count those that are meant
    void (*expand)(const float* groups, const std::uint32_t* which, std::size_t count, const PullLimits& limits, LocalPull& around);
};

const PullPasses& scalar_pull_passes();
const PullPasses& four_lane_pull_passes();
#if defined(__x86_64__)
const PullPasses& avx2_pull_passes();
#endif

/// A block has eight masses, so sixteen lanes would be half empty: where they are asked for, eight are used.
/// @param simd available, and not Best
const PullPasses& pull_passes_of(Simd simd);

} // namespace carom::detail
