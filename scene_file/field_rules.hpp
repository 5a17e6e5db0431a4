// Which fields a scene file has: their names, what they mean, and what they may be. The reader, the writer and the schema all walk these lists, so
// that none of them knows a field that another does not.
//
// Fields<T>::visit calls visitor(name, pointer to member, rule) for each field, visitor.flat(pointer to member) for a part whose fields belong to
// the object itself, and visitor.choice(pointer to member, rule) where one of several keys says which kind of thing follows.
#pragma once

#include "scene_file/model.hpp"

#include <limits>
#include <string_view>

namespace carom::scene_file
{

/// What may stand in a field, and what is said about it.
struct Rule
{
    const char* what;                                      ///< for the schema
    const char* unit = "";                                 ///< of a number or a vector
    double min = -std::numeric_limits<double>::infinity(); ///< of a number, of each coordinate of a vector, of the length of a list
    double max = std::numeric_limits<double>::infinity();
    bool is_above_min = false; ///< min itself is not allowed
    bool is_required = false;
};

inline constexpr double any_factor = 1e6;
inline constexpr double any_force = 1e20;

/// A place or a length along an axis.
constexpr Rule place(const char* what) { return {.what = what, .unit = "m", .min = -max_coordinate, .max = max_coordinate}; }
constexpr Rule length_of(const char* what, double min = 0) { return {.what = what, .unit = "m", .min = min, .max = max_coordinate}; }
constexpr Rule speed(const char* what, const char* unit = "m/s")
{
    return {.what = what, .unit = unit, .min = -max_speed, .max = max_speed};
}
constexpr Rule factor(const char* what, const char* unit = "") { return {.what = what, .unit = unit, .min = 0, .max = any_factor}; }
constexpr Rule about(const char* what) { return {.what = what}; }
constexpr Rule number_of_body(const char* what, bool is_required)
{
    return {.what = what, .min = 0, .max = most_file_bodies - 1.0, .is_required = is_required};
}

template <class T>
struct Fields;

// The words for enumerators, in their order.
template <class Enum>
struct Words;
template <>
struct Words<BodyType>
{
    static constexpr std::string_view all[] = {"static", "kinematic", "dynamic"};
};
template <>
struct Words<ChainSides>
{
    static constexpr std::string_view all[] = {"two_sided", "one_sided"};
};
template <>
struct Words<Mix>
{
    static constexpr std::string_view all[] = {"geometric_mean", "average", "minimum", "maximum", "product"};
};
template <>
struct Words<GearMotion>
{
    static constexpr std::string_view all[] = {"turn", "slide"};
};
template <>
struct Words<NBodyMethod>
{
    static constexpr std::string_view all[] = {"direct", "barnes_hut"};
};
template <>
struct Words<NBodySources>
{
    static constexpr std::string_view all[] = {"attractors", "all"};
};

// The keys for the alternatives of a variant, in their order.
template <class Variant>
struct Keys;
template <>
struct Keys<Geometry>
{
    static constexpr std::string_view all[] = {"circle", "capsule", "segment", "polygon"};
};
template <>
struct Keys<JointSpec>
{
    static constexpr std::string_view all[] = {"revolute", "prismatic", "distance", "weld", "wheel", "motor", "mouse", "gear", "pulley"};
};
template <>
struct Keys<Field>
{
    static constexpr std::string_view all[] = {"uniform", "point", "n_body"};
};

} // namespace carom::scene_file
