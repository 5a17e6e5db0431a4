// Joints: what holds bodies together, and the view through which a program reads and changes one.
#pragma once

#include <carom/ids.hpp>
#include <carom/math.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <variant>

namespace carom
{

namespace detail
{
struct WorldState;
}

/// As much as it takes: the largest force [N] or torque [N m] that a joint accepts, and the default of those that drive bodies.
inline constexpr float max_joint_force = 1e20f;

/// Ends of what may be, in the unit of what they limit: [rad] or [m]. lower <= upper.
struct Range
{
    float lower = 0;
    float upper = 0;

    friend bool operator==(const Range&, const Range&) = default;
};

/// A damped spring, given by how it swings rather than by its stiffness, so that it suits bodies of any mass.
struct Spring
{
    float hertz = 5;            ///< swings in a second without damping [1/s], 0 (no spring at all) to 1e4
    float damping_ratio = 0.7f; ///< 0 swings for ever, 1 does not overshoot, >= 0
    float target = 0;           ///< where it is at rest: [rad] or [m]; that of a distance joint is its length instead

    friend bool operator==(const Spring&, const Spring&) = default;
};

/// Drives towards a speed with the force that it takes, up to a largest one. At speed 0 it is a brake.
struct Motor
{
    float speed = 0;                   ///< of B past A [rad/s] or [m/s]
    float max_force = max_joint_force; ///< [N m] or [N], 0 (no motor at all) to max_joint_force

