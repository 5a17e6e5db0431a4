// How a contact that has just been updated stands with the later stages of the step.
#pragma once

#include "dynamics/contact_store.hpp"

namespace carom::detail
{

/// Events are quiet where nothing can begin, end or be told, whatever the solver does.
inline AwakeState state_of(const Contact& contact, const ContactManifold& manifold, float slop)
{
    if (manifold.count == 0) return {.bucket = no_bucket, .is_quiet = !contact.is_touching && !contact.is_hitting};
    const bool is_second_near = manifold.count == 2 && manifold.separation[1] <= slop;
    const bool is_near = manifold.separation[0] <= slop || is_second_near || contact.is_sensor;
    return {.bucket = bucket_of(contact.color, manifold.count), .is_quiet = is_near && contact.is_touching && !contact.is_watched};
}

/// Notes the state of an awake contact, and keeps the impulses of the last step where it may end.
/// @param had_result whether the manifold had one before it was updated
/// @param slop       Tolerances::linear_slop [m]
inline void note_state(std::uint32_t slot, bool had_result, float slop, ContactStore& contacts)
{
    const Contact& contact = contacts.contacts[slot];
    ContactManifold& manifold = contacts.manifolds[slot];
    const AwakeState state = state_of(contact, manifold, slop);
    contacts.awake_states[contact.place_in_awake] = state;
    if (contact.is_touching && !state.is_quiet) manifold.last = had_result ? sum_of(contacts.results[slot]) : ContactImpulse{};
}

} // namespace carom::detail
