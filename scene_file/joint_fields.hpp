// The fields of joints in a scene file.
#pragma once

#include "scene_file/field_rules.hpp"

namespace carom::scene_file
{

template <>
struct Fields<Range>
{
    static constexpr const char* name = "range";
    static constexpr const char* what = "Ends of what may be [rad] or [m].";
    template <class V>
    static void visit(V& v)
    {
        constexpr double most = max_coordinate;
        v("lower", &Range::lower, {.what = "not above upper", .unit = "rad or m", .min = -most, .max = most, .is_required = true});
        v("upper", &Range::upper, {.what = "", .unit = "rad or m", .min = -most, .max = most, .is_required = true});
    }
};
template <>
struct Fields<Spring>
{
    static constexpr const char* name = "spring";
    static constexpr const char* what = "A damped spring.";
    template <class V>
    static void visit(V& v)
    {
        v("hertz", &Spring::hertz,
          {.what = "swings in a second without damping; 0 is no spring at all", .unit = "1/s", .min = 0, .max = 1e4});
        v("damping_ratio", &Spring::damping_ratio, factor("0 swings for ever, 1 does not overshoot"));
        v("target", &Spring::target,
          {.what = "where it is at rest; a distance joint uses its length instead", .unit = "rad or m", .min = -1e6, .max = 1e6});
    }
};
template <>
struct Fields<Motor>
{
    static constexpr const char* name = "motor";
    static constexpr const char* what = "Drives towards a speed with all the force it has.";
    template <class V>
    static void visit(V& v)
    {
        v("speed", &Motor::speed, speed("of B past A", "rad/s or m/s"));
        v("max_force", &Motor::max_force, {.what = "", .unit = "N m or N", .min = 0, .max = any_force});
    }
};
template <>
struct Fields<RevoluteJoint>
{
    static constexpr const char* name = "revolute";
    static constexpr const char* what = "A pin: the origins of the two frames stay together. Its angle is that of frame B in frame A.";
    template <class V>
    static void visit(V& v)
    {
        v("limit", &RevoluteJoint::limit, about("of the angle [rad], within 1e5"));
        v("motor", &RevoluteJoint::motor, about("[rad/s], [N m]"));
        v("spring", &RevoluteJoint::spring, about("towards an angle"));
    }
};
template <>
struct Fields<PrismaticJoint>
{
    static constexpr const char* name = "prismatic";
    static constexpr const char* what = "A rail: B slides along the x axis of frame A and does not turn against it.";
    template <class V>
    static void visit(V& v)
    {
        v("limit", &PrismaticJoint::limit, about("of the way along the axis [m]"));
        v("motor", &PrismaticJoint::motor, about("[m/s], [N]"));
        v("spring", &PrismaticJoint::spring, about("towards a place on the axis"));
    }
};
template <>
struct Fields<DistanceJoint>
{
    static constexpr const char* name = "distance";
    static constexpr const char* what =
        "A rod between the origins of the two frames; with a spring, a spring of that length; with a range and no "
        "spring, a rope or telescope that is free in between.";
    template <class V>
    static void visit(V& v)
    {
        v("length", &DistanceJoint::length, length_of("of the rod, or of the spring at rest", 0.001f));
        v("limit", &DistanceJoint::limit, about("shortest and longest [m], >= 0"));
        v("spring", &DistanceJoint::spring, about("its target is not read"));
    }
};
template <>
struct Fields<WeldJoint>
{
    static constexpr const char* name = "weld";
    static constexpr const char* what = "Holds frame B in frame A; a spring makes that way of giving way soft.";
    template <class V>
    static void visit(V& v)
    {
        v("linear", &WeldJoint::linear, about("its target is not read"));
        v("angular", &WeldJoint::angular, about("its target is not read"));
    }
};
template <>
struct Fields<WheelJoint>
{
    static constexpr const char* name = "wheel";
    static constexpr const char* what = "A wheel B on a suspension: it turns freely and moves along the x axis of frame A.";
    template <class V>
    static void visit(V& v)
    {
        v("suspension", &WheelJoint::suspension, about("along the axis; when left out, a spring with its defaults; null for none"));
        v("limit", &WheelJoint::limit, about("of the way along the axis [m]"));
        v("motor", &WheelJoint::motor, about("turns the wheel [rad/s], [N m]"));
    }
};
template <>
struct Fields<MotorJoint>
{
    static constexpr const char* name = "motor_joint";
    static constexpr const char* what = "Pulls frame B to a pose seen from frame A, with a force and a torque of limited size.";
    template <class V>
    static void visit(V& v)
    {
        v("offset", &MotorJoint::offset, place("where the origin of frame B shall be in frame A"));
        v("angle", &MotorJoint::angle, {.what = "of frame B in frame A", .unit = "rad", .min = -pi, .max = pi});
        v("spring", &MotorJoint::spring, about("how it gets there; its target is not read"));
        v("max_force", &MotorJoint::max_force, {.what = "", .unit = "N", .min = 0, .max = any_force});
        v("max_torque", &MotorJoint::max_torque, {.what = "", .unit = "N m", .min = 0, .max = any_force});
    }
};
template <>
struct Fields<MouseJoint>
{
    static constexpr const char* name = "mouse";
    static constexpr const char* what = "Drags the origin of frame B to a point of the world. It has no body A.";
    template <class V>
    static void visit(V& v)
    {
        v("target", &MouseJoint::target, place("in the world"));
        v("spring", &MouseJoint::spring, about("how it gets there; its target is not read"));
        v("max_force", &MouseJoint::max_force, {.what = "", .unit = "N", .min = 0, .max = any_force});
    }
};
template <>
struct Fields<GearJoint>
{
    static constexpr const char* name = "gear";
    static constexpr const char* what =
        "Keeps q_a + ratio q_b as it was when the joint was made, where q is how far a body has turned or slid.";
    template <class V>
    static void visit(V& v)
    {
        v("ratio", &GearJoint::ratio, {.what = "not 0", .min = -any_factor, .max = any_factor});
        v("motion_a", &GearJoint::motion_a, about("slide: along the x axis of the body's frame"));
        v("motion_b", &GearJoint::motion_b, about(""));
    }
};
template <>
struct Fields<PulleyJoint>
{
    static constexpr const char* name = "pulley";
    static constexpr const char* what = "A rope over two fixed points: length_a + ratio length_b <= length.";
    template <class V>
    static void visit(V& v)
    {
        v("ground_a", &PulleyJoint::ground_a, place("in the world"));
        v("ground_b", &PulleyJoint::ground_b, place("in the world"));
        v("ratio", &PulleyJoint::ratio, {.what = "", .min = 1e-6, .max = any_factor});
        v("length", &PulleyJoint::length, {.what = "of the rope", .unit = "m", .min = 0.001f, .max = 2.0 * max_coordinate});
    }
};
template <>
struct Fields<Transform>
{
    static constexpr const char* name = "frame";
    static constexpr const char* what = "A frame seen from a body's origin.";
    template <class V>
    static void visit(V& v)
    {
        v("p", &Transform::p, place("origin"));
        v("q", &Transform::q, {.what = "its x axis, of length 1: [cosine, sine] of its angle", .min = -1.001, .max = 1.001});
    }
};
template <>
struct Fields<JointDef>
{
    template <class V>
    static void visit(V& v)
    {
        v("frame_a", &JointDef::frame_a, about("seen from body A's origin; without a body A, from the world's"));
        v("frame_b", &JointDef::frame_b, about("seen from body B's origin"));
        v("collide_connected", &JointDef::collide_connected, about("whether the two bodies can touch each other"));
        v("break_force", &JointDef::break_force,
          {.what = "a larger force destroys the joint; left out for never", .unit = "N", .min = 0, .max = 1e30, .is_above_min = true});
        v("break_torque", &JointDef::break_torque,
          {.what = "a larger torque destroys the joint; left out for never", .unit = "N m", .min = 0, .max = 1e30, .is_above_min = true});
        v("user_data", &JointDef::user_data, about("the program's own"));
    }
};
template <>
struct Fields<FileJoint>
{
    static constexpr const char* name = "joint";
    static constexpr const char* what = "A joint: its bodies, its frames, and its type as the key of what it is besides.";
    template <class V>
    static void visit(V& v)
    {
        v("name", &FileJoint::name, about("may repeat"));
        v("body_a", &FileJoint::body_a, number_of_body("number of the body; left out: the world itself", false));
        v("body_b", &FileJoint::body_b, number_of_body("number of the body, another than body_a", true));
        v.flat(&FileJoint::def);
        v.choice(&FileJoint::spec, {.what = "", .is_required = true});
    }
};

} // namespace carom::scene_file
