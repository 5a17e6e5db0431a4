// Gathers a block of contacts for the pass over known faces, and writes what it gives.
#include "dynamics/known_contacts.hpp"

#include "dynamics/write_points.hpp"

namespace carom::detail
{

static_assert(sizeof(BodyPose) == pose_floats * sizeof(float));
static_assert(offsetof(CollisionMemory, result) == search_floats * sizeof(float));
static_assert(sizeof(FacePair<float>) == face_pair_floats * sizeof(float));

std::uint8_t KnownContacts::add(std::uint32_t slot, const ContactStore& contacts)
{
    const Contact& contact = contacts.contacts[slot];
    const bool may_be_known = contacts.memories[slot].has_face_pair && contact.color != no_color &&
                              contact.neighborhood == Neighborhood::Empty && !contact.is_sensor;
    if (!may_be_known) return no_place;
    const std::size_t place = batch_.count++;
    batch_.contacts[place] = slot;
    batch_.bodies_a[place] = contact.body_a;
    batch_.bodies_b[place] = contact.body_b;
    return static_cast<std::uint8_t>(place);
}

void KnownContacts::write(ContactManifold& manifold, const CollisionMemory& memory, std::size_t place, Vec2 center_a) const
{
    const auto is_set = [&](std::uint64_t mask) { return (mask >> place & 1) != 0; };
    const bool has_two = is_set(results_.have_lower & results_.have_upper);
    const bool is_swapped = is_set(results_.references_are_b ^ ~results_.have_lower);
    match_points(manifold, has_two ? 2 : 1, {memory.features[is_swapped ? 1 : 0], memory.features[is_swapped ? 0 : 1]});
    const TouchRow& row = results_.rows[place];
    manifold.has_result = false;
    manifold.normal = {row.normal[0], row.normal[1]};
    manifold.center_a = center_a;
    const auto write_point = [&](std::size_t i)
    {
        const float* const arms = row.arms + 4 * i;
        manifold.arms[i] = {{arms[0], arms[1]}, {arms[2], arms[3]}};
        manifold.separation[i] = row.separation[i];
    };
    write_point(0);
    if (has_two) write_point(1);
}

void KnownContacts::update(const BodyStore& bodies, ContactStore& contacts)
{
    batch_.poses = &bodies.poses.data()->transform.p.x;
    batch_.searches = &contacts.memories.data()->made_at.p.x;
    batch_.search_stride = sizeof(CollisionMemory) / sizeof(float);
    batch_.face_pairs = &contacts.face_pairs.data()->a_v1.x;
    passes_.touch(batch_, results_);
    for (std::size_t i = 0; i < batch_.count; ++i)
    {
        const std::uint32_t slot = batch_.contacts[i];
        if ((results_.are_known >> i & 1) != 0)
            write(contacts.manifolds[slot], contacts.memories[slot], i, bodies.poses[batch_.bodies_a[i]].center);
    }
}

} // namespace carom::detail
