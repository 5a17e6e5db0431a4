// The hash of a world's whole state: everything that the steps to come depend on, and nothing that only remembers how pairs were found.
#include "world/world_state.hpp"

#include <bit>

namespace carom
{

namespace
{

/// Takes in words one after the other; every word changes about half of the bits.
class Hasher
{
public:
    void add(std::uint64_t word)
    {
        state_ = (std::rotl(state_, 23) ^ word) * 0x9e3779b97f4a7c15ull;
        state_ ^= state_ >> 32;
    }
    void add(std::uint32_t word) { add(std::uint64_t{word}); }
    void add(int word) { add(static_cast<std::uint64_t>(word)); }
    void add(bool bit) { add(std::uint64_t{bit}); }
    void add(float value) { add(std::bit_cast<std::uint32_t>(value)); }
    void add(Vec2 v) { add(std::uint64_t{std::bit_cast<std::uint32_t>(v.x)} << 32 | std::bit_cast<std::uint32_t>(v.y)); }
    void add(Rot q) { add(Vec2{q.c, q.s}); }
    void add(const Aabb& box) { add(box.min), add(box.max); }
    void add(const MassData& mass) { add(mass.mass), add(mass.center), add(mass.inertia); }

    template <class... Values>
    void add_all(const Values&... values)
    {
        (add(values), ...);
    }

    std::uint64_t result() const { return state_; }

private:
    std::uint64_t state_ = 0x243f6a8885a308d3ull;
};

/// Who lives where, and in which order free places will be taken again.
void add_slots(Hasher& hasher, const detail::SlotPool& slots)
{
    hasher.add_all(slots.size(), slots.first_free());
    for (std::uint32_t slot = 0; slot < slots.size(); ++slot)
        hasher.add_all(slots.generation(slot), slots.is_live(slot), slots.is_live(slot) ? 0 : slots.next_free(slot));
}

void add_geometry(Hasher& hasher, const Geometry& geometry)
{
    hasher.add(static_cast<int>(geometry.index()));
    if (const auto* circle = std::get_if<Circle>(&geometry)) hasher.add_all(circle->center, circle->radius);
    if (const auto* capsule = std::get_if<Capsule>(&geometry)) hasher.add_all(capsule->p1, capsule->p2, capsule->radius);
    if (const auto* segment = std::get_if<Segment>(&geometry)) hasher.add_all(segment->p1, segment->p2);
    if (const auto* polygon = std::get_if<Polygon>(&geometry))
    {
        hasher.add_all(polygon->count, polygon->radius);
        for (std::size_t i = 0; i < static_cast<std::size_t>(polygon->count); ++i) hasher.add(polygon->vertices[i]);
    }
}

void add_bodies(Hasher& hasher, const detail::BodyStore& bodies)
{
    add_slots(hasher, bodies.slots);
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot)
    {
        if (!bodies.slots.is_live(slot)) continue;
        const detail::BodyRecord& body = bodies.records[slot];
        const detail::BodyPose& pose = bodies.poses[slot];
        const detail::BodyDrive& drive = bodies.drives[bodies.motion_index[slot]];
        hasher.add_all(static_cast<int>(body.type), body.is_enabled, body.is_attractor, body.has_mass_override);
        hasher.add_all(body.locks.x, body.locks.y, body.locks.rotation, body.linear_damping, body.angular_damping, body.gravity_scale);
        hasher.add_all(body.mass, body.shapes_mass, body.color_mask, bodies.motion_index[slot], body.first_shape, body.first_contact);
        hasher.add_all(pose.transform.p, pose.transform.q, pose.center, bodies.velocity(slot), bodies.spin(slot), drive.force,
                       drive.torque);
    }
}

void add_shapes(Hasher& hasher, const detail::ShapeStore& shapes)
{
    add_slots(hasher, shapes.slots);
    for (std::uint32_t slot = 0; slot < shapes.slots.size(); ++slot)
    {
        if (!shapes.slots.is_live(slot)) continue;
        const detail::ShapeRecord& shape = shapes.records[slot];
        hasher.add_all(shape.body, shape.next_of_body, shape.density, shape.is_sensor, shape.contact_events, shape.persist_events,
                       shape.sensor_events);
        hasher.add_all(shape.material.friction, shape.material.restitution, shape.material.rolling_resistance,
                       shape.material.tangent_speed);
        hasher.add_all(shape.filter.category, shape.filter.mask, static_cast<std::uint32_t>(shape.filter.group));
        hasher.add_all(shapes.bounds[slot].fat, shapes.place_in_moved[slot] != detail::null_index);
        add_geometry(hasher, shapes.geometry[slot]);
    }
}

void add_contacts(Hasher& hasher, const detail::ContactStore& contacts)
{
    add_slots(hasher, contacts.slots);
    for (std::uint32_t slot = 0; slot < contacts.slots.size(); ++slot)
    {
        const detail::Contact& contact = contacts.contacts[slot];
        if (!contact.is_live) continue;
        const detail::ContactManifold& manifold = contacts.manifolds[slot];
        hasher.add_all(contact.shape_a, contact.shape_b, int{contact.color}, contact.index_in_color, contact.is_touching);
        hasher.add_all(contact.next[0], contact.next[1]);
        hasher.add_all(contact.friction, contact.restitution, contact.rolling_resistance, contact.tangent_speed);
        hasher.add_all(manifold.count, manifold.normal, manifold.rolling_impulse, manifold.carried_impulse);
        for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
        {
            const detail::ContactPointState& point = manifold.points[i];
            hasher.add_all(point.feature, point.separation, point.normal_impulse, point.tangent_impulse);
        }
    }
}

void add_fields(Hasher& hasher, const detail::FieldStore& fields)
{
    add_slots(hasher, fields.slots);
    for (std::uint32_t slot = 0; slot < fields.slots.size(); ++slot)
    {
        if (!fields.slots.is_live(slot)) continue;
        const Field& field = fields.fields[slot];
        hasher.add(static_cast<int>(field.index()));
        if (const auto* uniform = std::get_if<UniformField>(&field)) hasher.add(uniform->acceleration);
        if (const auto* point = std::get_if<PointField>(&field)) hasher.add_all(point->center, point->strength, point->softening);
        if (const auto* n_body = std::get_if<NBodyField>(&field))
            hasher.add_all(n_body->gravitational_constant, n_body->softening, n_body->opening_angle, static_cast<int>(n_body->method),
                           static_cast<int>(n_body->sources));
    }
}

} // namespace

std::uint64_t World::hash() const
{
    const detail::WorldState& world = state();
    Hasher hasher;
    hasher.add_all(world.step_count, world.gravity, world.last_substep);
    hasher.add_all(world.tuning.contact_hertz, world.tuning.contact_damping_ratio, world.tuning.push_out_speed,
                   world.tuning.restitution_threshold);
    add_bodies(hasher, world.bodies);
    add_shapes(hasher, world.shapes);
    add_contacts(hasher, world.contacts);
    add_fields(hasher, world.fields);
    return hasher.result();
}

} // namespace carom
