// Walks the fields of each part, and words what is wrong with a value.
#include "scene_file/reader.hpp"

#include "scene_file/check.hpp"
#include "scene_file/json_parts.hpp"
#include "scene_file/polygon.hpp"
#include "support/text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <type_traits>

namespace carom::scene_file
{

using nlohmann::json;

namespace
{

/// A place in the file: a field or an element, and what it lies in. Nothing is put into words unless something is wrong there.
struct Spot
{
    const Spot* parent = nullptr;
    std::string_view field = {};
    std::size_t index = 0;

    std::string text() const
    {
        const std::string before = parent ? parent->text() : "";
        if (field.empty()) return parent ? before + "[" + std::to_string(index) + "]" : before;
        return before + (before.empty() ? "" : ".") + std::string(field);
    }
};

std::string number_text(double value)
{
    std::array<char, 40> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.7g", value);
    return buffer.data();
}

/// Collects the names of all fields of an object.
struct FieldNames
{
    std::vector<std::string> names = {};

    template <class Member>
    void operator()(const char* name, Member, const Rule&)
    {
        names.emplace_back(name);
    }
    template <class C, class M>
    void flat(M C::*)
    {
        Fields<M>::visit(*this);
    }
    template <class C, class M>
    void choice(M C::*, const Rule&)
    {
        add_keys(static_cast<M*>(nullptr));
    }

private:
    template <class Variant>
    void add_keys(Variant*)
    {
        for (const std::string_view key : Keys<Variant>::all) names.emplace_back(key);
    }
    template <class Variant>
    void add_keys(std::optional<Variant>*)
    {
        add_keys(static_cast<Variant*>(nullptr));
    }
};

class Reader;

/// Reads the fields of one object into a value.
template <class T>
class ObjectReader
{
public:
    ObjectReader(const Reader& reader, const json& object, T& out, const Spot& spot, std::size_t& used)
        : reader_(reader),
          object_(object),
          out_(out),
          spot_(spot),
          used_(used)
    {
    }

    template <class M>
    void operator()(const char* name, M T::* member, const Rule& rule);
    template <class M>
    void flat(M T::* member)
    {
        ObjectReader<M> part(reader_, object_, out_.*member, spot_, used_);
        Fields<M>::visit(part);
    }
    template <class M>
    void choice(M T::* member, const Rule& rule);

private:
    const Reader& reader_;
    const json& object_;
    T& out_;
    const Spot& spot_;
    std::size_t& used_; ///< fields of the object that were known
};

class Reader
{
public:
    explicit Reader(const std::string& name) : name_(name) {}

