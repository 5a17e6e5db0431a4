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

/// Whether a contact ties two bodies that move to each other.
bool are_dynamic(const BodyStore& bodies, const Contact& pair) { return bodies.is_dynamic(pair.body_a) && bodies.is_dynamic(pair.body_b); }

bool is_felt(const ContactStage& stage, const Contact& pair) { return is_felt(stage.graph.bodies, stage.shapes, pair, stage.step_count); }

/// Two sleepers touch: from now on they are one island.
void join_sleepers(const ContactStage& stage, std::uint32_t contact)
{
    auto& [bodies, contacts, joints, islands] = stage.graph;
    const Contact& pair = contacts.contacts[contact];
    if (are_dynamic(bodies, pair) && !is_felt(stage, pair)) islands.link(pair.body_a, pair.body_b, bodies);
}

/// The solver takes in what is felt, and wakes whom it touches.
void take_in(const ContactStage& stage, std::uint32_t contact)
{
    auto& [bodies, contacts, joints, islands] = stage.graph;
    const Contact& pair = contacts.contacts[contact];
    if (pair.color != no_color || !is_felt(stage, pair)) return;
    wake_body(stage.graph, pair.body_a);
    wake_body(stage.graph, pair.body_b);
    give_color(contact, contacts, bodies);
    if (are_dynamic(bodies, pair)) islands.link(pair.body_a, pair.body_b, bodies);
}

/// Takes out what has ended. Everybody left has been looked at.
void end_contacts(const ContactStage& stage, const ContactChanges& changes)
{
    auto& [bodies, contacts, joints, islands] = stage.graph;
    for (const std::uint32_t contact : changes.lost_points)
    {
        const Contact& pair = contacts.contacts[contact];
        take_color(contact, contacts, bodies);
        islands.unlink(pair.body_a, pair.body_b, bodies);
    }
    for (const std::uint32_t contact : changes.separated)
        end_contact(stage.graph, stage.shapes, stage.pairs, stage.events, stage.rules.world, contact);
}

/// Contacts of those that are woken come behind all others in the list of awake ones.
void begin_contacts(const ContactStage& stage, std::span<const std::uint32_t> gained_points)
{
    // Sleepers first, so that whoever of them is hit brings the others along.
    for (const std::uint32_t contact : gained_points) join_sleepers(stage, contact);
    for (const std::uint32_t contact : gained_points) take_in(stage, contact);
    // What was between sleepers above may be between bodies that have just woken.
    for (const std::uint32_t contact : gained_points) take_in(stage, contact);
}

} // namespace

void update_contacts(const ContactStage& stage, std::pmr::memory_resource& scratch)
{
    auto& [bodies, contacts, joints, islands] = stage.graph;
    ContactChanges changes(scratch);
    for (std::size_t first = 0; first < contacts.awake.size();)
    {
        update_manifolds(stage.passes, bodies, stage.shapes, contacts, first, changes);
        ask_pre_solve(bodies, stage.shapes, contacts, stage.rules, first, changes);
        end_contacts(stage, changes);
        first = contacts.awake.size();
        begin_contacts(stage, changes.gained_points);
    }
}

} // namespace carom::detail
