// Names for the things that a world holds. An id stays safe after its thing is gone: a stale one is always detected.
#pragma once

#include <compare>
#include <cstdint>

namespace carom
{

/// The name of one thing in one world. The default is null. A place that is used again gets a new generation, and a
/// place whose generations are used up is never used again, so an id can't come to name something else.
template <class Tag>
struct Id
{
    std::uint32_t index = 0;      ///< place in the world's store
    std::uint32_t generation = 0; ///< which tenant of that place; 0 is null
    std::uint32_t world = 0;      ///< which world

    constexpr explicit operator bool() const { return generation != 0; }
    friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

using BodyId = Id<struct BodyTag>;
using ShapeId = Id<struct ShapeTag>;
using FieldId = Id<struct FieldTag>;
using JointId = Id<struct JointTag>;
using ChainId = Id<struct ChainTag>;

} // namespace carom
