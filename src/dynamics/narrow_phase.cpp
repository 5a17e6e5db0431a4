// Calls the geometry's collide() for each contact and matches new points with old ones.
#include "dynamics/narrow_phase.hpp"

#include "dynamics/internal_edges.hpp"
#include "dynamics/one_sided.hpp"
#include "geometry/distance.hpp"
#include "geometry/extent.hpp"
#include "geometry/manifold.hpp"

#include <span>

namespace carom::detail
{

namespace
{

/// The impulses of the old point that the same features made, or none.
void keep_impulses(ContactPointState& point, const ContactManifold& old)
{
    for (int i = 0; i < old.count; ++i)
    {
        const ContactPointState& before = old.points[static_cast<std::size_t>(i)];
        if (before.feature != point.feature) continue;
        point.normal_impulse = before.normal_impulse;
        point.tangent_impulse = before.tangent_impulse;
        return;
    }
}

ContactManifold collide_pair(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes, const ContactStore& contacts,
                             const ContactManifold& old)
{
    const BodyPose& pose_a = bodies.poses[contact.body_a];
    const BodyPose& pose_b = bodies.poses[contact.body_b];
    const Transform b_in_a = relative(pose_a.transform, pose_b.transform);
    const LocalManifold alone = collide(shapes.geometry[contact.shape_a], shapes.geometry[contact.shape_b], b_in_a, shapes.tolerances);
    const LocalManifold in_front = keep_front(alone, contact, bodies, shapes);
    const LocalManifold local = without_internal_edges(in_front, contact, bodies, shapes, contacts);

    ContactManifold manifold;
    manifold.count = local.count;
    manifold.normal = rotate(pose_a.transform.q, local.normal);
    if (local.count > 0)
    {
        manifold.rolling_impulse = old.rolling_impulse;
        manifold.carried_impulse = old.carried_impulse;
    }
    manifold.rounding_a = rounding(shapes.geometry[contact.shape_a]);
    manifold.rounding_b = rounding(shapes.geometry[contact.shape_b]);
    const Vec2 centers = pose_b.center - pose_a.center;
    for (std::size_t i = 0; i < static_cast<std::size_t>(local.count); ++i)
    {
        ContactPointState& point = manifold.points[i];
        point.r_a = rotate(pose_a.transform.q, local.points[i].position - pose_a.local_center);
        point.r_b = point.r_a - centers;
        point.position = pose_a.center + point.r_a;
        point.separation = local.points[i].separation;
        point.feature = local.points[i].feature;
        keep_impulses(point, old);
    }
    return manifold;
}

ContactManifold overlap_pair(const Contact& contact, const BodyStore& bodies, const ShapeStore& shapes)
{
    const Transform b_in_a = relative(bodies.poses[contact.body_a].transform, bodies.poses[contact.body_b].transform);
    ContactManifold manifold;
    manifold.count = overlap(shapes.geometry[contact.shape_a], shapes.geometry[contact.shape_b], b_in_a, shapes.tolerances) ? 1 : 0;
    return manifold;
}

void note_change(const Contact& contact, const ContactManifold& manifold, std::uint32_t slot, ContactChanges& changes)
{
    const bool has_points = manifold.count > 0;
    const bool has_color = contact.color != no_color;
    if (has_points && !has_color && !contact.is_sensor) changes.gained_points.push_back(slot);
    if (!has_points && has_color) changes.lost_points.push_back(slot);
}

} // namespace

void ContactChanges::clear()
{
    gained_points.clear();
    lost_points.clear();
    separated.clear();
}

void list_changes(const ShapeStore& shapes, const ContactStore& contacts, std::size_t first, ContactChanges& changes)
{
    changes.gained_points.clear();
    changes.lost_points.clear();
    for (const std::uint32_t slot : std::span(contacts.awake).subspan(first))
        if (!is_separated(contacts.contacts[slot], shapes)) note_change(contacts.contacts[slot], contacts.manifolds[slot], slot, changes);
}

bool is_separated(const Contact& contact, const ShapeStore& shapes)
{
    return !overlaps(shapes.bounds[contact.shape_a].fat, shapes.bounds[contact.shape_b].fat);
}

void forget_impulses(ContactManifold& manifold)
{
    manifold.rolling_impulse = manifold.carried_impulse = 0;
    for (ContactPointState& point : manifold.points) point.normal_impulse = point.tangent_impulse = 0;
}

void update_manifolds(const BodyStore& bodies, const ShapeStore& shapes, ContactStore& contacts, std::size_t first, ContactChanges& changes)
{
    changes.clear();
    for (const std::uint32_t slot : std::span(contacts.awake).subspan(first))
    {
        Contact& contact = contacts.contacts[slot];

        const ShapeBounds& a = shapes.bounds[contact.shape_a];
        const ShapeBounds& b = shapes.bounds[contact.shape_b];
        if (!overlaps(a.fat, b.fat))
        {
            changes.separated.push_back(slot);
            continue;
        }

        ContactManifold& manifold = contacts.manifolds[slot];
        const bool may_have_points = overlaps(expanded(a.tight, shapes.tolerances.speculative_distance), b.tight);
        if (!may_have_points)
        {
            manifold.count = 0;
            if (!contact.is_sensor) keep_front({}, contact, bodies, shapes); // which side it is on is looked at all the same
        }
        else if (contact.is_sensor)
            manifold = overlap_pair(contact, bodies, shapes);
        else
            manifold = collide_pair(contact, bodies, shapes, contacts, manifold);

        note_change(contact, manifold, slot, changes);
    }
}

} // namespace carom::detail
