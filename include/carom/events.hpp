// What happened in a step: contacts and sensor overlaps that began, went on, or ended.
#pragma once

#include <carom/ids.hpp>
#include <carom/math.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace carom
{

/// One point of a contact.
struct ContactPoint
{
    Vec2 position;             ///< in the world, halfway between the two surfaces [m]
    float separation = 0;      ///< distance of the surfaces, negative when they overlap [m]
    float normal_impulse = 0;  ///< total along the normal in the last step [N s], >= 0
    float tangent_impulse = 0; ///< total along the surface in the last step [N s]
    float approach_speed = 0;  ///< speed at which the surfaces met at the start of the step, positive when approaching [m/s]
    std::uint32_t feature = 0; ///< which corners or edges made the point; equal from step to step while they stay the same
};

/// Where two shapes touch or nearly touch.
struct Manifold
{
    Vec2 normal;                        ///< unit, from shape A to shape B
    std::array<ContactPoint, 2> points; ///< the first `point_count` are in use
    int point_count = 0;                ///< 0 to 2
    float rolling_impulse = 0;          ///< angular impulse of rolling resistance in the last step [N m s]

    float total_normal_impulse() const ///< of all points [N s], >= 0
    {
        float sum = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(point_count); ++i) sum += points[i].normal_impulse;
        return sum;
    }
    float total_tangent_impulse() const ///< of all points, along the normal turned right by a quarter turn [N s]
    {
        float sum = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(point_count); ++i) sum += points[i].tangent_impulse;
        return sum;
    }
};

/// Two shapes touch since this step: their surfaces met, or the solver had to push them apart.
struct ContactBegin
{
    ShapeId shape_a;
    ShapeId shape_b;
    Manifold manifold;
};

/// Two shapes touched in the step before, and still do. Reported when either shape asks for it.
struct ContactPersist
{
    ShapeId shape_a;
    ShapeId shape_b;
    Manifold manifold;
};

/// Two shapes no longer touch. An id is stale when the end came by destroying its shape.
struct ContactEnd
{
    ShapeId shape_a;
    ShapeId shape_b;
    float total_normal_impulse = 0;  ///< in the last step in which they touched [N s]
    float total_tangent_impulse = 0; ///< in the last step in which they touched [N s]
};

/// Two shapes met faster than WorldDef::hit_speed. Reported when either shape asks for it, once for each collision of the two: however
/// many steps it takes to stop them.
struct ContactHit
{
    ShapeId shape_a;
    ShapeId shape_b;
    Vec2 point;               ///< of the contact points the fastest, in the world at the start of the step [m]
    Vec2 normal;              ///< unit, from shape A to shape B
    float approach_speed = 0; ///< along the normal at the start of the step [m/s]
};

/// A shape overlaps a sensor: since this step, still, or no longer, by the list that holds it. Two sensors that
/// overlap make two events, one for each as the sensor. In the end list an id may be stale.
struct SensorEvent
{
    ShapeId sensor;
    ShapeId visitor;
};

/// A joint that pulled harder than it may. It is gone: the id is stale.
struct JointBreak
{
    JointId joint;
    BodyId body_a; ///< null when it was the world
    BodyId body_b;
    float force = 0;             ///< in the step that broke it [N]
    float torque = 0;            ///< [N m]
    std::uint64_t user_data = 0; ///< the joint's
};

/// The events of the last step, each list ordered by the ids' indices, so that equal runs give equal lists. Ends that come from
/// destroying, disabling or editing between two steps are in the lists of the later step. Valid until the world's next step.
struct Events
{
    std::span<const ContactBegin> contact_begin;
    std::span<const ContactPersist> contact_persist;
    std::span<const ContactEnd> contact_end;
    std::span<const ContactHit> contact_hit;
    std::span<const SensorEvent> sensor_begin;
    std::span<const SensorEvent> sensor_persist;
    std::span<const SensorEvent> sensor_end;
    std::span<const JointBreak> joint_break;
    std::span<const BodyId> fell_asleep; ///< bodies that came to rest
    std::span<const BodyId> woke;        ///< bodies that were woken since the step before
};

} // namespace carom
