// Who sleeps and who wakes. Sleepers are not active: they have no motion index, no rows, and their contacts are looked at by nobody.
#pragma once

#include "world/world_state.hpp"

namespace carom::detail
{

/// Makes a body, and its island with it, take part again. Does nothing to one that is awake, static or disabled.
void wake_body(WorldState& world, std::uint32_t body);
/// Puts a body, and its island with it, to sleep at once: the user's wish, not the stage's.
void put_body_to_sleep(WorldState& world, std::uint32_t body);
void wake_all(WorldState& world);

/// Whether a contact that has points wakes those of its bodies that sleep: one of the two is awake, or an edit has put ground upon the other. Two
/// sleepers leave each other alone, as do a sleeper and the ground that was there when it was put to sleep.
bool is_felt(const WorldState& world, const Contact& contact);

/// Wakes the body and whoever touches it or is joined to it: before a change that they would feel.
void wake_with_neighbors(WorldState& world, std::uint32_t body);
/// Has all contacts of a body looked at in the next step, though nobody in them may be awake.
void review_contacts(WorldState& world, std::uint32_t body);

/// The island of a body that begins or ends to be dynamic and enabled.
void refresh_island(WorldState& world, std::uint32_t body);

/// The stage of a step: puts islands to sleep that have been slow for long enough, and takes apart one that no longer hangs together.
void put_islands_to_sleep(WorldState& world);

} // namespace carom::detail
