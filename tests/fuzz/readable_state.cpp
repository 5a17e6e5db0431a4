// Reads every thing of a world through its view.
#include "tests/fuzz/readable_state.hpp"

#include <bit>
#include <concepts>
#include <string_view>
#include <type_traits>

namespace carom::fuzz
{

namespace
{

class Digest
{
public:
    void word(std::uint64_t word)
    {
        state_ = (std::rotl(state_, 29) ^ word) * 0xd6e8feb86659fd93ull;
        state_ ^= state_ >> 32;
    }

    template <class T>
        requires std::integral<T> || std::is_enum_v<T>
    void add(T value)
    {
        word(static_cast<std::uint64_t>(value));
    }
    void add(float value) { word(std::bit_cast<std::uint32_t>(value)); }
    void add(Vec2 v) { add(v.x), add(v.y); }
    void add(const Transform& t) { add(t.p), add(t.q.c), add(t.q.s); }
    void add(const Aabb& box) { add(box.min), add(box.max); }
    void add(const MassData& mass) { add(mass.mass), add(mass.center), add(mass.inertia); }
    void add(const MotionLocks& locks) { add(locks.x), add(locks.y), add(locks.rotation); }
    void add(const Filter& filter) { add(filter.category), add(filter.mask), add(filter.group); }
    void add(std::string_view text)
    {
        add(text.size());
        for (const char c : text) add(c);
    }
    template <class Tag>
    void add(Id<Tag> id)
    {
        add(id.index), add(id.generation), add(id.world);
    }
    void add(const Material& m) { add(m.friction), add(m.restitution), add(m.rolling_resistance), add(m.tangent_speed), add(m.id); }

    template <class... Values>
    void all(const Values&... values)
    {
        (add(values), ...);
    }

    std::uint64_t result() const { return state_; }

private:
    std::uint64_t state_ = 1;
};

void read_chain(Digest& digest, const ChainView& chain)
{
    digest.all(chain.id(), chain.body(), chain.segment_count(), chain.is_loop(), chain.sides(), chain.user_data());
}

void read_shape(Digest& digest, const World& world, const ShapeView& shape)
{
    digest.all(shape.id(), shape.body(), shape.geometry().index(), shape.density(), shape.material(), shape.filter(), shape.is_sensor());
    digest.all(shape.hit_events(), shape.pre_solve(), shape.bounds(), shape.user_data(), shape.chain());
    if (shape.chain()) read_chain(digest, world.chain(shape.chain()));
}

void read_body(Digest& digest, const World& world, const BodyView& body)
{
    digest.all(body.id(), body.type(), body.transform(), body.center_of_mass(), body.linear_velocity(), body.angular_velocity());
    digest.all(body.mass_data(), body.linear_damping(), body.angular_damping(), body.gravity_scale(), body.locks(), body.is_attractor());
    digest.all(body.is_awake(), body.can_sleep(), body.is_bullet(), body.is_enabled(), body.force(), body.torque(), body.name());
    digest.all(body.user_data(), body.bounds(), body.shape_count());
    for (const ShapeId id : body.shapes()) read_shape(digest, world, world.shape(id));
}

void read_joint(Digest& digest, const JointView& joint)
{
    digest.all(joint.id(), joint.type(), joint.body_a(), joint.body_b(), joint.frame_a(), joint.frame_b(), joint.collide_connected());
    digest.all(joint.break_force(), joint.break_torque(), joint.user_data(), joint.force(), joint.torque(), joint.angle());
}

void read_options(Digest& digest, const World& world)
{
    const BroadPhaseOptions broad_phase = world.broad_phase_options();
    const SolverTuning solver = world.solver_tuning();
    const SleepTuning sleep = world.sleep_tuning();
    digest.all(world.gravity(), world.broad_phase(), broad_phase.quadtree_max_depth, broad_phase.quadtree_node_capacity);
    digest.all(solver.contact_hertz, solver.contact_damping_ratio, solver.push_out_speed, solver.restitution_threshold, solver.joint_hertz);
    digest.all(solver.joint_damping_ratio, solver.warm_starting, sleep.is_enabled, sleep.speed, sleep.time, world.is_continuous(),
               world.mixing().friction);
    digest.all(world.mixing().restitution, world.hit_speed(), world.length_unit(), world.max_pairs(), world.hooks() != nullptr);
}

void read_events(Digest& digest, const Events& events)
{
    digest.all(events.contact_begin.size(), events.contact_persist.size(), events.contact_end.size(), events.contact_hit.size());
    digest.all(events.sensor_begin.size(), events.sensor_persist.size(), events.sensor_end.size(), events.joint_break.size());
    for (const BodyId id : events.fell_asleep) digest.add(id);
    for (const BodyId id : events.woke) digest.add(id);
}

} // namespace

std::uint64_t readable_state(const World& world)
{
    Digest digest;
    digest.all(world.body_count(), world.awake_body_count(), world.shape_count(), world.joint_count(), world.step_count());
    read_options(digest, world);
    for (const BodyId id : world.bodies()) read_body(digest, world, world.body(id));
    for (const JointId id : world.joints()) read_joint(digest, world.joint(id));
    read_events(digest, world.events());
    return digest.result();
}

} // namespace carom::fuzz
