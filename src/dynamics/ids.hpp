// Public ids of what lies in a store.
#pragma once

#include <cstdint>

namespace carom::detail
{

/// @param world the number that its ids carry
template <class Id, class Store>
Id id_of(const Store& store, std::uint32_t slot, std::uint32_t world)
{
    return {.index = slot, .generation = store.slots.generation(slot), .world = world};
}

} // namespace carom::detail
