// Public ids of what lies in a store.
#pragma once

#include "dynamics/slot_pool.hpp"

#include <cstdint>

namespace carom::detail
{

/// @param world the number that its ids carry
template <class Id, class Store>
Id id_of(const Store& store, std::uint32_t slot, std::uint32_t world)
{
    return {.index = slot, .generation = store.slots.generation(slot), .world = world};
}

/// Null where there is nothing, as for the body of a joint to the world itself.
template <class Id, class Store>
Id id_or_null(const Store& store, std::uint32_t slot, std::uint32_t world)
{
    return slot == null_index ? Id{} : id_of<Id>(store, slot, world);
}

} // namespace carom::detail
