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

/// A row with restitution, and what tells in each round of bounces whether it must be looked at: rows themselves lie far apart.
template <class F>
struct BouncyRow
{
    BodyIndices<F> pushed_a; ///< as in the row where there is restitution, else 0
    BodyIndices<F> pushed_b;
    std::uint32_t row;
    bool may_bounce;
};

/// Lists the rows with restitution from `begin` to before `end`.
/// @param bouncy room for as many BouncyRow<F>
/// @return how many there are
using BouncyPass = std::size_t (*)(const void* rows, std::size_t begin, std::size_t end, void* bouncy);

/// What a round of bounces knows besides.
struct BounceRound
{
    const float* falls; ///< by motion index, fall_floats each
    float* struck;      ///< by motion index: the last round, from 1, in which the body was struck
    float round;
};

/// Acceleration by gravity and forces along x and y [m/s^2], and what continuous collision has set back [m].
inline constexpr std::size_t fall_floats = 4;

/// @return whether anything bounced
using BouncePass = bool (*)(void* rows, const void* bouncy, std::size_t count, float* motions, const PassConstants<float>& constants,
                            const BounceRound& round);

/// Of rows with as many points as one another.
struct ContactPasses
{
    FillPass fill;
    ContactPass warm_start;
    ContactPass solve;
    ContactPass relax;
    BouncyPass list_bouncy;
    BouncePass bounce;
    StorePass store;
};

} // namespace carom::detail
