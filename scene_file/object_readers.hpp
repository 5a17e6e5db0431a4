// Readers for objects in a scene file: each finds its fields in the lists of Fields.
#pragma once

#include "scene_file/polygon.hpp"
#include "scene_file/value_readers.hpp"

#include <variant>

namespace carom::scene_file
{

/// A field that a key names.
struct FoundField
{
    std::string_view key;
    std::size_t count = 0;                                    ///< fields that were walked so far
    std::optional<std::size_t> position = {};                 ///< of the field, in that order
    Slot slot = {};                                           ///< unless it is a choice
    Slot (*choose)(void* variant, std::size_t key) = nullptr; ///< makes the variant hold an alternative
    void* variant = nullptr;
    std::size_t alternative = 0;
    std::string_view choice = {}; ///< the key itself, which stays
};

/// Walks the fields of an object until the one that is asked for.
template <class T>
class FieldFinder
{
public:
    FieldFinder(T& object, FoundField& found) : object_(object), found_(found) {}

    template <class M>
    void operator()(const char* name, M T::* member, const Rule& rule)
    {
        if (!found_.position && found_.key == name)
        {
            found_.position = found_.count;
            found_.slot = slot_of(object_.*member, rule);
        }
        ++found_.count;
    }
    template <class M>
    void flat(M T::* member)
    {
        FieldFinder<M> part(object_.*member, found_);
        Fields<M>::visit(part);
    }
    template <class M>
    void choice(M T::* member, const Rule&)
    {
        find_alternative(object_.*member);
    }
    template <class... Ts>
    void find_alternative(std::variant<Ts...>& variant)
    {
        find_key<std::variant<Ts...>>(variant, &choose<std::variant<Ts...>, Ts...>);
    }
    template <class... Ts>
    void find_alternative(std::optional<std::variant<Ts...>>& variant)
    {
        find_key<std::variant<Ts...>>(variant, &choose_in_optional<std::variant<Ts...>, Ts...>);
    }

private:
    template <class Variant, class Member>
    void find_key(Member& member, Slot (*make)(void*, std::size_t))
    {
        const auto& keys = Keys<Variant>::all;
        const auto key = std::find(std::begin(keys), std::end(keys), found_.key);
        if (!found_.position && key != std::end(keys))
        {
            found_.position = found_.count;
            found_.choose = make;
            found_.variant = &member;
            found_.alternative = static_cast<std::size_t>(key - std::begin(keys));
            found_.choice = *key;
        }
        ++found_.count;
    }

    template <class Variant, class... Ts>
    static Slot choose(void* variant, std::size_t alternative)
    {
        Slot slot;
        std::size_t at = 0;
        (void)((at++ == alternative && (slot = slot_of(static_cast<Variant*>(variant)->template emplace<Ts>(), about("")), true)) || ...);
        return slot;
    }
    template <class Variant, class... Ts>
    static Slot choose_in_optional(void* variant, std::size_t alternative)
    {
        return choose<Variant, Ts...>(&static_cast<std::optional<Variant>*>(variant)->emplace(), alternative);
    }

    T& object_;
    FoundField& found_;
};

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

/// Refuses an object that lacks a field.
class RequiredFields
{
public:
    RequiredFields(Reading& reading, const Frame& frame) : reading_(reading), frame_(frame) {}

    template <class Member>
    void operator()(const char* name, Member, const Rule& rule)
    {
        if (rule.is_required && !is_seen()) reading_.fail_inside("", "has no field \"" + std::string(name) + "\"", "add it");
        ++count_;
    }
    template <class C, class M>
    void flat(M C::*)
    {
        Fields<M>::visit(*this);
    }
    template <class C, class M>
    void choice(M C::* member, const Rule& rule)
    {
        FieldNames keys;
        if (rule.is_required && !is_seen())
        {
            keys.choice(member, rule);
            reading_.fail_inside("", "has no type", "add one of " + support::joined(keys.names));
        }
        ++count_;
    }

private:
    bool is_seen() const { return (frame_.seen >> count_ & 1) != 0; }

