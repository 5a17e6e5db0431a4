// The hash of a world's whole state: everything that the steps to come depend on, and nothing that only remembers how pairs were found.
#include "state/world_state.hpp"

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
    if (slots.dropped_generation() > 0) hasher.add(slots.dropped_generation());
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

void add_bodies(Hasher& hasher, const detail::BodyStore& bodies, std::uint64_t step_count)
{
    add_slots(hasher, bodies.slots);
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot)
    {
        if (!bodies.slots.is_live(slot)) continue;
        const detail::BodyRecord& body = bodies.records[slot];
        const detail::BodyPose& pose = bodies.poses[slot];
        const detail::BodyDrive& drive = bodies.drives[bodies.motion_index[slot]];
        hasher.add_all(static_cast<int>(body.type), body.is_enabled, body.is_attractor, body.has_mass_override, body.is_asleep,
                       body.can_sleep, body.is_bullet);
        hasher.add_all(body.locks.x, body.locks.y, body.locks.rotation, body.linear_damping, body.angular_damping, body.gravity_scale);
        hasher.add_all(body.mass, body.shapes_mass, body.color_mask, bodies.motion_index[slot], body.first_shape, body.first_contact);
        hasher.add_all(body.island, body.next_in_island, bodies.watches[bodies.motion_index[slot]].rest_time);
        hasher.add_all(pose.transform.p, pose.transform.q, pose.center, bodies.velocity(slot), bodies.spin(slot), drive.force,
                       drive.torque);
        const detail::BodyWatch& watch = bodies.watches[bodies.motion_index[slot]];
        if (watch.rest_time > 0) hasher.add_all(watch.drift, watch.turn);
        if (watch.set_back != Vec2{}) hasher.add(watch.set_back);
        if (watch.has_goal) hasher.add_all(body.goal.p, body.goal.q, body.goal_dt);
        if (body.is_asleep && body.put_to_sleep_at == step_count) hasher.add(step_count); // whom it touches in the next step
    }
}

void add_shapes(Hasher& hasher, const detail::ShapeStore& shapes, const detail::BodyStore& bodies, std::uint64_t step_count)
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
        if (shape.placed_at == step_count && !bodies.is_dynamic(shape.body)) hasher.add(step_count); // whom it wakes in the next step
        if (shape.hit_events || shape.pre_solve) hasher.add_all(shape.hit_events, shape.pre_solve);
        if (shape.chain != detail::null_index)
            hasher.add_all(shape.chain, shape.previous_in_chain, shape.next_in_chain, shape.is_one_sided);
    }
}

void add_chains(Hasher& hasher, const detail::ChainStore& chains)
{
    if (chains.slots.size() > 0) add_slots(hasher, chains.slots);
    for (std::uint32_t slot = 0; slot < chains.slots.size(); ++slot)
    {
        if (!chains.slots.is_live(slot)) continue;
        const detail::ChainRecord& chain = chains.records[slot];
        hasher.add_all(chain.body, chain.first_shape, chain.segment_count, chain.is_loop, chain.is_one_sided);
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
        hasher.add_all(contact.shape_a, contact.shape_b, int{contact.color}, contact.is_touching);
        hasher.add_all(contact.next[0], contact.next[1], contact.place_in_awake);
        if (contact.is_passing || contact.is_hitting || contact.is_overridden)
            hasher.add_all(contact.is_passing, contact.is_hitting, contact.is_overridden);
        const detail::ContactSurface& surface = manifold.surface;
        hasher.add_all(surface.friction, surface.restitution, surface.rolling_resistance, surface.tangent_speed);
        hasher.add_all(manifold.count, manifold.normal, manifold.rolling_impulse, manifold.carried_impulse);
        for (std::size_t i = 0; i < static_cast<std::size_t>(manifold.count); ++i)
            hasher.add_all(manifold.features[i], manifold.separation[i], manifold.impulses[i].normal, manifold.impulses[i].tangent);
    }
}

void add(Hasher& hasher, const Transform& t) { hasher.add_all(t.p, t.q); }
void add(Hasher& hasher, const std::optional<Range>& r)
{
    hasher.add(r.has_value());
    if (r) hasher.add_all(r->lower, r->upper);
}
void add(Hasher& hasher, const Spring& s) { hasher.add_all(s.hertz, s.damping_ratio, s.target); }
void add(Hasher& hasher, const std::optional<Spring>& s)
{
    hasher.add(s.has_value());
    if (s) add(hasher, *s);
}
void add(Hasher& hasher, const std::optional<Motor>& m)
{
    hasher.add(m.has_value());
    if (m) hasher.add_all(m->speed, m->max_force);
}

