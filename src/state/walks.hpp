// The linked lists of a world, walked.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/island_store.hpp"
#include "dynamics/joint_store.hpp"

namespace carom::detail
{

/// action(contact, the other body) for every contact of a body, which may end that contact.
template <class Action>
void for_each_contact(const BodyStore& bodies, const ContactStore& contacts, std::uint32_t body, Action&& action)
{
    for (std::uint32_t edge = bodies.records[body].first_contact; edge != null_index;)
    {
        const Contact& contact = contacts.contacts[edge / 2];
        const std::uint32_t next = contact.next[edge % 2];
        action(edge / 2, edge % 2 == 0 ? contact.body_b : contact.body_a);
        edge = next;
    }
}

/// action(body) for every body that a joint ties to this one.
template <class Action>
void for_each_joined(const BodyStore& bodies, const JointStore& joints, std::uint32_t body, Action&& action)
{
    for (std::uint32_t edge = bodies.records[body].first_joint; edge != null_index; edge = joints.joints[edge / 2].next[edge % 2])
    {
        const Joint& joint = joints.joints[edge / 2];
        const std::uint32_t other = edge % 2 == 0 ? joint.body_b : joint.body_a;
        if (other != null_index) action(other);
    }
}

/// action(body) for every body of an island.
template <class Action>
void for_each_of_island(const BodyStore& bodies, const IslandStore& islands, std::uint32_t island, Action&& action)
{
    for (std::uint32_t body = islands[island].first_body; body != null_index; body = bodies.records[body].next_in_island) action(body);
}

} // namespace carom::detail
