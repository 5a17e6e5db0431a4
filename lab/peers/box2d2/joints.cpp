// The engine's joints hold angles against angles that only grow, springs by stiffness rather than frequency, and no frames.
#include "lab/peers/box2d2/joints.hpp"

#include <cmath>
#include <numbers>

namespace carom::lab::box2d2
{

namespace
{

float angle_of(Rot q) { return std::atan2(q.s, q.c); }

/// What the angle of B less that of A is where both frames point the same way, on the turn that the bodies are on now.
float reference_angle(const FileJoint& joint, const b2Body& a, const b2Body& b)
{
    constexpr float turn = 2 * std::numbers::pi_v<float>;
    const float reference = angle_of(joint.def.frame_a.q) - angle_of(joint.def.frame_b.q);
    const float now = b.GetAngle() - a.GetAngle() - reference;
    return reference + turn * std::round(now / turn);
}

template <class Def>
Def def_of(const FileJoint& joint, b2Body& a, b2Body& b)
{
    Def def;
    def.bodyA = &a;
    def.bodyB = &b;
    def.collideConnected = joint.def.collide_connected;
    return def;
}

template <class Def>
Def anchored_def_of(const FileJoint& joint, b2Body& a, b2Body& b)
{
    auto def = def_of<Def>(joint, a, b);
    def.localAnchorA = vec2(joint.def.frame_a.p);
    def.localAnchorB = vec2(joint.def.frame_b.p);
    return def;
}

template <class Def>
void limit_translation(Def& def, const std::optional<Range>& limit)
{
    def.enableLimit = limit.has_value();
    if (!limit) return;
    def.lowerTranslation = limit->lower;
    def.upperTranslation = limit->upper;
}

template <class Def>
void turn_by_motor(Def& def, const std::optional<Motor>& motor)
{
    def.enableMotor = motor.has_value();
    if (!motor) return;
    def.motorSpeed = motor->speed;
    def.maxMotorTorque = motor->max_force;
}

b2Vec2 axis_of(const Transform& frame) { return {frame.q.c, frame.q.s}; }

/// Makes the definition of each type of joint and hands it to the world.
struct Maker
{
    b2World& world;
    const FileJoint& joint;
    b2Body& a;
    b2Body& b;

    b2Joint* operator()(const RevoluteJoint& spec) const
    {
        auto def = anchored_def_of<b2RevoluteJointDef>(joint, a, b);
        def.referenceAngle = reference_angle(joint, a, b);
        def.enableLimit = spec.limit.has_value();
        if (spec.limit) def.lowerAngle = spec.limit->lower;
        if (spec.limit) def.upperAngle = spec.limit->upper;
        turn_by_motor(def, spec.motor);
        return world.CreateJoint(&def);
    }

    b2Joint* operator()(const PrismaticJoint& spec) const
    {
        auto def = anchored_def_of<b2PrismaticJointDef>(joint, a, b);
        def.referenceAngle = reference_angle(joint, a, b);
        def.localAxisA = axis_of(joint.def.frame_a);
        limit_translation(def, spec.limit);
        def.enableMotor = spec.motor.has_value();
        if (spec.motor) def.motorSpeed = spec.motor->speed;
        if (spec.motor) def.maxMotorForce = spec.motor->max_force;
        return world.CreateJoint(&def);
    }

    b2Joint* operator()(const DistanceJoint& spec) const
    {
        auto def = anchored_def_of<b2DistanceJointDef>(joint, a, b);
        const bool is_rod = !spec.spring && !spec.limit;
        def.length = spec.length;
        def.minLength = spec.limit ? spec.limit->lower : is_rod ? spec.length : 0.0f;
        def.maxLength = spec.limit ? spec.limit->upper : is_rod ? spec.length : b2_maxFloat;
        if (spec.spring) b2LinearStiffness(def.stiffness, def.damping, spec.spring->hertz, spec.spring->damping_ratio, &a, &b);
        return world.CreateJoint(&def);
    }

    b2Joint* operator()(const WeldJoint& spec) const
    {
        auto def = anchored_def_of<b2WeldJointDef>(joint, a, b);
        def.referenceAngle = reference_angle(joint, a, b);
        if (spec.angular) b2AngularStiffness(def.stiffness, def.damping, spec.angular->hertz, spec.angular->damping_ratio, &a, &b);
        return world.CreateJoint(&def);
    }

    b2Joint* operator()(const WheelJoint& spec) const
    {
        auto def = anchored_def_of<b2WheelJointDef>(joint, a, b);
        def.localAxisA = axis_of(joint.def.frame_a);
        limit_translation(def, spec.limit);
        turn_by_motor(def, spec.motor);
        if (spec.suspension) b2LinearStiffness(def.stiffness, def.damping, spec.suspension->hertz, spec.suspension->damping_ratio, &a, &b);
        return world.CreateJoint(&def);
    }

