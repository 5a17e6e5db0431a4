// The passes over contact rows, once for each instruction set. Only what stands here crosses from code that every machine can run to code that
// some can: raw pointers and plain numbers.
#pragma once

#include "solver/kernels/contact_row.hpp"

#include <cstddef>
#include <cstdint>

namespace carom::detail
{

/// A pass over rows of one colour.
/// @param rows    ContactRow<F, N>, F with the lanes of the table; from `begin` to before `end`
/// @param motions see motion_floats
using ContactPass = void (*)(void* rows, std::size_t begin, std::size_t end, float* motions, const PassConstants<float>& constants);

/// The pass over rows that have just been filled.
/// @return whether any may bounce
using PreparePass = bool (*)(void* rows, std::size_t begin, std::size_t end, const float* motions, const PassConstants<float>& constants);

/// What a round of bounces knows besides.
struct BounceRound
{
    const float* falls;    ///< by motion index, 4 floats: acceleration by gravity and forces [m/s^2], set back by continuous collision [m]
    std::uint32_t* struck; ///< by motion index: the last round, from 1, in which the body was struck
    std::uint32_t round;
};

/// @return whether anything bounced
using BouncePass = bool (*)(void* rows, std::size_t begin, std::size_t end, float* motions, const PassConstants<float>& constants,
                            const BounceRound& round);

/// Of rows with as many points as one another.
struct ContactPasses
{
    PreparePass prepare;
    ContactPass warm_start;
    ContactPass solve;
    ContactPass relax;
    BouncePass bounce;
};

} // namespace carom::detail