    void read(const json& value, bool& out, const Rule&, const Spot& spot) const
    {
        if (!value.is_boolean()) refuse(spot, value, "give true or false");
        out = value.get<bool>();
    }
    void read(const json& value, std::string& out, const Rule&, const Spot& spot) const
    {
        if (!value.is_string()) refuse(spot, value, "give a text in quotes");
        out = value.get<std::string>();
    }
    void read(const json& value, float& out, const Rule& rule, const Spot& spot) const
    {
        const double given = value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
        const bool fits = std::abs(given) <= std::numeric_limits<float>::max(); // nor NaN
        const float number = fits ? static_cast<float>(given) : 0;
        const double low = rule.min;
        if (!fits || double{number} > rule.max || double{number} < low || (rule.is_above_min && double{number} <= low))
            refuse_number(spot, value, rule, "number");
        out = number;
    }
    template <std::integral Int>
    void read(const json& value, Int& out, const Rule& rule, const Spot& spot) const
    {
        if (!value.is_number_integer()) refuse_number(spot, value, rule, "whole number");
        const double rough = value.get<double>(); // exact wherever a rule's end is
        const bool is_negative = value.is_number_integer() && !value.is_number_unsigned() && value.get<std::int64_t>() < 0;
        if (rough < rule.min || rough > rule.max || (std::unsigned_integral<Int> && is_negative))
            refuse_number(spot, value, rule, "whole number");
        out = value.get<Int>();
    }
    void read(const json& value, Vec2& out, const Rule& rule, const Spot& spot) const { read_pair(value, out.x, out.y, rule, spot); }
    void read(const json& value, Rot& out, const Rule& rule, const Spot& spot) const
    {
        read_pair(value, out.c, out.s, rule, spot);
        if (std::abs(out.c * out.c + out.s * out.s - 1) > 1e-3f) refuse(spot, value, "give [cosine, sine] of an angle, of length 1");
    }
    template <class Enum>
        requires std::is_enum_v<Enum>
    void read(const json& value, Enum& out, const Rule&, const Spot& spot) const
    {
        const std::vector<std::string> words(std::begin(Words<Enum>::all), std::end(Words<Enum>::all));
        if (!value.is_string()) refuse(spot, value, "give one of " + support::joined(words));
        const auto found = std::find(words.begin(), words.end(), value.get_ref<const std::string&>());
        if (found == words.end()) refuse(spot, value, "it is none of the words; " + support::suggestion(value.get<std::string>(), words));
        out = static_cast<Enum>(found - words.begin());
    }
    template <class T>
    void read(const json& value, std::optional<T>& out, const Rule& rule, const Spot& spot) const
    {
        if (value.is_null()) return out.reset();
        read(value, out.emplace(), rule, spot);
    }
    /// Adds to what is there.
    template <class T>
    void read(const json& value, std::vector<T>& out, const Rule& rule, const Spot& spot) const
    {
        if (!value.is_array()) refuse(spot, value, "give a list in []");
        const auto count = static_cast<double>(value.size());
        if (count < rule.min) fail(spot, "holds " + number_text(count), "give at least " + number_text(rule.min));
        if (count > rule.max) fail(spot, "holds " + number_text(count), "give at most " + number_text(rule.max));
        out.reserve(out.size() + value.size());
        Spot place{&spot};
        for (const json& element : value) read(element, out.emplace_back(), bounds_of_element<T>(rule), place), ++place.index;
    }
    template <class T>
        requires requires { Fields<T>::what; }
    void read(const json& value, T& out, const Rule&, const Spot& spot) const
    {
        if (!value.is_object()) refuse(spot, value, "give an object in {}");
        std::size_t used = 0;
        ObjectReader<T> visitor(*this, value, out, spot, used);
        Fields<T>::visit(visitor);
        if (used < value.size()) refuse_unknown<T>(value, spot);
        if constexpr (std::is_same_v<T, FileShape>) check_geometry(out.geometry, spot);
    }
    void read(const json& value, Polygon& out, const Rule& rule, const Spot& spot) const
    {
        PolygonFields fields;
        read(value, fields, rule, spot);
        const std::size_t normals = fields.normals.size();
        if (normals != 0 && normals != fields.vertices.size())
            fail(spot, "has " + std::to_string(normals) + " normals", "give one for each vertex, or none");
        checked(spot, [&] { out = polygon_from(fields); });
    }
    void read(const json& value, Field& out, const Rule&, const Spot& spot) const
    {
        if (!value.is_object() || value.size() != 1) refuse(spot, value, "give an object with one of the keys " + key_list<Field>());
        if (read_choice(value, out, spot) != 1) refuse(spot, value, "give an object with one of the keys " + key_list<Field>());
    }

    /// @return how many of the object's fields are keys of the variant: 1 when it was read, or 0
    template <class... Ts>
    std::size_t read_choice(const json& object, std::variant<Ts...>& out, const Spot& spot) const
    {
        using Variant = std::variant<Ts...>;
        std::size_t chosen = std::size(Keys<Variant>::all);
        for (std::size_t i = 0; i < std::size(Keys<Variant>::all); ++i)
        {
            if (!object.contains(Keys<Variant>::all[i])) continue;
            if (chosen < i) fail(spot, "has both \"" + key<Variant>(chosen) + "\" and \"" + key<Variant>(i) + "\"", "give one of them");
            chosen = i;
        }
        if (chosen == std::size(Keys<Variant>::all)) return 0;
        const Spot inner{&spot, Keys<Variant>::all[chosen]};
        const json& value = object.at(key<Variant>(chosen));
        std::size_t at = 0;
        (void)((at++ == chosen ? (read(value, out.template emplace<Ts>(), about(""), inner), true) : false) || ...);
        return 1;
    }
    template <class Variant>
    std::size_t read_choice(const json& object, std::optional<Variant>& out, const Spot& spot) const
    {
        Variant value;
        const std::size_t used = read_choice(object, value, spot);
        if (used > 0) out = std::move(value);
        return used;
    }

