// Calls the geometry's collide() for each contact with what it remembers of the last time, and matches new points with old ones.
#include "dynamics/narrow_phase.hpp"

#include "dynamics/internal_edges.hpp"
#include "dynamics/known_contacts.hpp"
#include "dynamics/neighborhood.hpp"
#include "dynamics/note_state.hpp"
#include "dynamics/one_sided.hpp"
#include "dynamics/write_points.hpp"
#include "geometry/distance.hpp"
#include "geometry/extent.hpp"
#include "geometry/manifold.hpp"
#include "memory/fetch_lines.hpp"
#include "memory/floats_of.hpp"

#include <algorithm>
#include <bit>
#include <span>

namespace carom::detail
{

namespace
{

/// Looks at the surroundings of a contact when they are not known.
void know_neighborhood(Contact& contact, const BodyStore& bodies, const ShapeStore& shapes)
{
    if (contact.neighborhood == Neighborhood::Unknown) contact.neighborhood = neighborhood_of(contact, bodies, shapes);
}

/// Collides two shapes.
/// @param is_known whether what is remembered of them holds
/// @param face_pair set where the memory says so
LocalManifold collide_shapes(const Contact& contact, CollisionMemory& memory, FacePair<float>& face_pair, bool is_known,
                             const Transform& b_in_a, const ShapeStore& shapes)
{
    const Geometry& a = shapes.geometry[contact.shape_a];
    const Geometry& b = shapes.geometry[contact.shape_b];
    FaceSearch search = is_known ? known_faces(memory) : FaceSearch{};
    const LocalManifold local = collide(a, b, b_in_a, shapes.tolerances.speculative_distance, shapes.tolerances, search);
    if (is_known && search.gap == 0) return local;
    if (spares_no_search(search))
    {
        memory.result = CollisionMemory::Result::Nothing;
        memory.has_face_pair = false;
        return local;
    }
    memory = remember(search, {a, shapes.extents[contact.shape_a]}, {b, shapes.extents[contact.shape_b]}, b_in_a);
    if (memory.result == CollisionMemory::Result::Faces && face_each_other(search))
    {
        const FacingFaces faces = facing_faces(a, b, search);
        memory.has_face_pair = true;
        memory.features = faces.features;
        face_pair = faces.pair;
    }
    return local;
}

void collide_pair(std::uint32_t slot, const BodyStore& bodies, const ShapeStore& shapes, ContactStore& contacts)
{
    Contact& contact = contacts.contacts[slot];
    ContactManifold& manifold = contacts.manifolds[slot];
    const BodyPose& pose_a = bodies.poses[contact.body_a];
    const BodyPose& pose_b = bodies.poses[contact.body_b];
    const Transform b_in_a = relative(pose_a.transform, pose_b.transform);
    CollisionMemory& memory = contacts.memories[slot];
    const bool is_known = holds(memory, b_in_a);
    const bool are_apart = is_known && memory.result == CollisionMemory::Result::Gap;
    const LocalManifold alone =
        are_apart ? LocalManifold{} : collide_shapes(contact, memory, contacts.face_pairs[slot], is_known, b_in_a, shapes);
    if (!may_be_filtered(contact, bodies)) return write(manifold, alone, pose_a, pose_b);
    const LocalManifold in_front = keep_front(alone, contact, bodies, shapes);
    write(manifold, without_internal_edges(in_front, contact, bodies, shapes, contacts), pose_a, pose_b);
}

bool overlap_pair(const Contact& contact, const BodyStore& bodies, const ShapeStore& shapes)
{
    const Transform b_in_a = relative(bodies.poses[contact.body_a].transform, bodies.poses[contact.body_b].transform);
    return overlap(shapes.geometry[contact.shape_a], shapes.geometry[contact.shape_b], b_in_a, shapes.tolerances);
}

/// @param place in the list of awake contacts
void update_contact(std::size_t place, bool may_have_points, const BodyStore& bodies, const ShapeStore& shapes, ContactStore& contacts)
{
    const std::uint32_t slot = contacts.awake[place];
    Contact& contact = contacts.contacts[slot];
    ContactManifold& manifold = contacts.manifolds[slot];
    know_neighborhood(contact, bodies, shapes);
    const bool had_result = manifold.has_result;
    if (!may_have_points)
    {
        manifold.count = 0;
        manifold.has_result = false;
        if (!contact.is_sensor && contact.neighborhood == Neighborhood::Shared)
            keep_front({}, contact, bodies, shapes); // which side it is on is looked at all the same
    }
    else if (contact.is_sensor)
        manifold.count = overlap_pair(contact, bodies, shapes) ? 1 : 0;
    else
        collide_pair(slot, bodies, shapes, contacts);

    note_state(slot, had_result, shapes.tolerances.linear_slop, contacts);
    const bool is_idle = manifold.count == 0 && contact.color == no_color && !contact.is_touching && !contact.is_hitting &&
                         contact.neighborhood != Neighborhood::Shared;
    contacts.awake_pairs[place].is_idle = is_idle ? 1 : 0;
}

void note_change(const Contact& contact, const ContactManifold& manifold, std::uint32_t slot, ContactChanges& changes)
{
    const bool has_points = manifold.count > 0;
    const bool has_color = contact.color != no_color;
    if (has_points && !has_color && !contact.is_sensor) changes.gained_points.push_back(slot);
    if (!has_points && has_color) changes.lost_points.push_back(slot);
}

/// So many contacts are looked at before the first of them is updated: by then its lines have come from memory, and those whose faces are known
/// are updated several at once.
constexpr std::size_t block_size = touch_batch;

/// A block of the list of awake contacts: a contact a bit.
struct Block
{
    std::size_t begin; ///< of the list
    std::size_t count;
    std::uint64_t are_separated = 0; ///< the fat bounds have parted
    std::uint64_t are_near = 0;      ///< the tight ones are no farther apart than contacts are made
    std::uint64_t are_meant = 0;     ///< have to be updated
};

/// action(place) for each bit of a mask.
template <class Action>
void for_each_bit(std::uint64_t bits, Action&& action)
{
    for (; bits != 0; bits &= bits - 1) action(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Compares the bounds of the contacts in a block.
/// @param bounds room for it
void look_at_bounds(const TouchPasses& passes, const ContactStore& contacts, BoundsBatch& bounds, Block& block)
{
    std::uint64_t are_idle = 0;
    bounds.count = block.count;
    for (std::size_t i = 0; i < block.count; ++i)
    {
        const AwakePair& pair = contacts.awake_pairs[block.begin + i];
        bounds.shapes_a[i] = pair.shape_a;
        bounds.shapes_b[i] = pair.shape_b;
        are_idle |= std::uint64_t{pair.is_idle} << i;
    }
    const BoundsResults results = passes.compare_bounds(bounds);
    const std::uint64_t all = ~std::uint64_t{0} >> (block_size - block.count);
    block.are_separated = results.are_separated & all;
    block.are_near = ~(results.are_apart | results.are_separated) & all;
    block.are_meant = block.are_separated | block.are_near | (~are_idle & all);
}

void fetch_lines_of(const Block& block, const ContactStore& contacts)
{
    for_each_bit(block.are_meant, [&](std::size_t i) { fetch_lines(contacts.contacts[contacts.awake[block.begin + i]]); });
    for_each_bit(block.are_near, [&](std::size_t i)
    {
        const std::uint32_t slot = contacts.awake[block.begin + i];
        fetch_lines(contacts.memories[slot]);
        fetch_lines(contacts.face_pairs[slot]);
        fetch_lines(contacts.manifolds[slot]);
    });
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
    manifold.impulses = {};
}

void update_manifolds(const TouchPasses& passes, const BodyStore& bodies, const ShapeStore& shapes, ContactStore& contacts,
                      std::size_t first, ContactChanges& changes)
{
    changes.clear();
    const float margin = shapes.tolerances.speculative_distance;
    BoundsBatch bounds = {.bounds = floats_of(shapes.bounds), .margin = margin};
    KnownContacts known(passes, touch_limits(margin, shapes.tolerances), shapes.tolerances.linear_slop);
    for (std::size_t begin = first; begin < contacts.awake.size(); begin += block_size)
    {
        Block block = {begin, std::min(block_size, contacts.awake.size() - begin)};
        look_at_bounds(passes, contacts, bounds, block);
        fetch_lines_of(block, contacts);
        for_each_bit(block.are_near, [&](std::size_t i) { known.add(i, contacts.awake[begin + i], bodies, contacts); });
        for_each_bit(block.are_meant & ~known.update(bodies, contacts), [&](std::size_t i)
        {
            const std::uint32_t slot = contacts.awake[begin + i];
            if ((block.are_separated >> i & 1) != 0) return changes.separated.push_back(slot);
            update_contact(begin + i, (block.are_near >> i & 1) != 0, bodies, shapes, contacts);
            note_change(contacts.contacts[slot], contacts.manifolds[slot], slot, changes);
        });
    }
}

} // namespace carom::detail
