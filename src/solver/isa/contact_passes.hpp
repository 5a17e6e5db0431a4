// The passes over contact rows, once for each instruction set. Only what stands here crosses from code that every machine can run to code that
// some can: raw pointers and plain numbers.
#pragma once

#include "solver/kernels/contact_records.hpp"

#include <cstddef>
#include <cstdint>

namespace carom::detail
{

/// A pass over rows of one colour.
/// @param rows    ContactRow<F, N>, F with the lanes of the table; from `begin` to before `end`
/// @param motions see motion_floats
using ContactPass = void (*)(void* rows, std::size_t begin, std::size_t end, float* motions, const PassConstants<float>& constants);

/// Contacts and bodies that rows are filled from.
struct RowSource
{
    const float* manifolds;            ///< by contact slot, see ManifoldFloats
    const std::uint32_t* bodies;       ///< slots of the bodies of each contact, by contact slot
    std::size_t words_per_contact;     ///< between the bodies of one contact and those of the next
    const std::uint32_t* motion_index; ///< by body slot
    const float* masses;               ///< by motion index, see mass_floats
    const float* motions;              ///< see motion_floats
    FillConstants<float> fill;
    PassConstants<float> pass;
};

/// The contacts of rows of one colour.
struct RowContacts
{
    const std::uint32_t* slots;
    std::size_t count;
    std::size_t lanes; ///< how many lanes of a row to use: all, or one where contacts depend on each other
};

/// What some of a step's rows need besides the passes.
struct RowNeeds
{
    bool any_bounces; ///< whether any may bounce
    bool any_belts;   ///< whether a surface has a tangent speed
};

/// Fills rows that nothing has been written to. Free lanes of a last row push nothing.
using FillPass = RowNeeds (*)(void* rows, const RowContacts& contacts, const RowSource& source);

/// Contacts and bodies that results are written to.
struct ResultTarget
{
    float* manifolds;     ///< by contact slot, see ManifoldFloats
    float* results;       ///< by contact slot, see result_floats
    const float* is_calm; ///< by motion index: 1 for a body that is at rest, and for index 0; else 0
    bool* is_settling;    ///< of motion index 0; `watch_bytes` further on, that of the next
    std::size_t watch_bytes;
    StoreConstants<float> store;
};

/// Writes the results of rows. Bodies of contacts that are still coming up are marked as settling.
using StorePass = void (*)(const void* rows, std::size_t count, const ResultTarget& target);

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
    FillPass fill;
    ContactPass warm_start;
    ContactPass solve;
    ContactPass relax;
    BouncePass bounce;
    StorePass store;
};

} // namespace carom::detail
