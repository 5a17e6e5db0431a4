// Readers for numbers, texts, words, vectors and lists in a scene file.
#pragma once

#include "scene_file/reading.hpp"
#include "support/text.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace carom::scene_file
{

template <class T>
class ReaderOf;

template <class T>
Slot slot_of(T& value, const Rule& rule)
{
    static const ReaderOf<T> reader;
    return {&reader, &value, rule};
}

inline std::string unit_text(const Rule& rule) { return *rule.unit ? std::string(" [") + rule.unit + "]" : ""; }

/// "give a number > 0 and at most 5 [m]"
/// @param is_low whether the value is a number below the range: the upper end is no news then
inline std::string range_remedy(const Rule& rule, const std::string& kind, bool is_low)
{
    if (rule.min == rule.max) return "give " + number_text(rule.min) + ", the " + rule.what + " that this program reads";
    const bool has_min = std::isfinite(rule.min);
    const bool has_max = std::isfinite(rule.max);
    std::string range;
    if (has_min && rule.is_above_min)
        range = " > " + number_text(rule.min) + (is_low || !has_max ? "" : " and at most " + number_text(rule.max));
    else if (has_min && has_max)
        range = " from " + number_text(rule.min) + " to " + number_text(rule.max);
    else if (kind == "whole number")
        range = " that is not negative";
    return "give a " + kind + range + unit_text(rule);
}

template <>
class ReaderOf<bool> : public ValueReader
{
public:
    void read(Reading& reading, const Slot& slot, const Scalar& value) const override
    {
        if (value.kind != Scalar::Kind::Bool) ValueReader::read(reading, slot, value);
        *static_cast<bool*>(slot.value) = value.number != 0;
    }

protected:
    std::string remedy(const Slot&) const override { return "give true or false"; }
};

template <>
class ReaderOf<std::string> : public ValueReader
{
public:
    void read(Reading& reading, const Slot& slot, const Scalar& value) const override
    {
        if (value.kind != Scalar::Kind::Text) ValueReader::read(reading, slot, value);
        if (value.text.size() > most_text_bytes)
            reading.fail("is longer than " + std::to_string(most_text_bytes >> 10) + " KiB", "make it shorter");
        *static_cast<std::string*>(slot.value) = value.text;
    }

protected:
    std::string remedy(const Slot&) const override { return "give a text in quotes"; }
};

template <>
class ReaderOf<float> : public ValueReader
{
public:
    void read(Reading& reading, const Slot& slot, const Scalar& value) const override
    {
        const Rule& rule = slot.rule;
        if (value.kind != Scalar::Kind::Whole && value.kind != Scalar::Kind::Number) ValueReader::read(reading, slot, value);
        const bool fits = std::abs(value.number) <= double{std::numeric_limits<float>::max()};
        const float number = fits ? static_cast<float>(value.number) : 0;
        const bool is_low = rule.is_above_min ? double{number} <= rule.min : double{number} < rule.min;
        if (!fits || is_low || double{number} > rule.max) reading.fail("is " + value.shown(), range_remedy(rule, "number", is_low && fits));
        *static_cast<float*>(slot.value) = number;
    }

protected:
    std::string remedy(const Slot& slot) const override { return range_remedy(slot.rule, "number", false); }
};

template <std::integral Int>
class ReaderOf<Int> : public ValueReader
{
public:
    void read(Reading& reading, const Slot& slot, const Scalar& value) const override
    {
        const Rule& rule = slot.rule; // value.number is exact wherever a rule's end is
        if (value.kind != Scalar::Kind::Whole || value.number < rule.min || value.number > rule.max ||
            (std::unsigned_integral<Int> && value.is_negative))
            ValueReader::read(reading, slot, value);
        *static_cast<Int*>(slot.value) = static_cast<Int>(value.bits);
    }

protected:
    std::string remedy(const Slot& slot) const override { return range_remedy(slot.rule, "whole number", false); }
};

template <class Enum>
    requires std::is_enum_v<Enum>
class ReaderOf<Enum> : public ValueReader
{
public:
    void read(Reading& reading, const Slot& slot, const Scalar& value) const override
    {
        if (value.kind != Scalar::Kind::Text) ValueReader::read(reading, slot, value);
        const auto& words = Words<Enum>::all;
        const auto found = std::find(std::begin(words), std::end(words), value.text);
        if (found == std::end(words))
            reading.fail("is " + value.shown(), "it is none of the words; " + support::suggestion(value.text, word_list()));
        *static_cast<Enum*>(slot.value) = static_cast<Enum>(found - std::begin(words));
    }

protected:
    std::string remedy(const Slot&) const override { return "give one of " + support::joined(word_list()); }

private:
    static std::vector<std::string> word_list() { return {std::begin(Words<Enum>::all), std::end(Words<Enum>::all)}; }
};

/// Two numbers in [].
class PairReader : public ValueReader
{
public:
    void begin(Reading& reading, const Slot& slot, bool is_list) const override
    {
        if (!is_list) ValueReader::begin(reading, slot, is_list);
    }
    Slot element(Reading& reading, Frame& frame) const override
    {
        if (frame.count > 2) reading.fail_inside("", "holds more than two numbers", remedy(frame.slot));
        return slot_of(number(frame.slot, frame.count - 1), frame.slot.rule);
    }
    void end(Reading& reading, Frame& frame) const override
    {
        if (frame.count == 2) return;
        const std::string first = frame.count == 1 ? number_text(double{number(frame.slot, 0)}) : "";
        reading.fail_inside("", "is [" + first + "]", remedy(frame.slot));
    }

protected:
    std::string remedy(const Slot& slot) const override { return "give two numbers in []" + unit_text(slot.rule); }
    virtual float& number(const Slot& slot, std::size_t index) const = 0;
};

template <>
class ReaderOf<Vec2> : public PairReader
{
protected:
    float& number(const Slot& slot, std::size_t index) const override
    {
        Vec2& v = *static_cast<Vec2*>(slot.value);
        return index == 0 ? v.x : v.y;
    }
};

template <>
class ReaderOf<Rot> : public PairReader
{
public:
    void end(Reading& reading, Frame& frame) const override
    {
        PairReader::end(reading, frame);
        const Rot q = *static_cast<const Rot*>(frame.slot.value);
        if (std::abs(q.c * q.c + q.s * q.s - 1) <= 1e-3f) return;
        const std::string found = "[" + number_text(double{q.c}) + "," + number_text(double{q.s}) + "]";
        reading.fail_inside("", "is " + found, "give [cosine, sine] of an angle, of length 1");
    }

protected:
    float& number(const Slot& slot, std::size_t index) const override
    {
        Rot& q = *static_cast<Rot*>(slot.value);
        return index == 0 ? q.c : q.s;
    }
};

template <class T>
class ReaderOf<std::optional<T>> : public ValueReader
{
public:
    Slot opened(const Slot& slot) const override { return slot_of(value_of(slot).emplace(), slot.rule); }
    void read(Reading& reading, const Slot& slot, const Scalar& value) const override
    {
        if (value.kind == Scalar::Kind::Null) return value_of(slot).reset();
        const Slot inner = opened(slot);
        inner.reader->read(reading, inner, value);
    }

protected:
    std::string remedy(const Slot&) const override { return {}; } // what is inside refuses

private:
    static std::optional<T>& value_of(const Slot& slot) { return *static_cast<std::optional<T>*>(slot.value); }
};

/// The sum over the file that an element of a list counts for; points and short lists are limited by the file's length and their own.
template <class T>
constexpr std::optional<Total> total_of()
{
    if (std::is_same_v<T, FileBody>) return Total{0, most_file_bodies, "bodies"};
    if (std::is_same_v<T, FileJoint>) return Total{1, most_file_joints, "joints"};
    if (std::is_same_v<T, FileShape> || std::is_same_v<T, FileChain>) return Total{2, most_file_shapes, "shapes"};
    if (std::is_same_v<T, Material>) return Total{3, most_file_shapes, "materials"};
    if (std::is_same_v<T, FileEvent>) return Total{4, most_file_events, "events"};
    if (std::is_same_v<T, SetBody> || std::is_same_v<T, SetJoint> || std::is_same_v<T, int>) return Total{5, most_file_changes, "changes"};
    return {};
}

/// Adds to what is there.
template <class T>
class ReaderOf<std::vector<T>> : public ValueReader
{
public:
    void begin(Reading& reading, const Slot& slot, bool is_list) const override
    {
        if (!is_list) ValueReader::begin(reading, slot, is_list);
    }
    Slot element(Reading& reading, Frame& frame) const override
    {
        const Rule& rule = frame.slot.rule;
        if (static_cast<double>(frame.count) > rule.max)
            reading.fail_inside("", "holds more than " + number_text(rule.max), "give at most " + number_text(rule.max));
        if constexpr (constexpr std::optional<Total> total = total_of<T>()) reading.count(*total);
        return slot_of(static_cast<std::vector<T>*>(frame.slot.value)->emplace_back(), bounds_of_element(rule));
    }
    void end(Reading& reading, Frame& frame) const override
    {
        const auto count = static_cast<double>(frame.count);
        const Rule& rule = frame.slot.rule;
        if (count < rule.min) reading.fail_inside("", "holds " + number_text(count), "give at least " + number_text(rule.min));
    }

protected:
    std::string remedy(const Slot&) const override { return "give a list in []"; }

private:
    /// The rule of a list bounds its length, but for numbers of bodies and joints, which can't be negative.
    static Rule bounds_of_element(const Rule& rule)
    {
        if constexpr (std::is_same_v<T, int>) return {.what = "", .min = 0, .max = rule.max - 1};
        if constexpr (std::is_same_v<T, Vec2>) return {.what = "", .unit = "m", .min = -max_coordinate, .max = max_coordinate};
        return about("");
    }
};

} // namespace carom::scene_file
