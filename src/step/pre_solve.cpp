// What a hook changes lasts one step: the next one starts from what the materials give.
#include "step/pre_solve.hpp"

#include "dynamics/mix_materials.hpp"
#include "state/event_buffers.hpp"

#include <cmath>
#include <span>

namespace carom::detail
{

namespace
{

float approach_speed(const BodyStore& bodies, const Contact& contact, const ContactArms& arms, Vec2 normal)
{
    const Vec2 v_a = bodies.velocity(contact.body_a) + cross(bodies.spin(contact.body_a), arms.r_a);
    const Vec2 v_b = bodies.velocity(contact.body_b) + cross(bodies.spin(contact.body_b), arms.r_b);
    return -dot(v_b - v_a, normal);
}

PreSolve describe(const BodyStore& bodies, const ShapeStore& shapes, std::uint32_t world, const Contact& contact,
                  const ContactManifold& manifold, const ContactResult& result)
{
    PreSolve shown;
    shown.shape_a = shape_id(shapes, contact.shape_a, world);
    shown.shape_b = shape_id(shapes, contact.shape_b, world);
    shown.manifold = public_manifold(manifold, result);
    for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
        shown.manifold.points[i].approach_speed = approach_speed(bodies, contact, manifold.arms[i], manifold.normal);
    shown.was_touching = contact.is_touching;
    shown.friction = manifold.surface.friction;
    shown.restitution = manifold.surface.restitution;
    shown.rolling_resistance = manifold.surface.rolling_resistance;
    shown.tangent_speed = manifold.surface.tangent_speed;
    return shown;
}

/// Takes over what the hook changed, as far as it makes sense.
void apply(const PreSolve& wanted, ContactSurface& surface)
{
    if (is_friction(wanted.friction)) surface.friction = wanted.friction;
    if (is_restitution(wanted.restitution)) surface.restitution = wanted.restitution;
    if (is_friction(wanted.rolling_resistance)) surface.rolling_resistance = wanted.rolling_resistance;
    if (std::abs(wanted.tangent_speed) <= max_speed) surface.tangent_speed = wanted.tangent_speed;
}

} // namespace

void ask_pre_solve(const BodyStore& bodies, const ShapeStore& shapes, ContactStore& contacts, const ContactRules& rules, std::size_t first,
                   ContactChanges& changes)
{
    if (rules.hooks == nullptr) return;
    bool any_disabled = false;
    for (const std::uint32_t slot : std::span(contacts.awake).subspan(first))
    {
        Contact& contact = contacts.contacts[slot];
        ContactManifold& manifold = contacts.manifolds[slot];
        contact.is_disabled = false;
        if (contact.is_sensor || manifold.count == 0 || is_separated(contact, shapes)) continue;
        if (!shapes.records[contact.shape_a].pre_solve && !shapes.records[contact.shape_b].pre_solve) continue;

        if (contact.is_overridden) manifold.surface = mix_materials(contact, shapes, rules);
        PreSolve shown = describe(bodies, shapes, rules.world, contact, manifold, contacts.results[slot]);
        rules.hooks->pre_solve(shown);
        apply(shown, manifold.surface);
        contact.is_overridden = true;
        if (shown.is_enabled) continue;
        manifold.count = 0;
        contacts.refresh_bucket(slot);
        contact.is_disabled = true;
        any_disabled = true;
    }
    if (any_disabled) list_changes(shapes, contacts, first, changes);
}

} // namespace carom::detail
