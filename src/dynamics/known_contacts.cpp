// Gathers a block of contacts for the pass over known faces, and writes what it gives.
#include "dynamics/known_contacts.hpp"

#include "dynamics/neighborhood.hpp"
#include "dynamics/note_state.hpp"
#include "dynamics/write_points.hpp"
#include "memory/floats_of.hpp"

namespace carom::detail
{

static_assert(sizeof(BodyPose) == pose_floats * sizeof(float));
static_assert(offsetof(CollisionMemory, result) == search_floats * sizeof(float));
static_assert(sizeof(FacePair<float>) == face_pair_floats * sizeof(float));

void KnownContacts::add(std::size_t place, std::uint32_t slot, const BodyStore& bodies, const ContactStore& contacts)
{
    const Contact& contact = contacts.contacts[slot];
    const bool may_be_known =
        contacts.memories[slot].has_face_pair && contact.color != no_color && !contact.is_sensor && !may_be_filtered(contact, bodies);
    if (!may_be_known) return;
    places_[batch_.count] = static_cast<std::uint8_t>(place);
    batch_.contacts[batch_.count] = slot;
    batch_.bodies_a[batch_.count] = contact.body_a;
    batch_.bodies_b[batch_.count] = contact.body_b;
    ++batch_.count;
}

inline void KnownContacts::write(ContactManifold& manifold, const CollisionMemory& memory, std::size_t i, Vec2 center_a) const
{
    const auto is_set = [&](std::uint64_t mask) { return (mask >> i & 1) != 0; };
    const bool has_two = is_set(results_.have_lower & results_.have_upper);
    const bool is_swapped = is_set(results_.references_are_b ^ ~results_.have_lower);
    match_points(manifold, has_two ? 2 : 1, {memory.features[is_swapped ? 1 : 0], memory.features[is_swapped ? 0 : 1]});
    const TouchRow& row = results_.rows[i];
    manifold.has_result = false;
    manifold.normal = {row.normal[0], row.normal[1]};
    manifold.center_a = center_a;
    const auto write_point = [&](std::size_t point)
    {
        const float* const arms = row.arms + 4 * point;
        manifold.arms[point] = {{arms[0], arms[1]}, {arms[2], arms[3]}};
        manifold.separation[point] = row.separation[point];
    };
    write_point(0);
    if (has_two) write_point(1);
}

std::uint64_t KnownContacts::update(const BodyStore& bodies, ContactStore& contacts)
{
    batch_.poses = floats_of(bodies.poses);
    batch_.searches = floats_of(contacts.memories);
    batch_.search_stride = sizeof(CollisionMemory) / sizeof(float);
    batch_.face_pairs = floats_of(contacts.face_pairs);
    passes_.touch(batch_, results_);
    std::uint64_t updated = 0;
    for (std::size_t i = 0; i < batch_.count; ++i)
    {
        if ((results_.are_known >> i & 1) == 0) continue;
        const std::uint32_t slot = batch_.contacts[i];
        updated |= std::uint64_t{1} << places_[i];
        const bool had_result = contacts.manifolds[slot].has_result;
        write(contacts.manifolds[slot], contacts.memories[slot], i, bodies.poses[batch_.bodies_a[i]].center);
        note_state(slot, had_result, slop_, contacts);
    }
    batch_.count = 0;
    return updated;
}

} // namespace carom::detail
