// Between joints and their rows: fills a joint into a lane of a row, and takes the results out again.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/joint_store.hpp"
#include "math/lane_array.hpp"
#include "solver/kernels/joint_kernels.hpp"
#include "solver/rows/body_lanes.hpp"
#include "solver/rows/softness.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <variant>

namespace carom::detail
{

static_assert(most_rigid == max_rigid_rows && most_controls == max_controls);
static_assert(std::variant_size_v<JointSpec> == static_cast<std::size_t>(RowType::Pulley) + 1);

/// How many rows of which kind a joint has. Lanes of one row agree in it.
struct JointShape
{
    std::uint32_t rigid = 0;
    std::uint32_t controls = 0;
    bool has_drive = false;
    bool has_ends = false; ///< a motor or a range

    std::uint32_t key() const { return 1 + rigid + 4 * controls + (has_drive ? 12u : 0u) + (has_ends ? 24u : 0u); }
};

template <class Spec>
bool has_limit_or_motor(const Spec& spec)
{
    return spec.limit || spec.motor;
}

inline JointShape shape_of(const JointSpec& spec)
{
    switch (static_cast<JointType>(spec.index()))
    {
    case JointType::Revolute:
    {
        const auto& pin = *std::get_if<RevoluteJoint>(&spec);
        const bool has_ends = has_limit_or_motor(pin);
        return {2, has_ends || pin.spring ? 1u : 0u, false, has_ends}; // nobody asks for the angle of a mere pin
    }
    case JointType::Prismatic: return {2, 1, false, has_limit_or_motor(*std::get_if<PrismaticJoint>(&spec))};
    case JointType::Distance:
    {
        const auto& distance = *std::get_if<DistanceJoint>(&spec);
        const bool is_rod = !distance.limit && !distance.spring;
        return {is_rod ? 1u : 0u, is_rod ? 0u : 1u, false, distance.limit.has_value()};
    }
    case JointType::Weld:
    {
        const auto& weld = *std::get_if<WeldJoint>(&spec);
        return {(weld.linear ? 0u : 2u) + (weld.angular ? 0u : 1u), weld.angular ? 1u : 0u, weld.linear.has_value()};
    }
    case JointType::Wheel: return {1, 2, false, has_limit_or_motor(*std::get_if<WheelJoint>(&spec))};
    case JointType::Motor: return {0, 1, true};
    case JointType::Mouse: return {0, 0, true};
    case JointType::Gear: return {1, 0, false};
    default: return {0, 1, false, true}; // pulley
    }
}

/// Makes a row whose lanes are free: they push nothing.
/// @param memory row_bytes<F>() of the shape
template <class F>
JointRow<F>& start_row(void* memory, const JointSpec& spec)
{
    const JointShape shape = shape_of(spec);
    std::memset(memory, 0, row_bytes<F>(shape.controls, shape.has_drive));
    JointRow<F>& row = *static_cast<JointRow<F>*>(memory);
    row.type = static_cast<RowType>(spec.index());
    row.rigid_count = shape.rigid;
    row.control_count = shape.controls;
    row.has_drive = shape.has_drive;
    row.has_ends = shape.has_ends;
    row.joint.fill(null_index);
    row.arc = F(1);
    return row;
}

/// Farther than any coordinate: an end that is not there.
inline constexpr float no_limit = 1e12f;
/// Larger than any impulse of use [N s].
inline constexpr float no_bound = 1e30f;

inline SpringRow<float> spring_row(const std::optional<Spring>& spring, float h)
{
    return spring && spring->hertz > 0 ? make_spring(spring->hertz, spring->damping_ratio, h) : SpringRow<float>{0, 0, 1};
}

template <class F>
void set_spring_lane(SpringRow<F>& row, int i, const SpringRow<float>& spring)
{
    lane(row.damping, i) = spring.damping;
    lane(row.push, i) = spring.push;
    lane(row.impulse_scale, i) = spring.impulse_scale;
}

/// What acts on a coordinate, as the user gave it.
struct ControlSetup
{
    std::optional<Range> limit = {};
    std::optional<Motor> motor = {};
    std::optional<Spring> spring = {};
    float target = 0;
    float max_spring = no_bound; ///< [N] or [N m]
};

template <class F>
void fill_control(ControlRow<F>& row, int i, const ControlSetup& setup, const ControlImpulses& impulses, const JointStepConstants& k)
{
    lane(row.lower, i) = setup.limit ? setup.limit->lower : -no_limit;
    lane(row.upper, i) = setup.limit ? setup.limit->upper : no_limit;
    lane(row.motor_speed, i) = setup.motor ? setup.motor->speed : 0.0f;
    lane(row.max_motor, i) = setup.motor ? setup.motor->max_force * k.h : 0.0f;
    lane(row.target, i) = setup.target;
    lane(row.max_spring, i) = setup.max_spring * k.h;
    set_spring_lane(row.spring, i, spring_row(setup.spring, k.h));
    lane(row.lambda_spring, i) = setup.spring ? k.warm_scale * impulses.spring : 0.0f;
    lane(row.lambda_motor, i) = setup.motor ? k.warm_scale * impulses.motor : 0.0f;
    lane(row.lambda_lower, i) = setup.limit ? k.warm_scale * impulses.lower : 0.0f;
    lane(row.lambda_upper, i) = setup.limit ? k.warm_scale * impulses.upper : 0.0f;
}

/// Where a joint's parts are at the start of the step.
struct JointFrames
{
    Transform a; ///< frame A in the world
    Transform b;
    Vec2 center_a; ///< of mass, in the world; frame A's origin when A is the world
    Vec2 center_b;
};

inline JointFrames frames_of(const Joint& joint, const BodyStore& bodies)
{
    JointFrames f;
    f.a = world_frame(bodies, joint.body_a, joint.frame_a);
    f.b = world_frame(bodies, joint.body_b, joint.frame_b);
    f.center_a = joint.body_a == null_index ? f.a.p : bodies.poses[joint.body_a].center;
    f.center_b = bodies.poses[joint.body_b].center;
    return f;
}

/// An angle near which that of frame B in frame A is wanted: where the joint has counted to, or where it holds.
inline float near_angle(const Joint& joint)
{
    if (std::holds_alternative<WeldJoint>(joint.spec) || std::holds_alternative<PrismaticJoint>(joint.spec)) return 0;
    if (const auto* motor = std::get_if<MotorJoint>(&joint.spec)) return motor->angle;
    return joint.angle;
}

/// What is special to a type.
template <class F>
void fill_type(JointRow<F>& row, int i, const Joint& joint, const JointFrames& f, const JointStepConstants& k)
{
    const auto control = [&](std::size_t index, const ControlSetup& setup)
    {
        if (index < row.control_count) fill_control(row.controls[index], i, setup, joint.controls[index], k);
    };
    const auto target = [](const std::optional<Spring>& spring) { return spring ? spring->target : 0.0f; };
    const auto drive = [&](const Spring& spring, float max_force)
    {
        set_spring_lane(row.drive.spring, i, spring_row(spring, k.h));
        lane(row.drive.max_lambda, i) = max_force * k.h;
        set_lane(row.drive.lambda, i, k.warm_scale * joint.drive);
    };
    if (const auto* s = std::get_if<RevoluteJoint>(&joint.spec)) control(0, {s->limit, s->motor, s->spring, target(s->spring)});
    if (const auto* s = std::get_if<PrismaticJoint>(&joint.spec)) control(0, {s->limit, s->motor, s->spring, target(s->spring)});
    if (const auto* s = std::get_if<WheelJoint>(&joint.spec))
    {
        control(0, {s->limit, {}, s->suspension, target(s->suspension)});
        control(1, {{}, s->motor, {}, 0});
    }
    if (const auto* s = std::get_if<DistanceJoint>(&joint.spec))
    {
        lane(row.length, i) = s->length;
        control(0, {s->limit, {}, s->spring, s->length});
    }
    if (const auto* s = std::get_if<WeldJoint>(&joint.spec))
    {
        if (s->linear) drive(*s->linear, no_bound);
        if (s->angular) control(0, {{}, {}, s->angular, 0});
    }
    if (const auto* s = std::get_if<MotorJoint>(&joint.spec))
    {
        drive(s->spring, s->max_force);
        control(0, {{}, {}, s->spring, s->angle, s->max_torque});
        set_lane(row.place_a, i, rotate(f.a.q, s->offset));
    }
    if (const auto* s = std::get_if<MouseJoint>(&joint.spec)) drive(s->spring, s->max_force);
    if (const auto* s = std::get_if<GearJoint>(&joint.spec))
    {
        lane(row.ratio, i) = s->ratio;
        lane(row.slip, i) = joint.gear_slip;
        lane(row.turns_a, i) = s->motion_a == GearMotion::Turn ? 1.0f : 0.0f;
        lane(row.turns_b, i) = s->motion_b == GearMotion::Turn ? 1.0f : 0.0f;
        if (s->motion_a == GearMotion::Slide) set_lane(row.place_a, i, rotate(f.a.q, Vec2{1, 0}));
        if (s->motion_b == GearMotion::Slide) set_lane(row.place_b, i, rotate(f.b.q, Vec2{1, 0}));
    }
    if (const auto* s = std::get_if<PulleyJoint>(&joint.spec))
    {
        lane(row.ratio, i) = s->ratio;
        set_lane(row.place_a, i, s->ground_a - f.a.p);
        set_lane(row.place_b, i, s->ground_b - f.b.p);
        control(0, {Range{-no_limit, s->length}, {}, {}, 0});
    }
}

/// How strongly the forces of a joint turn a body back that turns out of their line: force times arm [N m/rad]. A link of length L under a
/// tension T has T L.
/// @param stiffness by motion index
inline void add_stiffness(const Joint& joint, const JointFrames& f, std::uint32_t body_a, std::uint32_t body_b, std::span<float> stiffness)
{
    stiffness[body_b] += dot(joint.force, f.b.p - f.center_b);
    stiffness[body_a] -= dot(joint.force, f.a.p - f.center_a);
}

/// The inverse inertia that joints see. A light link under a high tension swings at sqrt(stiffness / inertia), faster than substeps can follow
/// beyond 2 / h: it would gain energy until the chain breaks up. Such a link is given as much inertia as it takes to swing at `pace` / h.
inline float steady_inv_inertia(float inv_inertia, float stiffness, float h, float pace)
{
    return stiffness > 0 ? std::min(inv_inertia, pace * pace / std::max(h * h * stiffness, 1e-30f)) : inv_inertia;
}

/// Of links at large, and of those of a rope that bears a load: at 0.5 and above a long one may still shake, at 0.25 it turns too slowly (RopeLoad).
inline constexpr float link_pace = 1;
inline constexpr float loaded_link_pace = 0.3f;

/// Writes a joint into lane `i` of a row of its type and shape.
/// @param stiffness gains what the joint adds, by motion index
template <class F>
void fill_row(JointRow<F>& row, int i, std::uint32_t slot, const Joint& joint, const BodyStore& bodies, const JointStepConstants& k,
              std::span<float> stiffness)
{
    const JointFrames f = frames_of(joint, bodies);
    const std::uint32_t index_a = joint.body_a == null_index ? 0 : bodies.motion_index[joint.body_a];
    const std::uint32_t index_b = bodies.motion_index[joint.body_b];
    row.joint[static_cast<std::size_t>(i)] = slot;
    fill_bodies(row, i, index_a, index_b, bodies.masses[index_a], bodies.masses[index_b]);

    // A mouse pulls from its target, wherever the frame of A is.
    const auto* mouse = std::get_if<MouseJoint>(&joint.spec);
    const Vec2 from = mouse ? mouse->target : f.a.p;
    const Rot facing = relative(f.a.q, f.b.q);
    set_lane(row.arm_a, i, f.a.p - f.center_a);
    set_lane(row.arm_b, i, f.b.p - f.center_b);
    set_lane(row.apart, i, f.b.p - from);
    set_lane(row.axis, i, rotate(f.a.q, Vec2{1, 0}));
    lane(row.facing.c, i) = facing.c;
    lane(row.facing.s, i) = facing.s;
    lane(row.turn, i) = near_angle(joint);
    for (std::size_t r = 0; r < row.rigid_count; ++r) lane(row.lambda[r], i) = k.warm_scale * joint.rigid[r];
    fill_type(row, i, joint, f, k);
    add_stiffness(joint, f, index_a, index_b, stiffness);
}

/// Whether everything that a joint keeps for the next step is finite.
inline bool is_sound(const Joint& joint)
{
    float sum =
        std::abs(joint.force.x) + std::abs(joint.force.y) + std::abs(joint.torque) + std::abs(joint.drive.x) + std::abs(joint.drive.y);
    for (const float impulse : joint.rigid) sum += std::abs(impulse);
    for (const ControlImpulses& c : joint.controls) sum += std::abs(c.spring) + std::abs(c.motor) + std::abs(c.lower) + std::abs(c.upper);
    return std::isfinite(sum);
}

/// Takes lane `i` of a row back into its joint.
template <class F>
void store_row(const JointRow<F>& row, int i, Joint& joint, float inv_dt)
{
    for (std::size_t r = 0; r < row.rigid_count; ++r) joint.rigid[r] = lane(row.lambda[r], i);
    for (std::size_t c = 0; c < row.control_count; ++c)
    {
        const ControlRow<F>& control = row.controls[c];
        joint.controls[c] = {lane(control.lambda_spring, i), lane(control.lambda_motor, i), lane(control.lambda_lower, i),
                             lane(control.lambda_upper, i)};
    }
    if (row.has_drive) joint.drive = {lane(row.drive.lambda.x, i), lane(row.drive.lambda.y, i)};
    joint.force = inv_dt * Vec2{lane(row.total_impulse.x, i), lane(row.total_impulse.y, i)};
    joint.torque = inv_dt * lane(row.total_twist, i);
    const float turn = counts_turns(row) ? lane(row.turn, i) : joint.angle;
    const float slip = row.type == RowType::Gear ? lane(row.error[0], i) : joint.gear_slip;
    if (!is_sound(joint) || !is_finite(Vec2{turn, slip})) return forget_impulses(joint); // one of its bodies is about to be quarantined
    joint.angle = turn;
    joint.gear_slip = slip;
}

} // namespace carom::detail