    template <class Variant>
    static std::string key_list()
    {
        return support::joined(std::vector<std::string>(std::begin(Keys<Variant>::all), std::end(Keys<Variant>::all)));
    }

    [[noreturn]] void fail(const Spot& spot, const std::string& problem, const std::string& remedy) const
    {
        const std::string path = spot.text();
        throw SceneFileError(name_ + ": " + (path.empty() ? "the file" : path) + " " + problem + "; " + remedy);
    }

private:
    template <class Variant>
    static std::string key(std::size_t index)
    {
        return std::string(Keys<Variant>::all[index]);
    }

    /// The rule of a list bounds its length, but for numbers of bodies and joints, which can't be negative.
    template <class T>
    static Rule bounds_of_element(const Rule& rule)
    {
        if constexpr (std::is_same_v<T, int>) return {.what = "", .min = 0, .max = rule.max - 1};
        if constexpr (std::is_same_v<T, Vec2>) return {.what = "", .unit = "m", .min = -max_coordinate, .max = max_coordinate};
        return about("");
    }

    void read_pair(const json& value, float& first, float& second, const Rule& rule, const Spot& spot) const
    {
        if (!value.is_array() || value.size() != 2) refuse(spot, value, "give two numbers in []" + unit_text(rule));
        read(value[0], first, rule, {&spot, {}, 0});
        read(value[1], second, rule, {&spot, {}, 1});
    }

    template <class Action>
    void checked(const Spot& spot, const Action& action) const
    {
        try
        {
            action();
        }
        catch (const UsageError& error)
        {
            const std::string& field = error.field();
            const std::size_t dot = field.find("polygon."); // which the spot of a polygon has already
            fail({&spot, dot == 0 && spot.field == "polygon" ? field.substr(8) : field}, "is " + error.value(), error.remedy());
        }
    }

    void check_geometry(const Geometry& geometry, const Spot& spot) const
    {
        checked(spot, [&] { transformed(geometry, {}); });
    }

    template <class T>
    [[noreturn]] void refuse_unknown(const json& object, const Spot& spot) const
    {
        FieldNames known;
        Fields<T>::visit(known);
        for (const auto& item : object.items())
        {
            if (std::find(known.names.begin(), known.names.end(), item.key()) == known.names.end())
                fail(spot, "has an unknown field \"" + shortened(item.key()) + "\"", support::suggestion(item.key(), known.names));
        }
        fail(spot, "has fields that are not known", "give only those of the schema");
    }

    static std::string unit_text(const Rule& rule) { return *rule.unit ? std::string(" [") + rule.unit + "]" : ""; }

    [[noreturn]] void refuse_number(const Spot& spot, const json& value, const Rule& rule, const std::string& kind) const
    {
        const bool has_min = std::isfinite(rule.min);
        const bool has_max = std::isfinite(rule.max);
        std::string range;
        if (rule.min == rule.max) refuse(spot, value, "give " + number_text(rule.min) + ", the " + rule.what + " that this program reads");
        if (has_min && has_max && !rule.is_above_min) range = " from " + number_text(rule.min) + " to " + number_text(rule.max);
        if (has_min && rule.is_above_min)
        {
            const bool is_low = value.is_number() && value.get<double>() <= rule.min;
            range = " > " + number_text(rule.min) + (is_low || !has_max ? "" : " and at most " + number_text(rule.max));
        }
        if (!has_min && !has_max && kind == "whole number") range = " that is not negative";
        refuse(spot, value, "give a " + kind + range + unit_text(rule));
    }

