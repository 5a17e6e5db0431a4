// The JSON of each kind of value in a scene file, with no field that is at its default. Used by the writer and by the schema alone.
#pragma once

#include "scene_file/polygon.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <concepts>
#include <nlohmann/json.hpp>
#include <type_traits>

namespace carom::scene_file
{

template <class T>
concept Described = requires { Fields<T>::what; };

/// The shortest decimal that comes back as the same float: 0.1 rather than 0.10000000149011612.
inline nlohmann::ordered_json json_of(float value)
{
    if (!std::isfinite(value)) throw SceneFileError({.source = "scene", .message = "can't hold a number that is not finite"});
    std::array<char, 40> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    double shortest = 0;
    std::from_chars(digits.data(), end, shortest);
    const bool is_whole = std::abs(value) < 1e7f && std::floor(value) == value && !(value == 0 && std::signbit(value));
    if (is_whole) return static_cast<std::int64_t>(value);
    return static_cast<float>(shortest) == value ? shortest : double{value};
}
inline nlohmann::ordered_json json_of(bool value) { return value; }
template <std::integral Int>
nlohmann::ordered_json json_of(Int value)
{
    return value;
}
inline nlohmann::ordered_json json_of(const std::string& value) { return value; }
inline nlohmann::ordered_json json_of(Vec2 v) { return {json_of(v.x), json_of(v.y)}; }
inline nlohmann::ordered_json json_of(Rot q) { return {json_of(q.c), json_of(q.s)}; }
template <class Enum>
    requires std::is_enum_v<Enum>
nlohmann::ordered_json json_of(Enum value)
{
    return Words<Enum>::all[static_cast<std::size_t>(value)];
}
template <Described T>
nlohmann::ordered_json json_of(const T& value);
inline nlohmann::ordered_json json_of(const Polygon& value) { return json_of(fields_of(value)); }
inline nlohmann::ordered_json json_of(const Field& value);
template <class T>
nlohmann::ordered_json json_of(const std::optional<T>& value)
{
    return value ? json_of(*value) : nlohmann::ordered_json(nullptr);
}
template <class T>
nlohmann::ordered_json json_of(const std::vector<T>& list)
{
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const T& element : list) json.push_back(json_of(element));
    return json;
}

// Whether a value may be left out. -0 is not 0: a scene that has it would go on to other bits.
inline bool are_same(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b); }
inline bool are_same(Vec2 a, Vec2 b) { return are_same(a.x, b.x) && are_same(a.y, b.y); }
inline bool are_same(Rot a, Rot b) { return are_same(a.c, b.c) && are_same(a.s, b.s); }
template <class T>
    requires std::integral<T> || std::is_enum_v<T>
bool are_same(T a, T b)
{
    return a == b;
}
inline bool are_same(const std::string& a, const std::string& b) { return a == b; }
template <class T>
bool are_same(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.empty() && b.empty();
}
template <Described T>
bool are_same(const T& a, const T& b)
{
    return json_of(a) == json_of(b);
}
template <class T>
bool are_same(const std::optional<T>& a, const std::optional<T>& b)
{
    return a.has_value() == b.has_value() && (!a || are_same(*a, *b));
}

/// Writes the fields of one value into an object.
template <class T>
class ObjectWriter
{
public:
    ObjectWriter(nlohmann::ordered_json& object, const T& value) : object_(object), value_(value) {}

    template <class M>
    void operator()(const char* name, M T::* member, const Rule& rule)
    {
        if (rule.is_required || !are_same(value_.*member, defaults_.*member)) object_[name] = json_of(value_.*member);
    }
    template <class M>
    void flat(M T::* member)
    {
        ObjectWriter<M> part(object_, value_.*member);
        Fields<M>::visit(part);
    }
    template <class M>
    void choice(M T::* member, const Rule&)
    {
        write_choice(value_.*member);
    }
    template <class Variant>
    void write_choice(const Variant& value)
    {
        std::visit([&](const auto& chosen) { object_[std::string(Keys<Variant>::all[value.index()])] = json_of(chosen); }, value);
    }
    template <class Variant>
    void write_choice(const std::optional<Variant>& value)
    {
        if (value) write_choice(*value);
    }

private:
    nlohmann::ordered_json& object_;
    const T& value_;
    const T defaults_ = {};
};

template <Described T>
nlohmann::ordered_json json_of(const T& value)
{
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    ObjectWriter<T> writer(object, value);
    Fields<T>::visit(writer);
    return object;
}

inline nlohmann::ordered_json json_of(const Field& value)
{
    return std::visit([&](const auto& field) -> nlohmann::ordered_json
    { return {{std::string(Keys<Field>::all[value.index()]), json_of(field)}}; }, value);
}

} // namespace carom::scene_file
