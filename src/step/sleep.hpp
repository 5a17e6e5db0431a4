// The stage of a step that puts islands to sleep.
#pragma once

#include "state/world_state.hpp"

namespace carom::detail
{

/// Puts islands to sleep that have been slow for long enough, and takes apart one that no longer hangs together.
void put_islands_to_sleep(WorldState& world);

/// Whether bodies fall asleep at all.
bool lets_sleep(const WorldState& world);

} // namespace carom::detail
