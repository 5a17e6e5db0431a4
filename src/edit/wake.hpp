// Who sleeps and who wakes. Sleepers are not active: they have no motion index, no rows, and their contacts are looked at by nobody.
//
// A body sleeps with its whole island. A kinematic body is not in one: it sleeps while its velocity is zero, and while it moves, whatever it
// touches or is joined to stays awake.
#pragma once

#include "state/world_state.hpp"

namespace carom::detail
{

/// Makes a body, and its island with it, take part again. Does nothing to one that is awake, static or disabled.
void wake_body(const WakeGraph& graph, std::uint32_t body);
/// Puts a body, and its island with it, to sleep at once.
void put_body_to_sleep(const WakeGraph& graph, std::uint32_t body, std::uint64_t step_count);
/// Does nothing to one that sleeps.
void put_island_to_sleep(const WakeGraph& graph, std::uint32_t island);
void wake_all(const WakeGraph& graph);

/// Bodies that push each other: a contact between them has points.
bool is_push(const ContactStore& contacts, std::uint32_t contact);
bool is_moving(const BodyMotion& motion);
bool is_kinematic(const BodyStore& bodies, std::uint32_t body);

/// Whether a contact that has points wakes those of its bodies that sleep: one of the two is awake, or an edit has put ground upon the other. Two
/// sleepers leave each other alone, as do a sleeper and the ground that was there when it was put to sleep.
bool is_felt(const BodyStore& bodies, const ShapeStore& shapes, const Contact& contact, std::uint64_t step_count);

/// Wakes the body and whoever touches it or is joined to it: before a change that they would feel.
void wake_with_neighbors(const WakeGraph& graph, std::uint32_t body);
/// Has all contacts of a body looked at in the next step, though nobody in them may be awake.
void review_contacts(WorldState& world, std::uint32_t body);

/// The island of a body that begins or ends to be dynamic and enabled.
void refresh_island(BodyStore& bodies, IslandStore& islands, std::uint32_t body);

} // namespace carom::detail