    Reading& reading_;
    const Frame& frame_;
    std::size_t count_ = 0;
};

/// An object whose fields are known.
class ObjectReader : public ValueReader
{
public:
    void begin(Reading& reading, const Slot& slot, bool is_list) const override
    {
        if (is_list) ValueReader::begin(reading, slot, is_list);
    }
    Slot field(Reading& reading, Frame& frame) const override
    {
        FoundField found{.key = frame.key};
        find(reading, frame.slot, found);
        if (!found.position)
            reading.fail_object("has an unknown field \"" + shortened(frame.key) + "\"", support::suggestion(frame.key, names()));
        const std::uint64_t bit = std::uint64_t{1} << *found.position;
        if (found.choose && !frame.choice.empty() && frame.choice != frame.key)
            reading.fail_object("has both \"" + std::string(frame.choice) + "\" and \"" + frame.key + "\"", "give one of them");
        if (frame.seen & bit) reading.fail("appears twice", "give it once");
        frame.seen |= bit;
        if (!found.choose) return found.slot;
        frame.choice = found.choice;
        return found.choose(found.variant, found.alternative);
    }

protected:
    std::string remedy(const Slot&) const override { return "give an object in {}"; }
    virtual void find(Reading& reading, const Slot& slot, FoundField& found) const = 0;
    virtual std::vector<std::string> names() const = 0;
};

/// An object with the fields of T.
template <class T>
class FieldsReader : public ObjectReader
{
public:
    void begin(Reading& reading, const Slot& slot, bool is_list) const override
    {
        ObjectReader::begin(reading, slot, is_list);
        if constexpr (requires(T& value) { value.place; }) object(reading, slot).place = reading.place;
    }
    void end(Reading& reading, Frame& frame) const override
    {
        RequiredFields required(reading, frame);
        Fields<T>::visit(required);
    }

protected:
    virtual T& object(Reading&, const Slot& slot) const { return *static_cast<T*>(slot.value); }
    void find(Reading& reading, const Slot& slot, FoundField& found) const override
    {
        FieldFinder<T> finder(object(reading, slot), found);
        Fields<T>::visit(finder);
    }
    std::vector<std::string> names() const override
    {
        FieldNames known;
        Fields<T>::visit(known);
        return known.names;
    }
};

template <class T>
    requires requires { Fields<T>::what; }
class ReaderOf<T> : public FieldsReader<T>
{
};

template <>
class ReaderOf<SceneFile> : public FieldsReader<SceneFile>
{
protected:
    std::string remedy(const Slot&) const override { return "write {\"carom_scene\": 1, ...}"; }
};

template <>
class ReaderOf<Polygon> : public FieldsReader<PolygonFields>
{
public:
    /// Its fields are read beside it, and made a polygon when all are there. Polygons do not lie in each other.
    void begin(Reading& reading, const Slot& slot, bool is_list) const override
    {
        reading.polygon = {};
        FieldsReader::begin(reading, slot, is_list);
    }
    void end(Reading& reading, Frame& frame) const override
    {
        FieldsReader::end(reading, frame);
        if (frame.has_problem) return;
        const PolygonFields& fields = reading.polygon;
        if (!fields.normals.empty() && fields.normals.size() != fields.vertices.size())
            reading.fail_inside("normals", "are " + std::to_string(fields.normals.size()), "give one for each vertex, or none");
        try
        {
            *static_cast<Polygon*>(frame.slot.value) = polygon_in_any_world(reading, fields);
        }
        catch (const UsageError& error)
        {
            const std::string& field = error.field();
            constexpr std::string_view prefix = "polygon.";
            reading.fail_inside(field.starts_with(prefix) ? field.substr(prefix.size()) : field, "is " + error.value(), error.remedy());
        }
    }

protected:
    PolygonFields& object(Reading& reading, const Slot&) const override { return reading.polygon; }

private:
    /// The file may give its length unit later, so that only what no world accepts is refused here, in the words of the unit that is known.
    static Polygon polygon_in_any_world(const Reading& reading, const PolygonFields& fields)
    {
        try
        {
            return polygon_from(fields, min_length_unit);
        }
        catch (const UsageError&)
        {
            return polygon_from(fields, reading.length_unit());
        }
    }
};

/// A gravity field: an object whose only field says which kind it is.
template <>
class ReaderOf<Field> : public ObjectReader
{
public:
    void end(Reading& reading, Frame& frame) const override
    {
        if (frame.choice.empty()) reading.fail_inside("", "is {}", remedy(frame.slot));
    }

protected:
    std::string remedy(const Slot&) const override { return "give an object with one of the keys " + support::joined(names()); }
    void find(Reading&, const Slot& slot, FoundField& found) const override
    {
        FileWorld unused;
        FieldFinder<FileWorld>(unused, found).find_alternative(*static_cast<Field*>(slot.value));
    }
    std::vector<std::string> names() const override { return {std::begin(Keys<Field>::all), std::end(Keys<Field>::all)}; }
};

} // namespace carom::scene_file
