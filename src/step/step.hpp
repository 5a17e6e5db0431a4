// One step of a world.
#pragma once

#include "state/world_state.hpp"

namespace carom::detail
{

/// @param dt    [s]; 0 moves nothing
/// @param probe null for none
StepReport step(WorldState& world, float dt, int substeps, StepProbe* probe = nullptr);

} // namespace carom::detail