void add_spec(Hasher& hasher, const JointSpec& spec)
{
    hasher.add(static_cast<int>(spec.index()));
    if (const auto* s = std::get_if<RevoluteJoint>(&spec)) add(hasher, s->limit), add(hasher, s->motor), add(hasher, s->spring);
    if (const auto* s = std::get_if<PrismaticJoint>(&spec)) add(hasher, s->limit), add(hasher, s->motor), add(hasher, s->spring);
    if (const auto* s = std::get_if<DistanceJoint>(&spec)) hasher.add(s->length), add(hasher, s->limit), add(hasher, s->spring);
    if (const auto* s = std::get_if<WeldJoint>(&spec)) add(hasher, s->linear), add(hasher, s->angular);
    if (const auto* s = std::get_if<WheelJoint>(&spec)) add(hasher, s->suspension), add(hasher, s->limit), add(hasher, s->motor);
    if (const auto* s = std::get_if<MotorJoint>(&spec))
        hasher.add_all(s->offset, s->angle, s->max_force, s->max_torque), add(hasher, s->spring);
    if (const auto* s = std::get_if<MouseJoint>(&spec)) hasher.add_all(s->target, s->max_force), add(hasher, s->spring);
    if (const auto* s = std::get_if<GearJoint>(&spec))
        hasher.add_all(s->ratio, static_cast<int>(s->motion_a), static_cast<int>(s->motion_b));
    if (const auto* s = std::get_if<PulleyJoint>(&spec)) hasher.add_all(s->ground_a, s->ground_b, s->ratio, s->length);
}

void add_joints(Hasher& hasher, const detail::JointStore& joints)
{
    add_slots(hasher, joints.slots);
    for (std::uint32_t slot = 0; slot < joints.slots.size(); ++slot)
    {
        if (!joints.slots.is_live(slot)) continue;
        const detail::Joint& joint = joints.joints[slot];
        hasher.add_all(joint.body_a, joint.body_b, joint.next[0], joint.next[1], joint.collide_connected, joint.break_force,
                       joint.break_torque, joint.place_in_active, joint.angle, joint.gear_slip, joint.drive, joint.force);
        add(hasher, joint.frame_a), add(hasher, joint.frame_b);
        add_spec(hasher, joint.spec);
        for (const float impulse : joint.rigid) hasher.add(impulse);
        for (const detail::ControlImpulses& c : joint.controls) hasher.add_all(c.spring, c.motor, c.lower, c.upper);
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
    const detail::WorldState& world = state("hash");
    Hasher hasher;
    hasher.add_all(world.step_count, world.gravity, world.last_substep);
    if (world.rules.mixing != MaterialMixing{})
        hasher.add_all(static_cast<int>(world.rules.mixing.friction), static_cast<int>(world.rules.mixing.restitution));
    if (world.shapes.tolerances.length_unit != WorldDef{}.length_unit) hasher.add(world.shapes.tolerances.length_unit);
    if (world.rules.hit_speed != WorldDef{}.hit_speed) hasher.add(world.rules.hit_speed);
    if (world.rules.max_pairs != 0) hasher.add(world.rules.max_pairs);
    hasher.add_all(world.tuning.contact_hertz, world.tuning.contact_damping_ratio, world.tuning.push_out_speed,
                   world.tuning.restitution_threshold, world.tuning.joint_hertz, world.tuning.joint_damping_ratio);
    if (world.tuning.warm_starting != SolverTuning{}.warm_starting) hasher.add(world.tuning.warm_starting);
    hasher.add_all(world.sleep.is_enabled, world.sleep.speed, world.sleep.time, world.is_continuous);
    add_bodies(hasher, world.bodies, world.step_count);
    add_shapes(hasher, world.shapes, world.bodies, world.step_count);
    add_chains(hasher, world.chains);
    add_contacts(hasher, world.contacts);
    add_joints(hasher, world.joints);
    add_fields(hasher, world.fields);
    return hasher.result();
}

} // namespace carom
