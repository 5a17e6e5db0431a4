// Whether other shapes than its two may change a contact.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/shape_store.hpp"

namespace carom::detail
{

inline Neighborhood neighborhood_of(const Contact& contact, const BodyStore& bodies, const ShapeStore& shapes)
{
    const ShapeRecord& a = shapes.records[contact.shape_a];
    const ShapeRecord& b = shapes.records[contact.shape_b];
    if (a.is_one_sided || b.is_one_sided) return Neighborhood::Shared;
    const auto is_alone = [&](std::uint32_t body) { return bodies.is_dynamic(body) && bodies.records[body].shape_count == 1; };
    const auto is_ground = [&](const ShapeRecord& shape) { return !bodies.is_dynamic(shape.body) && shape.chain == null_index; };
    const bool a_is_alone = is_alone(contact.body_a);
    const bool b_is_alone = is_alone(contact.body_b);
    if (a_is_alone && b_is_alone) return Neighborhood::Empty;
    if ((a_is_alone && is_ground(b)) || (b_is_alone && is_ground(a))) return Neighborhood::Ground;
    return Neighborhood::Shared;
}

/// Whether a contact may be changed by what is around it: by inner edges of a surface of several shapes, or because a segment is one-sided. What
/// lies on a single piece of ground meets no inner edge: whatever is near it has a contact with it.
/// @param contact its neighbourhood is known
inline bool may_be_filtered(const Contact& contact, const BodyStore& bodies)
{
    if (contact.neighborhood != Neighborhood::Ground) return contact.neighborhood == Neighborhood::Shared;
    const std::uint32_t on_ground = bodies.is_dynamic(contact.body_a) ? contact.body_a : contact.body_b;
    return bodies.records[on_ground].ground_contacts > 1;
}

} // namespace carom::detail