    b2Joint* operator()(const MotorJoint& spec) const
    {
        // The engine leads the origin of B: where is it when frame B is where it shall be?
        const b2Transform frame_a(vec2(joint.def.frame_a.p), b2Rot(angle_of(joint.def.frame_a.q)));
        const float turn = spec.angle - angle_of(joint.def.frame_b.q);
        const b2Vec2 back = b2Mul(b2Rot(turn), -vec2(joint.def.frame_b.p));
        auto def = def_of<b2MotorJointDef>(joint, a, b);
        def.linearOffset = b2Mul(frame_a, vec2(spec.offset) + back);
        def.angularOffset = angle_of(joint.def.frame_a.q) + turn;
        def.maxForce = spec.max_force;
        def.maxTorque = spec.max_torque;
        return world.CreateJoint(&def);
    }

    b2Joint* operator()(const MouseJoint& spec) const
    {
        // The engine takes the point of the body from where the target is at the start.
        auto def = def_of<b2MouseJointDef>(joint, a, b);
        def.target = b.GetWorldPoint(vec2(joint.def.frame_b.p));
        def.maxForce = spec.max_force;
        b2LinearStiffness(def.stiffness, def.damping, spec.spring.hertz, spec.spring.damping_ratio, &a, &b);
        auto* made = static_cast<b2MouseJoint*>(world.CreateJoint(&def));
        made->SetTarget(vec2(spec.target));
        return made;
    }

    b2Joint* operator()(const GearJoint&) const { throw Lacking("gear_joints"); }

    b2Joint* operator()(const PulleyJoint& spec) const
    {
        auto def = anchored_def_of<b2PulleyJointDef>(joint, a, b);
        def.groundAnchorA = vec2(spec.ground_a);
        def.groundAnchorB = vec2(spec.ground_b);
        def.ratio = spec.ratio;
        def.lengthA = spec.length; // the engine keeps length_a + ratio length_b, and nothing else of the two
        def.lengthB = 0;
        return world.CreateJoint(&def);
    }
};

} // namespace

b2Joint* create_joint(b2World& world, const FileJoint& made_as, const JointSpec& spec, b2Body& a, b2Body& b)
{
    return std::visit(Maker{world, made_as, a, b}, spec);
}

bool change_joint(b2Joint& joint, const SetJoint& set)
{
    const auto* mouse = set.spec ? std::get_if<MouseJoint>(&*set.spec) : nullptr;
    if (mouse)
    {
        auto& made = static_cast<b2MouseJoint&>(joint);
        float stiffness = 0;
        float damping = 0;
        b2LinearStiffness(stiffness, damping, mouse->spring.hertz, mouse->spring.damping_ratio, joint.GetBodyA(), joint.GetBodyB());
        made.SetStiffness(stiffness);
        made.SetDamping(damping);
        made.SetMaxForce(mouse->max_force);
        made.SetTarget(vec2(mouse->target));
        return true;
    }
    if (!set.motor_speed) return false;
    switch (joint.GetType())
    {
    case e_revoluteJoint: static_cast<b2RevoluteJoint&>(joint).SetMotorSpeed(*set.motor_speed); break;
    case e_prismaticJoint: static_cast<b2PrismaticJoint&>(joint).SetMotorSpeed(*set.motor_speed); break;
    default: static_cast<b2WheelJoint&>(joint).SetMotorSpeed(*set.motor_speed); break;
    }
    return true;
}

std::string lacks(const JointSpec& spec)
{
    const auto* revolute = std::get_if<RevoluteJoint>(&spec);
    const auto* prismatic = std::get_if<PrismaticJoint>(&spec);
    const auto* weld = std::get_if<WeldJoint>(&spec);
    if (std::holds_alternative<GearJoint>(spec)) return "gear_joints (they join joints there, not bodies)";
    if (revolute && revolute->spring) return "springs on revolute_joints";
    if (prismatic && prismatic->spring) return "springs on prismatic_joints";
    if (weld && weld->linear) return "linear springs in weld_joints";
    return "";
}

void add_differences(std::vector<std::string>& list, const JointSpec& spec)
{
    const auto* wheel = std::get_if<WheelJoint>(&spec);
    if (std::holds_alternative<MotorJoint>(spec))
        list.emplace_back("motor joints correct 0.3 of their error a step, instead of by a spring");
    if (std::holds_alternative<PulleyJoint>(spec)) list.emplace_back("the rope of a pulley also pushes");
    if (wheel && wheel->suspension && wheel->suspension->target != 0)
        list.emplace_back("the suspension of a wheel is at rest at 0, not at its target");
}

} // namespace carom::lab::box2d2