    /// @param remedy what is expected instead
    [[noreturn]] void refuse(const Spot& spot, const json& value, const std::string& remedy) const
    {
        const bool is_whole = value.is_structured() && value.size() > 8; // too much to print
        const std::string found =
            is_whole ? (value.is_array() ? "a list" : "an object") : shortened(value.dump(-1, ' ', false, json::error_handler_t::replace));
        fail(spot, "is " + found, remedy);
    }

    const std::string& name_;
};

template <class T>
template <class M>
void ObjectReader<T>::operator()(const char* name, M T::* member, const Rule& rule)
{
    const auto found = object_.find(name);
    if (found == object_.end())
    {
        if (rule.is_required) reader_.fail(spot_, "has no field \"" + std::string(name) + "\"", "add it");
        return;
    }
    ++used_;
    reader_.read(*found, out_.*member, rule, {&spot_, name});
}

template <class T>
template <class M>
void ObjectReader<T>::choice(M T::* member, const Rule& rule)
{
    const std::size_t used = reader_.read_choice(object_, out_.*member, spot_);
    used_ += used;
    if (used > 0 || !rule.is_required) return;
    FieldNames keys;
    keys.choice(member, rule);
    reader_.fail(spot_, "says not what it is", "add one of " + support::joined(keys.names));
}

/// Takes the elements of the long lists as the parser comes by.
class ListReader
{
public:
    ListReader(const Reader& reader, SceneFile& file) : reader_(reader), file_(file) {}

    void take(std::string_view list, std::size_t index, const json& element)
    {
        const Spot whole{nullptr, list};
        const Spot spot{&whole, {}, index};
        if (list == "bodies") append(file_.bodies, most_file_bodies, element, whole, spot);
        if (list == "joints") append(file_.joints, most_file_joints, element, whole, spot);
        if (list == "events") append(file_.events, most_file_events, element, whole, spot);
        if (list == "rays") append(file_.rays, most_file_rays, element, whole, spot);
    }

private:
    template <class T>
    void append(std::vector<T>& list, int most, const json& element, const Spot& whole, const Spot& spot)
    {
        if (list.size() >= static_cast<std::size_t>(most)) reader_.fail(whole, "is too long", "give at most " + std::to_string(most));
        reader_.read(element, list.emplace_back(), about(""), spot);
    }

    const Reader& reader_;
    SceneFile& file_;
};

std::string text_of(const std::filesystem::path& path)
{
    std::error_code ignored;
    const bool is_folder = std::filesystem::is_directory(path, ignored); // a folder opens, but reading from it throws
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    const char* const reason = is_folder ? "it is a folder" : std::strerror(errno);
    if (!file || is_folder) throw SceneFileError("can't read \"" + path.string() + "\": " + reason);
    std::string text;
    std::vector<char> part(1 << 20);
    while (file.read(part.data(), static_cast<std::streamsize>(part.size())), file.gcount() > 0)
    {
        text.append(part.data(), static_cast<std::size_t>(file.gcount()));
        if (text.size() > most_file_bytes)
            throw SceneFileError(path.string() + ": the file is longer than " + std::to_string(most_file_bytes >> 20) +
                                 " MiB; make the scene smaller");
    }
    return text;
}

} // namespace

SceneFile parse_scene_file(std::string_view text, const std::string& name)
{
    constexpr std::array<std::string_view, 4> lists = {"bodies", "joints", "events", "rays"};
    const Reader reader(name);
    SceneFile file;
    ListReader list_reader(reader, file);
    const json root = parse_parts(text, name, lists, [&](std::string_view list, std::size_t index, const json& element)
    { list_reader.take(list, index, element); });
    reader.read(root, file, about(""), {});
    check(file, name);
    return file;
}

SceneFile read_scene_file(const std::filesystem::path& path) { return parse_scene_file(text_of(path), path.string()); }

} // namespace carom::scene_file
