// Looks for faults of our own in a world: every list, store and island, each promise from scratch. Debug builds do it after each step.
#pragma once

#include "state/world_state.hpp"

#include <string>

namespace carom::detail
{

/// @return what is wrong, in words for us; empty when nothing is
std::string first_fault(const WorldState& world);

} // namespace carom::detail
