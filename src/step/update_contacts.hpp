// The stage of a step that brings contacts up to date: their points, whom they wake, who is in an island with whom, what the solver works on.
#pragma once

#include "state/world_state.hpp"

namespace carom::detail
{

/// Collides what is awake, and what that wakes in turn, so that an island which is hit is whole, and held together by its contacts, in the step
/// in which it is hit. Contacts between sleepers are looked at once, when they are new: they join the sleepers' islands, and wake no one.
void update_contacts(WorldState& world);

} // namespace carom::detail
