// Checks and reads values of parameters, and words the errors.
#include "scenes/parameters.hpp"

#include "scenes/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

namespace carom::scenes
{

namespace
{

/// The shortest decimals that read back as the same number; with an exponent only where there would be many zeros.
std::string number_text(double number)
{
    const double size = std::abs(number);
    const bool is_handy = number == 0 || (1e-5 < size && size < 1e15);
    std::array<char, 64> buffer;
    const auto format = is_handy ? std::chars_format::fixed : std::chars_format::general;
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, format);
    return {buffer.data(), result.ptr};
}

/// A number that is written out whole, and nothing else.
std::optional<double> read_number(std::string_view text)
{
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::optional<bool> read_boolean(std::string_view text)
{
    const std::string word = lower_case(text);
    if (word == "true" || word == "on" || word == "yes" || word == "1") return true;
    if (word == "false" || word == "off" || word == "no" || word == "0") return false;
    return std::nullopt;
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

[[noreturn]] void refuse(const ParameterInfo& info, const std::string& value, const std::string& problem)
{
    throw SceneError(info.name, value + " " + problem, "give " + allowed_values(info));
}

bool is_within(const ParameterInfo& info, double number)
{
    return info.min <= number && number <= info.max; // false for NaN
}

ParameterValue checked_number(const ParameterInfo& info, const ParameterValue& value, double number)
{
    if (!is_within(info, number)) refuse(info, to_text(value), "is out of range");
    if (info.kind == ParameterKind::Real) return number;
    if (number != std::floor(number)) refuse(info, to_text(value), "is not an integer");
    return static_cast<std::int64_t>(number);
}

ParameterValue checked_choice(const ParameterInfo& info, const std::string& value)
{
    for (const std::string& one : info.choices)
    {
        if (lower_case(one) == lower_case(value)) return one;
    }
    const std::string near = closest(value, info.choices);
    const std::string problem = "is not a choice" + (near.empty() ? "" : " (did you mean " + near + "?)");
    refuse(info, quoted(value), problem);
}

} // namespace

SceneError::SceneError(std::string subject, std::string problem, std::string remedy)
    : std::invalid_argument(subject + ": " + problem + "; " + remedy),
      subject_(std::move(subject)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy))
{
}

std::string_view name_of(ParameterKind kind)
{
    constexpr std::array<std::string_view, 4> names = {"real", "integer", "boolean", "choice"};
    return names[static_cast<std::size_t>(kind)];
}

ParameterInfo real(std::string name, RealRange range, std::string unit, Applies applies, std::string description)
{
    return {std::move(name), std::move(description), std::move(unit), ParameterKind::Real, range.initial, range.min, range.max, {},
            applies};
}

ParameterInfo integer(std::string name, IntegerRange range, std::string unit, Applies applies, std::string description)
{
    const auto min = static_cast<double>(range.min);
    const auto max = static_cast<double>(range.max);
    return {std::move(name), std::move(description), std::move(unit), ParameterKind::Integer, range.initial, min, max, {}, applies};
}

ParameterInfo boolean(std::string name, bool initial, Applies applies, std::string description)
{
    return {std::move(name), std::move(description), "", ParameterKind::Boolean, initial, 0, 1, {}, applies};
}

ParameterInfo choice(std::string name, std::vector<std::string> choices, Applies applies, std::string description)
{
    const std::string initial = choices.front();
    return {std::move(name), std::move(description), "", ParameterKind::Choice, initial, 0, 0, std::move(choices), applies};
}

std::string allowed_values(const ParameterInfo& info)
{
    switch (info.kind)
    {
    case ParameterKind::Boolean: return "true or false";
    case ParameterKind::Choice: return "one of " + joined(info.choices);
    case ParameterKind::Integer:
    case ParameterKind::Real: break;
    }
    const std::string kind = info.kind == ParameterKind::Integer ? "an integer" : "a number";
    return kind + " from " + number_text(info.min) + " to " + number_text(info.max) + (info.unit.empty() ? "" : " " + info.unit);
}

std::string to_text(const ParameterValue& value)
{
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
    if (const auto* real = std::get_if<double>(&value)) return number_text(*real);
    return std::get<std::string>(value);
}

ParameterValue checked(const ParameterInfo& info, const ParameterValue& value)
{
    const bool is_number = info.kind == ParameterKind::Real || info.kind == ParameterKind::Integer;
    if (const auto* integer = std::get_if<std::int64_t>(&value); integer && is_number)
        return checked_number(info, value, static_cast<double>(*integer));
    if (const auto* real = std::get_if<double>(&value); real && is_number) return checked_number(info, value, *real);
    if (const auto* text = std::get_if<std::string>(&value); text && info.kind == ParameterKind::Choice) return checked_choice(info, *text);
    if (std::holds_alternative<bool>(value) && info.kind == ParameterKind::Boolean) return value;
    const bool is_text = std::holds_alternative<std::string>(value);
    refuse(info, is_text ? quoted(to_text(value)) : to_text(value), "is not of type " + std::string(name_of(info.kind)));
}

ParameterValue parsed(const ParameterInfo& info, std::string_view text)
{
    std::optional<ParameterValue> value;
    switch (info.kind)
    {
    case ParameterKind::Real:
    case ParameterKind::Integer: // read as a real number, so that 1e3 is an integer and 99999999999999999999 is out of range
        if (const auto number = read_number(text)) value = *number;
        break;
    case ParameterKind::Boolean:
        if (const auto flag = read_boolean(text)) value = *flag;
        break;
    case ParameterKind::Choice: value = std::string(text); break;
    }
    if (!value) refuse(info, quoted(std::string(text)), "can't be read");
    return checked(info, *value);
}

ParameterValues parsed_settings(std::span<const ParameterInfo> infos, std::span<const std::string> settings)
{
    ParameterValues values;
    for (const std::string& setting : settings)
    {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos) throw SceneError("--set", "\"" + setting + "\" has no value", "give NAME=VALUE");
        const std::string name = setting.substr(0, equals);
        if (name.empty()) throw SceneError("--set", "\"" + setting + "\" has no name", "give NAME=VALUE");
        values.emplace_back(name, parsed(find_parameter(infos, name), setting.substr(equals + 1)));
    }
    return values;
}

const ParameterInfo& find_parameter(std::span<const ParameterInfo> infos, std::string_view name)
{
    for (const ParameterInfo& info : infos)
    {
        if (info.name == name) return info;
    }
    std::vector<std::string> names;
    for (const ParameterInfo& info : infos) names.push_back(info.name);
    throw SceneError(std::string(name), "no such parameter", suggestion(name, names));
}

Parameters::Parameters(std::span<const ParameterInfo> infos) : infos_(infos)
{
    for (const ParameterInfo& info : infos) values_.push_back(info.initial);
}

void Parameters::set(std::string_view name, const ParameterValue& value)
{
    const std::size_t index = index_of(name);
    values_[index] = checked(infos_[index], value);
}

const ParameterValue& Parameters::value(std::string_view name) const { return values_[index_of(name)]; }

ParameterValues Parameters::values() const
{
    ParameterValues all;
    for (std::size_t i = 0; i < infos_.size(); ++i) all.emplace_back(infos_[i].name, values_[i]);
    return all;
}

std::size_t Parameters::index_of(std::string_view name) const
{
    return static_cast<std::size_t>(&find_parameter(infos_, name) - infos_.data());
}

} // namespace carom::scenes