    friend bool operator==(const Motor&, const Motor&) = default;
};

/// A pin: the origins of the two frames stay together. Its angle is that of frame B seen from frame A, counted over full turns.
struct RevoluteJoint
{
    std::optional<Range> limit = {};   ///< of the angle [rad]; may span several turns, within +-1e5
    std::optional<Motor> motor = {};   ///< [rad/s], [N m]
    std::optional<Spring> spring = {}; ///< towards an angle [rad]
};

/// A rail: B slides along the x axis of frame A and does not turn against it.
struct PrismaticJoint
{
    std::optional<Range> limit = {};   ///< of the way along the axis [m]
    std::optional<Motor> motor = {};   ///< [m/s], [N]
    std::optional<Spring> spring = {}; ///< towards a place on the axis [m]
};

/// A rod between the origins of the two frames; with a spring, a spring of that length; with a range and no spring, a rope or a telescope
/// that is free in between.
struct DistanceJoint
{
    float length = 1;                  ///< of the rod, or of the spring at rest [m], >= 0.001
    std::optional<Range> limit = {};   ///< shortest and longest [m], >= 0; {0, l} is a rope of length l
    std::optional<Spring> spring = {}; ///< `target` is not read
};

/// Holds frame B in frame A. A spring makes that way of giving way soft.
struct WeldJoint
{
    std::optional<Spring> linear = {};  ///< `target` is not read
    std::optional<Spring> angular = {}; ///< `target` is not read
};

/// A wheel B on a suspension: it turns freely and moves along the x axis of frame A.
struct WheelJoint
{
    std::optional<Spring> suspension = Spring{}; ///< along the axis, towards a place on it [m]
    std::optional<Range> limit = {};             ///< of the way along the axis [m]
    std::optional<Motor> motor = {};             ///< turns the wheel [rad/s], [N m]
};

/// Pulls frame B to a pose seen from frame A, with a force and a torque of limited size: for top-down friction, for actors that are led. Both bodies
/// are pushed at the origin of frame B, so that a pair of free bodies keeps its momentum and its angular momentum.
///
/// The offset counts from the origin of frame A to the origin of frame B, along the axes of frame A. With World::joint_at the two origins meet at
/// the given point, so an offset of zero then means "as the bodies stand now", and an offset of {1, 0} a metre further along `axis`. With frames left
/// out, the offset is from the origin of body A to the origin of body B. World::motor_joint_as_placed gives the pose that two bodies have now.
struct MotorJoint
{
    Vec2 offset = {};                   ///< where the origin of frame B shall be in frame A [m]
    float angle = 0;                    ///< of frame B in frame A [rad], in [-pi, pi]
    Spring spring = {};                 ///< how it gets there; `target` is not read
    float max_force = max_joint_force;  ///< [N], 0 to max_joint_force
    float max_torque = max_joint_force; ///< [N m], 0 to max_joint_force
};

/// Drags a point of body B, the origin of frame B, to a point of the world. Body A is the world: leave it null.
struct MouseJoint
{
    Vec2 target = {};                  ///< in the world [m]
    Spring spring = {};                ///< how it gets there; `target` of the spring is not read
    float max_force = max_joint_force; ///< [N], 0 to max_joint_force
};

/// What a gear reads of a body.
enum class GearMotion
{
    Turn, ///< the angle [rad]
    Slide ///< the way along the x axis of the body's frame [m]: a rack
};

/// Keeps q_a + ratio q_b as it was when the joint was made, where q is how far a body has turned, or slid. Two wheels that mesh: ratio = radius
/// of B / radius of A. Wheel A on rack B: ratio = -1 / radius of A or its opposite. Hold the bodies by other joints.
struct GearJoint
{
    float ratio = 1; ///< not 0; [1], [rad/m] or [m/rad] as the motions ask
    GearMotion motion_a = GearMotion::Turn;
    GearMotion motion_b = GearMotion::Turn;
};

/// A rope over two fixed points: length_a + ratio length_b <= length. It pulls and never pushes.
struct PulleyJoint
{
    Vec2 ground_a = {}; ///< in the world [m]
    Vec2 ground_b = {}; ///< in the world [m]
    float ratio = 1;    ///< > 0; 2 for a block and tackle on B
    float length = 1;   ///< [m], > 0
};

using JointSpec =
    std::variant<RevoluteJoint, PrismaticJoint, DistanceJoint, WeldJoint, WheelJoint, MotorJoint, MouseJoint, GearJoint, PulleyJoint>;

/// In the order of JointSpec's alternatives.
enum class JointType
{
    Revolute,
    Prismatic,
    Distance,
    Weld,
    Wheel,
    Motor,
    Mouse,
    Gear,
    Pulley
};

/// What every joint has. World::joint_at and World::joint_between fill in the frames from places in the world.
struct JointDef
{
    BodyId body_a = {};                                          ///< null: the world itself; frame_a is then a place in it
    BodyId body_b = {};                                          ///< not body_a
    Transform frame_a = {};                                      ///< seen from body A's origin
    Transform frame_b = {};                                      ///< seen from body B's origin
    bool collide_connected = false;                              ///< whether the two bodies can touch each other
    float break_force = std::numeric_limits<float>::infinity();  ///< a larger force destroys the joint [N], > 0
    float break_torque = std::numeric_limits<float>::infinity(); ///< a larger torque destroys the joint [N m], > 0
    std::uint64_t user_data = 0;                                 ///< yours; the engine does not read it
};

/// Reads a joint. Every call throws UsageError once the joint is gone. A view must not outlive its world.
class JointView
{
public:
    JointId id() const { return id_; }
    JointType type() const;
    const JointSpec& spec() const; ///< valid until any joint is created, changed or destroyed
    BodyId body_a() const;         ///< null when it is the world
    BodyId body_b() const;
    Transform frame_a() const;
    Transform frame_b() const;
    bool collide_connected() const;
    float break_force() const;
    float break_torque() const;
    std::uint64_t user_data() const;

    Vec2 force() const;   ///< on body B, at the origin of frame B, mean over the last step [N]
    float torque() const; ///< on body B about that point, mean over the last step [N m]
    /// Angle of frame B in frame A [rad]: of a revolute joint over full turns, of others in [-pi, pi].
    float angle() const;
    /// Where the origin of frame B is in frame A [m].
    Vec2 offset() const;
    /// By how much the joint misses what it holds rigidly [m]; the larger of the distance and the lever of 1 m at the angle. 0 for
    /// joints that hold nothing rigidly.
    float error() const;

protected:
    friend class World;
    JointView(detail::WorldState& world, JointId id) : world_(&world), id_(id) {}

    detail::WorldState* world_;
    JointId id_;
};

/// Reads and changes a joint. Changes wake its bodies.
class Joint : public JointView
{
public:
    /// Other limits, motors, springs, targets.
    /// @throws UsageError also when the spec is of another type than the joint
    void set_spec(const JointSpec& spec);
    void set_frames(const Transform& frame_a, const Transform& frame_b);
    void set_collide_connected(bool collide_connected);
    void set_break_limits(float force, float torque); ///< [N], [N m], each > 0, may be infinite
    void set_user_data(std::uint64_t user_data);

private:
    friend class World;
    using JointView::JointView;
};

} // namespace carom
