// Bodies: a cold record a body, and small dense arrays of what the hot loops read of those that move.
#pragma once

#include "dynamics/slot_pool.hpp"

#include <carom/body.hpp>
#include <carom/math.hpp>

#include <cstdint>
#include <memory_resource>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace carom::detail
{

/// What the solver reads and writes of an active body: 32 bytes, by motion index.
struct BodyMotion
{
    Vec2 v;      ///< of the centre of mass [m/s]
    float w = 0; ///< [rad/s]
    Vec2 dp;     ///< way of the centre since the start of the step [m]
    Rot dq;      ///< rotation since the start of the step
    std::uint32_t slot = null_index;
};
static_assert(sizeof(BodyMotion) == 32);

/// Resistance of an active body, by motion index. Zero is "can't be pushed": kinematic bodies, locked axes. Four floats, which lanes load as a whole.
struct alignas(16) BodyMass
{
    Vec2 inv_mass;         ///< along each axis [1/kg]
    float inv_inertia = 0; ///< [1/(kg m^2)]
};

inline bool can_be_pushed(const BodyMass& mass) { return mass.inv_mass != Vec2{} || mass.inv_inertia != 0; }

/// What accelerates and brakes an active body, by motion index.
struct alignas(16) BodyDrive
{
    Vec2 force;                ///< [N]
    float torque = 0;          ///< [N m]
    Vec2 gravity_scale;        ///< along each axis; 0 where gravity can't move the body
    float linear_damping = 0;  ///< [1/s]
    float angular_damping = 0; ///< [1/s]
};

/// What the end of a step looks at of an active body, by motion index.
struct BodyWatch
{
    float rest_time = 0;               ///< how long it has been at rest [s]
    Vec2 drift;                        ///< displacement of its centre since then [m]
    float turn = 0;                    ///< how far it has turned since then [rad]
    std::uint32_t island = null_index; ///< of a dynamic body
    float inner_radius = 0;            ///< of its thinnest shape [m]
    float outer_radius = 0;            ///< from the centre of mass to the farthest point [m]
    bool can_sleep = true;
    bool has_woken = false; ///< since the last step
    bool is_bullet = false;
    bool is_driven = false;   ///< a belt, a motor or a drive moved it in this step: set by the solvers, read by finalize_bodies
    bool is_settling = false; ///< a contact of it is still coming up: its rest begins anew. Set by the solver, read by finalize_bodies
    bool has_goal = false;    ///< see BodyRecord::goal
    /// Displacement that continuous collision took back in the last step: the velocity is that of the place ahead by as much [m].
    Vec2 set_back;
};

/// Where a body is, by slot.
struct BodyPose
{
    Transform transform; ///< of the origin
    Vec2 center;         ///< of mass, in the world [m]
    Vec2 local_center;   ///< of mass, in the body's frame [m]
};

/// The rest of a body, by slot. What a step reads of most bodies comes first, side by side.
struct BodyRecord
{
    // Told of its allocator by the array that it lies in, so that a copy's name comes from the copy's memory.
    using allocator_type = std::pmr::polymorphic_allocator<>;
    explicit BodyRecord(const allocator_type& memory) : name(memory) {}
    BodyRecord(const BodyRecord& other, const allocator_type& memory) : BodyRecord(memory) { *this = other; }
    BodyRecord(BodyRecord&& other, const allocator_type& memory) : BodyRecord(memory) { *this = std::move(other); }
    BodyRecord(const BodyRecord&) = default;
    BodyRecord(BodyRecord&&) noexcept = default;
    BodyRecord& operator=(const BodyRecord&) = default;
    BodyRecord& operator=(BodyRecord&&) = default;
    ~BodyRecord() = default;

    BodyType type = BodyType::Dynamic;
    bool is_enabled = true;
    bool is_attractor = false;
    bool is_asleep = false;
    bool can_sleep = true;
    bool is_bullet = false;
    bool has_mass_override = false;
    MotionLocks locks;
    std::uint32_t first_shape = null_index;
    std::uint32_t first_contact = null_index; ///< contact edge, see ContactStore
    std::uint32_t first_joint = null_index;   ///< joint edge, see JointStore
    std::uint32_t ground_contacts = 0;        ///< of a dynamic body: with bodies that are not, but for sensors
    float inner_radius = 0;                   ///< see BodyWatch
    float outer_radius = 0;
    std::uint32_t island = null_index; ///< of a dynamic body that is enabled
    std::uint32_t previous_in_island = null_index;
    std::uint32_t next_in_island = null_index;
    std::uint32_t color_mask = 0; ///< solver colours in use by this body's contacts
    std::uint32_t last_shape = null_index;
    std::uint32_t shape_count = 0;
    float linear_damping = 0;
    float angular_damping = 0;
    float gravity_scale = 1;
    Vec2 saved_v;           ///< velocity while the body is not active [m/s]
    float saved_w = 0;      ///< [rad/s]
    MassData shapes_mass;   ///< of all its shapes together; static bodies have it too
    MassData mass_override; ///< as the user gave it
    MassData mass;          ///< of the two the one that counts, as the solver uses it
    std::uint64_t user_data = 0;
    std::uint64_t put_to_sleep_at = never; ///< the number of steps when the user last did so
    Transform goal;                        ///< where Body::move_to leads it, while its watch says that it has a goal
    float goal_dt = 0;                     ///< length of the step that ends there [s]
    std::pmr::string name;
};

/// Two parts as one body.
MassData combined(const MassData& a, const MassData& b);

/// All bodies of a world. A body is active while it is enabled, not static and awake; only active ones have a motion index. Motion index 0
/// stands for everything that does not move: at rest, infinitely heavy, never written.
class BodyStore
{
public:
    explicit BodyStore(std::pmr::memory_resource& memory);

    /// Changes nothing when memory runs out.
    std::uint32_t create(const BodyDef& def);
    /// The body has no shapes and no contacts any more.
    void destroy(std::uint32_t slot);
    void reserve(std::size_t count);
    /// Room to activate every body there is: what create() sees to, and a copy of the arrays does not bring along.
    void make_room();
    /// Gives back the memory of what lies behind the last body, and spare room.
    void shrink();

    /// Makes the dense arrays follow the record: type, enabled, asleep, mass, locks, damping, size.
    void refresh(std::uint32_t slot);
    bool is_active(std::uint32_t slot) const { return motion_index[slot] != 0; }
    bool is_dynamic(std::uint32_t slot) const { return records[slot].type == BodyType::Dynamic; }

    Vec2 velocity(std::uint32_t slot) const { return is_active(slot) ? motions[motion_index[slot]].v : records[slot].saved_v; }
    float spin(std::uint32_t slot) const { return is_active(slot) ? motions[motion_index[slot]].w : records[slot].saved_w; }
    /// Where the body is at this moment: in the middle of a step, its pose is still where the step began.
    BodyPose pose_now(std::uint32_t slot) const;
    void set_velocity(std::uint32_t slot, Vec2 v);
    void set_spin(std::uint32_t slot, float w);
    void set_transform(std::uint32_t slot, const Transform& transform);
    /// An active body has velocities that take it to a place within a step: finalize_bodies puts it there exactly.
    void set_goal(std::uint32_t slot, const Transform& goal, float dt);
    /// Whether forces and impulses act on the body: it is dynamic and enabled.
    bool is_pushable(std::uint32_t slot) const { return is_dynamic(slot) && is_active(slot); }
    /// Changes the velocity of a pushable body by an impulse [N s] and an angular impulse [N m s].
    void push(std::uint32_t slot, Vec2 impulse, float angular_impulse);
    /// Makes mass and centre follow the shapes' mass, the override and the type.
    void refresh_mass(std::uint32_t slot);
    /// What an N-body field sees [kg].
    float gravity_mass(std::uint32_t slot) const;

    SlotPool slots;
    std::pmr::vector<BodyRecord> records;         ///< by slot
    std::pmr::vector<BodyPose> poses;             ///< by slot
    std::pmr::vector<std::uint32_t> motion_index; ///< by slot; 0 when not active

    std::uint64_t revision = 0;           ///< another after each change to which bodies are active and to their masses
    std::pmr::vector<BodyMotion> motions; ///< by motion index, as are the next three
    std::pmr::vector<BodyMass> masses;
    std::pmr::vector<BodyDrive> drives;
    std::pmr::vector<BodyWatch> watches;

private:
    void make_room_for_one();
    void activate(std::uint32_t slot);
    void deactivate(std::uint32_t slot);
    void forget_plans(std::uint32_t slot);
};

} // namespace carom::detail
