// Takes contacts in and out of the solver, and out of the world, as their manifolds say.
#include "step/update_contacts.hpp"

#include "dynamics/narrow_phase.hpp"
#include "edit/edits.hpp"
#include "edit/wake.hpp"
#include "solver/rows/graph_colors.hpp"
#include "step/pre_solve.hpp"

#include <cstddef>
#include <span>

namespace carom::detail
{

namespace
{

bool are_dynamic(const WorldState& world, const Contact& pair)
{
    return world.bodies.is_dynamic(pair.body_a) && world.bodies.is_dynamic(pair.body_b);
}

/// Two sleepers touch: from now on they are one island.
void join_sleepers(WorldState& world, std::uint32_t contact)
{
    const Contact& pair = world.contacts.contacts[contact];
    if (are_dynamic(world, pair) && !is_felt(world, pair)) world.islands.link(pair.body_a, pair.body_b, world.bodies);
}

/// The solver takes in what is felt, and wakes whom it touches.
void take_in(WorldState& world, std::uint32_t contact)
{
    const Contact& pair = world.contacts.contacts[contact];
    if (pair.color != no_color || !is_felt(world, pair)) return;
    wake_body(world, pair.body_a);
    wake_body(world, pair.body_b);
    give_color(contact, world.contacts, world.bodies);
    if (are_dynamic(world, pair)) world.islands.link(pair.body_a, pair.body_b, world.bodies);
}

/// Takes out what has ended. Everybody left has been looked at.
void end_contacts(WorldState& world, const ContactChanges& changes)
{
    for (const std::uint32_t contact : changes.lost_points)
    {
        const Contact& pair = world.contacts.contacts[contact];
        take_color(contact, world.contacts, world.bodies);
        world.islands.unlink(pair.body_a, pair.body_b, world.bodies);
    }
    for (const std::uint32_t contact : changes.separated) destroy_contact(world, contact);
}

/// Contacts of those that are woken come behind all others in the list of awake ones.
void begin_contacts(WorldState& world, std::span<const std::uint32_t> gained_points)
{
    // Sleepers first, so that whoever of them is hit brings the others along.
    for (const std::uint32_t contact : gained_points) join_sleepers(world, contact);
    for (const std::uint32_t contact : gained_points) take_in(world, contact);
    // What was between sleepers above may be between bodies that have just woken.
    for (const std::uint32_t contact : gained_points) take_in(world, contact);
}

} // namespace

void update_contacts(WorldState& world)
{
    ContactChanges changes(world.arena);
    for (std::size_t first = 0; first < world.contacts.awake.size();)
    {
        update_manifolds(world.bodies, world.shapes, world.contacts, first, changes);
        ask_pre_solve(world, first, changes);
        end_contacts(world, changes);
        first = world.contacts.awake.size();
        begin_contacts(world, changes.gained_points);
    }
}

} // namespace carom::detail
