// The ranges of what a joint may be.
#include "api/validate.hpp"

#include <string>

namespace carom::detail
{

namespace
{

constexpr float max_hertz = 1e4f;

void validate_range(const std::optional<Range>& range, float least, float most, std::string_view function)
{
    if (!range) return;
    require_range(function, "limit.lower", range->lower, least, most);
    require_range(function, "limit.upper", range->upper, least, most);
    if (range->lower > range->upper) usage_error(function, "limit.lower", range->lower, "give a value that is not above limit.upper");
}

void validate_motor(const std::optional<Motor>& motor, std::string_view function)
{
    if (!motor) return;
    require_range(function, "motor.speed", motor->speed, -max_speed, max_speed);
    require_range(function, "motor.max_force", motor->max_force, 0, max_joint_force);
}

void validate_spring(const std::optional<Spring>& spring, std::string_view function)
{
    if (!spring) return;
    require_range(function, "spring.hertz", spring->hertz, 0, max_hertz);
    require_range(function, "spring.damping_ratio", spring->damping_ratio, 0, max_factor);
    require_range(function, "spring.target", spring->target, -max_coordinate, max_coordinate);
}

constexpr float max_angle_rad = 1e5f; // beyond, float no longer tells the turns apart well

void validate_spec(const RevoluteJoint& s, std::string_view function)
{
    validate_range(s.limit, -max_angle_rad, max_angle_rad, function);
    validate_motor(s.motor, function);
    validate_spring(s.spring, function);
}

void validate_spec(const PrismaticJoint& s, std::string_view function)
{
    validate_range(s.limit, -max_coordinate, max_coordinate, function);
    validate_motor(s.motor, function);
    validate_spring(s.spring, function);
}

void validate_spec(const DistanceJoint& s, std::string_view function, const Tolerances& tolerances)
{
    require_range(function, "length", s.length, tolerances.min_edge_length, max_coordinate);
    validate_range(s.limit, 0, max_coordinate, function);
    validate_spring(s.spring, function);
}

void validate_spec(const WeldJoint& s, std::string_view function)
{
    validate_spring(s.linear, function);
    validate_spring(s.angular, function);
}

void validate_spec(const WheelJoint& s, std::string_view function)
{
    validate_spring(s.suspension, function);
    validate_range(s.limit, -max_coordinate, max_coordinate, function);
    validate_motor(s.motor, function);
}

void validate_spec(const MotorJoint& s, std::string_view function)
{
    require_within(function, "offset", s.offset, max_coordinate);
    require_range(function, "angle", s.angle, -pi, pi);
    validate_spring(s.spring, function);
    require_range(function, "max_force", s.max_force, 0, max_joint_force);
    require_range(function, "max_torque", s.max_torque, 0, max_joint_force);
}

void validate_spec(const MouseJoint& s, std::string_view function)
{
    require_within(function, "target", s.target, max_coordinate);
    validate_spring(s.spring, function);
    require_range(function, "max_force", s.max_force, 0, max_joint_force);
}

void validate_spec(const GearJoint& s, std::string_view function)
{
    require_range(function, "ratio", s.ratio, -max_factor, max_factor);
    if (std::abs(s.ratio) < 1 / max_factor) usage_error(function, "ratio", s.ratio, "give a ratio of at least 1e-6 in size");
    for (const GearMotion motion : {s.motion_a, s.motion_b})
        if (motion != GearMotion::Turn && motion != GearMotion::Slide)
            usage_error(function, "motion", static_cast<int>(motion), "give a GearMotion");
}

void validate_spec(const PulleyJoint& s, std::string_view function, const Tolerances& tolerances)
{
    require_within(function, "ground_a", s.ground_a, max_coordinate);
    require_within(function, "ground_b", s.ground_b, max_coordinate);
    require_range(function, "ratio", s.ratio, 1 / max_factor, max_factor);
    require_range(function, "length", s.length, tolerances.min_edge_length, 2 * max_coordinate);
}

} // namespace

void validate_frame(const Transform& frame, std::string_view field, std::string_view function)
{
    const std::string name(field);
    require_within(function, name + ".p", frame.p, max_coordinate);
    const float size = frame.q.c * frame.q.c + frame.q.s * frame.q.s;
    if (!(std::abs(size - 1) < 1e-3f)) usage_error(function, name + ".q", size, "give a rotation of length 1, made by rotation()");
}

void validate_break_limit(float limit, std::string_view field, std::string_view function)
{
    if (!(limit > 0)) usage_error(function, field, limit, "give a value above 0, or infinity for never");
}

void validate(const WorldState& world, const JointDef& def, std::string_view function)
{
    if (def.body_a) require_body(world, def.body_a, function, "body_a");
    require_body(world, def.body_b, function, "body_b");
    if (def.body_a == def.body_b)
        usage_error(function, "body_b", std::string_view("the same as body_a"), "give two bodies, or null as body_a for the world");
    validate_frame(def.frame_a, "frame_a", function);
    validate_frame(def.frame_b, "frame_b", function);
    validate_break_limit(def.break_force, "break_force", function);
    validate_break_limit(def.break_torque, "break_torque", function);
}

void validate(const JointSpec& spec, std::string_view function, const Tolerances& tolerances)
{
    if (spec.valueless_by_exception()) usage_error(function, "spec", std::string_view("empty"), "give a joint's spec");
    std::visit([&](const auto& s)
    {
        if constexpr (requires { validate_spec(s, function, tolerances); }) // has a length that must not be 0
            validate_spec(s, function, tolerances);
        else
            validate_spec(s, function);
    }, spec);
}

void validate_ends(const JointDef& def, const JointSpec& spec, std::string_view function)
{
    if (std::holds_alternative<MouseJoint>(spec) && def.body_a)
        usage_error(function, "body_a", std::string_view("a body"), "leave body_a of a mouse joint null: it pulls from the world");
    if (!def.body_a && (std::holds_alternative<GearJoint>(spec) || std::holds_alternative<PulleyJoint>(spec)))
        usage_error(function, "body_a", std::string_view("null"), "give two bodies: gears and pulleys join two that move");
}

} // namespace carom::detail
