// Keeps every contact's manifold in step with where its bodies are.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/shape_store.hpp"
#include "geometry/isa/touch_passes.hpp"

#include <cstdint>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

/// Contacts whose standing with the solver is to change, each list in the order of the awake contacts. They are told by what the contact has, not by what it
/// had before, so that a step that ran out of memory is made up for by the next.
struct ContactChanges
{
    explicit ContactChanges(std::pmr::memory_resource& memory) : gained_points(&memory), lost_points(&memory), separated(&memory) {}

    std::pmr::vector<std::uint32_t> gained_points; ///< have some, and no colour yet: the solver takes them in; no sensors
    std::pmr::vector<std::uint32_t> lost_points;   ///< have none any more, but a colour
    std::pmr::vector<std::uint32_t> separated;     ///< the fat bounds no longer overlap: to be destroyed

    void clear();
};

/// Fills the lists of gained and lost points anew, after points were taken away.
/// @param first as of update_manifolds
void list_changes(const ShapeStore& shapes, const ContactStore& contacts, std::size_t first, ContactChanges& changes);
/// Whether the fat bounds have parted: the contact is about to go, and its points are old.
bool is_separated(const Contact& contact, const ShapeStore& shapes);

/// Starts a contact cold: its shapes are no longer those that made its points.
void forget_impulses(ContactManifold& manifold);

/// Collides the shapes of awake contacts; points made by the same features keep their impulses.
/// @param first where in the list of awake contacts to begin
/// @param passes of the world's instruction set
void update_manifolds(const TouchPasses& passes, const BodyStore& bodies, const ShapeStore& shapes, ContactStore& contacts,
                      std::size_t first, ContactChanges& changes);

} // namespace carom::detail
