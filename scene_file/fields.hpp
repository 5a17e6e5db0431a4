// The fields of a scene file: of its events, its world and the whole; with those of bodies and joints.
#pragma once

#include "scene_file/body_fields.hpp"
#include "scene_file/joint_fields.hpp"

namespace carom::scene_file
{

template <>
struct Fields<SetBody>
{
    static constexpr const char* name = "set_body";
    static constexpr const char* what = "Changes what is given of a body, in the order of this list, and nothing else.";
    template <class V>
    static void visit(V& v)
    {
        v("body", &SetBody::body, number_of_body("number of the body", true));
        v("type", &SetBody::type, about(""));
        v("position", &SetBody::position, place("teleports the origin; without an angle, that stays"));
        v("angle", &SetBody::angle, {.what = "without a position, that stays", .unit = "rad", .min = -1e30, .max = 1e30});
        v("linear_velocity", &SetBody::linear_velocity, speed("of the centre of mass"));
        v("angular_velocity", &SetBody::angular_velocity, speed("", "rad/s"));
        v("linear_damping", &SetBody::linear_damping, factor("", "1/s"));
        v("angular_damping", &SetBody::angular_damping, factor("", "1/s"));
        v("gravity_scale", &SetBody::gravity_scale, {.what = "", .min = -any_factor, .max = any_factor});
        v("locks", &SetBody::locks, about(""));
        v("can_sleep", &SetBody::can_sleep, about(""));
        v("is_bullet", &SetBody::is_bullet, about(""));
        v("is_attractor", &SetBody::is_attractor, about(""));
        v("is_enabled", &SetBody::is_enabled, about(""));
        v("is_awake", &SetBody::is_awake, about("false: it sleeps at once, with all that it touches or is joined to"));
    }
};
template <>
struct Fields<SetJoint>
{
    static constexpr const char* name = "set_joint";
    static constexpr const char* what =
        "Changes a joint: the speed of its motor, or all that its type holds. A joint that broke stays away.";
    template <class V>
    static void visit(V& v)
    {
        v("joint", &SetJoint::joint, {.what = "number of the joint", .min = 0, .max = most_file_joints - 1.0, .is_required = true});
        v("motor_speed", &SetJoint::motor_speed, speed("of a joint that has a motor", "rad/s or m/s"));
        v.choice(&SetJoint::spec, about(""));
    }
};
template <>
struct Fields<SetWorld>
{
    static constexpr const char* name = "set_world";
    static constexpr const char* what = "Changes what is given of the world.";
    template <class V>
    static void visit(V& v)
    {
        v("gravity", &SetWorld::gravity, {.what = "", .unit = "m/s^2", .min = -any_factor, .max = any_factor});
    }
};
template <>
struct Fields<FileEvent>
{
    static constexpr const char* name = "event";
    static constexpr const char* what = "What happens right before a step, in the order of this list.";
    template <class V>
    static void visit(V& v)
    {
        v("step", &FileEvent::step,
          {.what = "counted from 0, not less than that of the event before", .min = 0, .max = most_file_steps, .is_required = true});
        v("destroy_joints", &FileEvent::destroy_joints, {.what = "numbers", .max = most_file_joints});
        v("destroy_bodies", &FileEvent::destroy_bodies, {.what = "numbers; their joints go with them", .max = most_file_bodies});
        v("create_bodies", &FileEvent::create_bodies, {.what = "", .max = most_file_bodies});
        v("create_joints", &FileEvent::create_joints, {.what = "", .max = most_file_joints});
        v("set_world", &FileEvent::set_world, about(""));
        v("set_bodies", &FileEvent::set_bodies, {.what = "", .max = most_file_bodies});
        v("set_joints", &FileEvent::set_joints, {.what = "", .max = most_file_joints});
    }
};

// The world.
template <>
struct Fields<SleepTuning>
{
    static constexpr const char* name = "sleep";
    static constexpr const char* what = "When bodies that have come to rest leave the simulation.";
    template <class V>
    static void visit(V& v)
    {
        v("is_enabled", &SleepTuning::is_enabled, about(""));
        v("speed", &SleepTuning::speed, factor("speed of the body's fastest point below which it rests", "length units/s"));
        v("time", &SleepTuning::time, factor("how long it must rest", "s"));
    }
};
template <>
struct Fields<SolverTuning>
{
    static constexpr const char* name = "solver";
    static constexpr const char* what = "Constants of Carom's solver; other engines may not have them.";
    template <class V>
    static void visit(V& v)
    {
        v("contact_hertz", &SolverTuning::contact_hertz, {.what = "stiffness of contacts", .unit = "1/s", .min = 0.01f, .max = any_factor});
        v("contact_damping_ratio", &SolverTuning::contact_damping_ratio, factor(""));
        v("push_out_speed", &SolverTuning::push_out_speed,
          {.what = "most speed at which overlap is undone", .unit = "length units/s", .min = 0.0001f, .max = any_factor});
        v("restitution_threshold", &SolverTuning::restitution_threshold, factor("slower approaches do not bounce", "length units/s"));
        v("joint_hertz", &SolverTuning::joint_hertz,
          {.what = "how fast joints undo their errors", .unit = "1/s", .min = 0.01f, .max = any_factor});
        v("joint_damping_ratio", &SolverTuning::joint_damping_ratio, factor(""));
        v("warm_starting", &SolverTuning::warm_starting, about("the impulses of a step are the first guess of the next"));
    }
};
template <>
struct Fields<MaterialMixing>
{
    static constexpr const char* name = "mixing";
    static constexpr const char* what = "How properties of two surfaces become one of their contact.";
    template <class V>
    static void visit(V& v)
    {
        v("friction", &MaterialMixing::friction, about(""));
        v("restitution", &MaterialMixing::restitution, about(""));
    }
};
template <>
struct Fields<UniformField>
{
    static constexpr const char* name = "uniform";
    static constexpr const char* what = "The same acceleration everywhere, on top of gravity.";
    template <class V>
    static void visit(V& v)
    {
        v("acceleration", &UniformField::acceleration, {.what = "", .unit = "m/s^2", .min = -any_factor, .max = any_factor});
    }
};
template <>
struct Fields<PointField>
{
    static constexpr const char* name = "point";
    static constexpr const char* what =
        "Pull towards a fixed point: strength d / (|d|^2 + softening^2)^(3/2), with d from the body to the point.";
    template <class V>
    static void visit(V& v)
    {
        v("center", &PointField::center, place(""));
        v("strength", &PointField::strength,
          {.what = "gravitational constant times mass; negative pushes away", .unit = "m^3/s^2", .min = -any_force, .max = any_force});
        v("softening", &PointField::softening, length_of(""));
    }
};
template <>
struct Fields<NBodyField>
{
    static constexpr const char* name = "n_body";
    static constexpr const char* what =
        "Newton's pull between bodies: a source of mass m at d from a body adds G m d / (|d|^2 + softening^2)^(3/2) to its acceleration.";
    template <class V>
    static void visit(V& v)
    {
        v("gravitational_constant", &NBodyField::gravitational_constant,
          {.what = "G", .unit = "m^3/(kg s^2)", .min = -any_force, .max = any_force});
        v("softening", &NBodyField::softening, length_of(""));
        v("method", &NBodyField::method, about("direct: every pair; barnes_hut: far groups as one mass"));
        v("sources", &NBodyField::sources, about("all bodies that have mass, or those that are attractors"));
        v("opening_angle", &NBodyField::opening_angle,
          {.what = "of Barnes-Hut: a node of side w at distance d counts as one mass when w / d is less", .min = 0, .max = 1.5});
    }
};
template <>
struct Fields<FileWorld>
{
    static constexpr const char* name = "world";
    static constexpr const char* what = "What holds for the whole world.";
    template <class V>
    static void visit(V& v)
    {
        v("gravity", &FileWorld::gravity, {.what = "", .unit = "m/s^2", .min = -any_factor, .max = any_factor});
        v("continuous", &FileWorld::continuous, about("fast bodies are stopped at what they would pass through"));
        v("sleep", &FileWorld::sleep, about(""));
        v("solver", &FileWorld::solver, about(""));
        v("mixing", &FileWorld::mixing, about(""));
        v("hit_speed", &FileWorld::hit_speed, factor("slower collisions are not reported as hits", "length units/s"));
        v("length_unit", &FileWorld::length_unit,
          {.what = "typical size of a body; Carom's tolerances are shares of it",
           .unit = "m",
           .min = min_length_unit,
           .max = max_length_unit});
        v("max_pairs", &FileWorld::max_pairs,
          {.what = "most pairs of near shapes before a step is refused; 0 lets the engine choose", .min = 0, .max = 1 << 30});
        v("fields", &FileWorld::fields, {.what = "gravity fields, each under its kind: uniform, point, n_body", .max = 1000});
    }
};

// The whole.
template <>
struct Fields<Ray>
{
    static constexpr const char* name = "ray";
    static constexpr const char* what = "A ray, cast for the nearest hit.";
    template <class V>
    static void visit(V& v)
    {
        constexpr double most = max_coordinate;
        v("start", &Ray::start, {.what = "", .unit = "m", .min = -most, .max = most, .is_required = true});
        v("sweep", &Ray::sweep, {.what = "from the start to the end", .unit = "m", .min = -most, .max = most, .is_required = true});
    }
};
template <>
struct Fields<FileView>
{
    static constexpr const char* name = "view";
    static constexpr const char* what = "What a picture of the scene should show.";
    template <class V>
    static void visit(V& v)
    {
        v("center", &FileView::center, place(""));
        v("height", &FileView::height, {.what = "", .unit = "m", .min = 0.001f, .max = max_coordinate, .is_required = true});
    }
};
template <>
struct Fields<SceneFile>
{
    static constexpr const char* name = "scene";
    static constexpr const char* what =
        "A simulation: a world, its bodies and joints, and what happens to them. Lengths are in metres, masses in "
        "kilograms, times in seconds, angles in radians.";
    template <class V>
    static void visit(V& v)
    {
        v("carom_scene", &SceneFile::version,
          {.what = "version of the format", .min = scene_file_version, .max = scene_file_version, .is_required = true});
        v("name", &SceneFile::name, about(""));
        v("description", &SceneFile::description, about(""));
        v("notes", &SceneFile::notes, {.what = "what the file could not hold of what it was made from", .max = 1000});
        v("needs", &SceneFile::needs,
          {.what = "what an engine must have to run the scene; when left out, follows from the rest", .max = 1000});
        v("time_step", &SceneFile::time_step, {.what = "", .unit = "s", .min = 1e-6f, .max = 1});
        v("substeps", &SceneFile::substeps, {.what = "parts into which a step is divided", .min = 1, .max = 64});
        v("steps", &SceneFile::steps, {.what = "how long the scene runs", .min = 1, .max = most_file_steps});
        v("view", &SceneFile::view, about(""));
        v("world", &SceneFile::world, about(""));
        v("bodies", &SceneFile::bodies, {.what = "numbered from 0; those that events create follow", .max = most_file_bodies});
        v("joints", &SceneFile::joints, {.what = "numbered from 0; those that events create follow", .max = most_file_joints});
        v("events", &SceneFile::events, {.what = "by step", .max = most_file_events});
        v("rays", &SceneFile::rays, {.what = "cast after every step", .max = most_file_rays});
    }
};

} // namespace carom::scene_file
