// Bodies: what they are made of, and the view through which a program reads and moves one.
#pragma once

#include <carom/ids.hpp>
#include <carom/math.hpp>
#include <carom/shape.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace carom
{

namespace detail
{
struct WorldState;
}

enum class BodyType
{
    Static,    ///< never moves, unless its transform is set
    Kinematic, ///< moves by its velocities alone, and pushes what it meets; lead it with Body::move_to
    Dynamic    ///< moves by forces and contacts; when its shapes have no mass it counts as 1 kg that does not turn
};

/// Largest coordinate of a velocity [m/s] and largest spin [rad/s] that calls accept; a step slows down what has become faster. Rates, scales and accelerations are accepted up to 1e6 too.
inline constexpr float max_speed = 1e6f;

/// Directions in which a dynamic body can't move; others do not heed them.
struct MotionLocks
{
    bool x = false;
    bool y = false;
    bool rotation = false;

    friend bool operator==(const MotionLocks&, const MotionLocks&) = default;
};

struct BodyDef
{
    BodyType type = BodyType::Dynamic;
    Vec2 position = {};         ///< of the body's origin [m]
    float angle = 0;            ///< [rad]
    Vec2 linear_velocity = {};  ///< of the centre of mass [m/s]
    float angular_velocity = 0; ///< [rad/s]
    float linear_damping = 0;   ///< rate at which a dynamic body's velocity decays [1/s], >= 0
    float angular_damping = 0;  ///< rate at which a dynamic body's spin decays [1/s], >= 0
    float gravity_scale = 1;    ///< multiplies WorldDef::gravity and fields
    MotionLocks locks = {};
    bool can_sleep = true;       ///< may be put to sleep when it has come to rest
    bool is_bullet = false;      ///< is kept from passing through others even when it moves less than half its size in a step
    bool is_attractor = false;   ///< pulls others through an NBodyField with NBodySources::Attractors
    bool is_enabled = true;      ///< a disabled body keeps its state and takes no part in the simulation
    std::string_view name = {};  ///< copied
    std::uint64_t user_data = 0; ///< yours; the engine does not read it
};

/// Reads a body. A light value: keep the id, make a view when needed. Every call throws UsageError once the body is gone. A
/// view must not outlive its world.
class BodyView
{
public:
    BodyId id() const { return id_; }
    BodyType type() const;
    Transform transform() const;
    Vec2 position() const;                    ///< of the origin [m]
    float angle() const;                      ///< in [-pi, pi] [rad]
    Vec2 center_of_mass() const;              ///< in the world [m]
    Vec2 linear_velocity() const;             ///< of the centre of mass [m/s]
    float angular_velocity() const;           ///< [rad/s]
    Vec2 velocity_at(Vec2 world_point) const; ///< of the body's material at a world point, which must be finite [m/s]
    MassData mass_data() const;               ///< zero mass for static and kinematic bodies unless set_mass_data gave one
    bool has_own_mass() const;                ///< set_mass_data() overrides what the shapes give
    float linear_damping() const;
    float angular_damping() const;
    float gravity_scale() const;
    MotionLocks locks() const;
    bool is_attractor() const;
    bool is_awake() const; ///< false when it has come to rest and waits to be touched; a static body never is
    bool can_sleep() const;
    bool is_bullet() const;
    bool is_enabled() const;
    Vec2 force() const;   ///< gathered for the next step [N]
    float torque() const; ///< gathered for the next step [N m]
    std::size_t shape_count() const;
    std::vector<ShapeId> shapes() const; ///< in the order in which they were added
    std::string_view name() const;       ///< valid until it is renamed, or any body is created or destroyed
    std::uint64_t user_data() const;
    Aabb bounds() const; ///< of all its shapes; a point at its position when it has none [m]

protected:
    friend class World;
    BodyView(detail::WorldState& world, BodyId id) : world_(&world), id_(id) {}

    detail::WorldState* world_;
    BodyId id_;
};

/// Reads and changes a body. Changes wake it, and what touches it; only name, user data and the marks for attractors and bullets do not. Changes throw UsageError on a value that is not finite or out of range, and during a step.
class Body : public BodyView
{
public:
    void set_type(BodyType type);
    /// Teleports: the body is there at once, and touches what it overlaps from the next step on. It passes through what lies
    /// between and has no speed for what it touches: what stands on a lift that is teleported in every step sinks into it. Move
    /// a lift, a door or a paddle with move_to().
    /// @param position of the origin [m], within +-max_coordinate
    /// @param angle    [rad]
    void set_transform(Vec2 position, float angle);
    /// Sets the velocities that take a kinematic body to a place within the next step: it carries and pushes what it touches on
    /// the way, and turns the shorter way round. Call it before each step with the place for the end of that step; the errors of
    /// rounding do not add up. The velocities stay set: without another call the body goes on by as much in the step after.
    /// @param target of the origin [m], within +-max_coordinate, and a unit rotation
    /// @param dt     length of the next step [s], > 0
    /// @throws UsageError when the body is not kinematic, or when the way would take more than max_speed
    void move_to(const Transform& target, float dt);
    void set_linear_velocity(Vec2 velocity);   ///< [m/s]; a static body takes none
    void set_angular_velocity(float velocity); ///< [rad/s]; a static body takes none
    void set_linear_damping(float rate);
    void set_angular_damping(float rate);
    void set_gravity_scale(float scale);
    void set_locks(MotionLocks locks);
    void set_is_attractor(bool is_attractor);
    /// Wakes the body, or puts it to sleep at once, and all that it touches or is joined to with it. A body that is put to sleep before it has touched
    /// anything sleeps on, beside other sleepers and on ground that does not move, until something that is awake touches it or an edit wakes it; with it
    /// wake the sleepers that touch it, and those that touch them, from the first step on that has seen them together.
    void set_awake(bool is_awake);
    void set_can_sleep(bool can_sleep);
    void set_is_bullet(bool is_bullet);
    void set_enabled(bool is_enabled);
    /// Overrides what the shapes give, until reset_mass_data().
    /// @param data mass from 1e-12 to 1e20 kg and inertia from 1e-24 to 1e20 kg m^2 for a dynamic body; both may be 0 otherwise
    void set_mass_data(const MassData& data);
    void reset_mass_data(); ///< back to the shapes' own mass
    void set_name(std::string_view name);
    void set_user_data(std::uint64_t user_data);

    // Forces act over the whole next step that takes time, and are then cleared; disabling the body clears them too. They do nothing to a body that is not dynamic
    // or is disabled; so do impulses.
    void apply_force(Vec2 force, Vec2 world_point); ///< [N]
    void apply_force_to_center(Vec2 force);         ///< [N]
    void apply_torque(float torque);                ///< [N m]
    // Impulses change the velocity at once.
    void apply_impulse(Vec2 impulse, Vec2 world_point); ///< [N s]
    void apply_impulse_to_center(Vec2 impulse);         ///< [N s]
    void apply_angular_impulse(float impulse);          ///< [N m s]

private:
    friend class World;
    using BodyView::BodyView;
};

/// Reads a shape.
class ShapeView
{
public:
    ShapeId id() const { return id_; }
    BodyId body() const;
    ChainId chain() const;            ///< that it is a segment of; null when of none
    const Geometry& geometry() const; ///< in the body's frame; valid until any shape is created, changed or destroyed
    float density() const;
    const Material& material() const; ///< valid as long as geometry()
    const Filter& filter() const;     ///< valid as long as geometry()
    bool is_sensor() const;
    bool contact_events() const;
    bool persist_events() const;
    bool sensor_events() const;
    bool hit_events() const;
    bool pre_solve() const;
    Aabb bounds() const; ///< in the world [m]
    std::uint64_t user_data() const;
    bool contains(Vec2 world_point) const; ///< whether the point lies in it or on its edge [m]; throws UsageError unless it is finite
    /// Shapes that it touches or overlaps as of the last step, ordered by index. Sensors among them.
    std::vector<ShapeId> touching() const;

protected:
    friend class World;
    ShapeView(detail::WorldState& world, ShapeId id) : world_(&world), id_(id) {}

    detail::WorldState* world_;
    ShapeId id_;
};

/// Reads and changes a shape.
class Shape : public ShapeView
{
public:
    void set_material(const Material& material); ///< also for contacts that exist
    void set_filter(const Filter& filter);       ///< contacts that it no longer allows end
    void set_geometry(const Geometry& geometry); ///< and the body's mass with it, unless overridden; not of a chain's segment
    void set_density(float density);             ///< and the body's mass with it, unless overridden
    void set_hit_events(bool hit_events);
    void set_pre_solve(bool pre_solve);
    void set_user_data(std::uint64_t user_data);

private:
    friend class World;
    using ShapeView::ShapeView;
};

} // namespace carom
