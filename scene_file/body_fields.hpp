// The fields of bodies in a scene file.
#pragma once

#include "scene_file/shape_fields.hpp"

namespace carom::scene_file
{

template <>
struct Fields<MotionLocks>
{
    static constexpr const char* name = "locks";
    static constexpr const char* what = "Directions in which a dynamic body can't move.";
    template <class V>
    static void visit(V& v)
    {
        v("x", &MotionLocks::x, about(""));
        v("y", &MotionLocks::y, about(""));
        v("rotation", &MotionLocks::rotation, about(""));
    }
};
template <>
struct Fields<MassData>
{
    static constexpr const char* name = "mass_data";
    static constexpr const char* what = "Mass, its centre, and its resistance to turning.";
    template <class V>
    static void visit(V& v)
    {
        v("mass", &MassData::mass, {.what = "", .unit = "kg", .min = 0, .max = any_force, .is_required = true});
        v("center", &MassData::center, place("in the body's frame"));
        v("inertia", &MassData::inertia,
          {.what = "about the centre of mass", .unit = "kg m^2", .min = 0, .max = any_force, .is_required = true});
    }
};
template <>
struct Fields<BodyDef>
{
    template <class V>
    static void visit(V& v)
    {
        v("type", &BodyDef::type, about(""));
        v("position", &BodyDef::position, place("of the origin"));
        v("angle", &BodyDef::angle, {.what = "", .unit = "rad", .min = -1e30, .max = 1e30});
        v("linear_velocity", &BodyDef::linear_velocity, speed("of the centre of mass; not of a static body"));
        v("angular_velocity", &BodyDef::angular_velocity, speed("not of a static body", "rad/s"));
        v("linear_damping", &BodyDef::linear_damping, factor("rate at which the velocity decays", "1/s"));
        v("angular_damping", &BodyDef::angular_damping, factor("rate at which the spin decays", "1/s"));
        v("gravity_scale", &BodyDef::gravity_scale, {.what = "multiplies gravity and fields", .min = -any_factor, .max = any_factor});
        v("locks", &BodyDef::locks, about(""));
        v("can_sleep", &BodyDef::can_sleep, about("may sleep when it has come to rest"));
        v("is_bullet", &BodyDef::is_bullet, about("is kept from passing through others however it moves"));
        v("is_attractor", &BodyDef::is_attractor, about("pulls others through an n_body field with the sources attractors"));
        v("is_enabled", &BodyDef::is_enabled, about("a disabled body takes no part"));
        v("user_data", &BodyDef::user_data, about("the program's own"));
    }
};
template <>
struct Fields<FileBody>
{
    static constexpr const char* name = "body";
    static constexpr const char* what = "A body.";
    template <class V>
    static void visit(V& v)
    {
        v("name", &FileBody::name, about("may repeat"));
        v.flat(&FileBody::def);
        v("is_awake", &FileBody::is_awake, about("false: it sleeps from the start; not of a static body"));
        v("mass_data", &FileBody::mass_data, about("instead of what the shapes give"));
        v("shapes", &FileBody::shapes, {.what = "made in this order, before the next body", .max = most_file_shapes});
        v("chains", &FileBody::chains, {.what = "made after the shapes", .max = most_file_shapes});
    }
};

} // namespace carom::scene_file
