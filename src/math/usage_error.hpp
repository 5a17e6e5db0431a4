// How every layer refuses a caller's bad value. A check is one inline comparison; the message is put together, out of line, only on
// failure, and names the function, the field, the value and the remedy:
//     create_body: position.x is nan; give a finite position
#pragma once

#include <carom/error.hpp>
#include <carom/math.hpp>

#include <concepts>
#include <cstdint>
#include <string_view>

namespace carom::detail
{

/// Throws UsageError; without exceptions, calls the handler and aborts.
/// @param function the public function that was called, "create_body"
/// @param field    the argument at fault, with the path into it, "def.position.x"
/// @param remedy   what to do instead, "give a finite position"
[[noreturn]] void usage_error(std::string_view function, std::string_view field, std::string_view value, std::string_view remedy);
[[noreturn]] void usage_error(std::string_view function, std::string_view field, float value, std::string_view remedy);
[[noreturn]] void usage_error(std::string_view function, std::string_view field, double value, std::string_view remedy);
[[noreturn]] void usage_error(std::string_view function, std::string_view field, Vec2 value, std::string_view remedy); ///< "(1, -0.5)"
[[noreturn]] void usage_error_integer(std::string_view function, std::string_view field, std::int64_t value, std::string_view remedy);
[[noreturn]] void usage_error_integer(std::string_view function, std::string_view field, std::uint64_t value, std::string_view remedy);

template <std::integral T>
[[noreturn]] void usage_error(std::string_view function, std::string_view field, T value, std::string_view remedy)
{
    if constexpr (std::same_as<T, bool>)
        usage_error(function, field, value ? std::string_view("true") : "false", remedy);
    else if constexpr (std::signed_integral<T>)
        usage_error_integer(function, field, static_cast<std::int64_t>(value), remedy);
    else
        usage_error_integer(function, field, static_cast<std::uint64_t>(value), remedy);
}

// The failing halves of the checks below.
[[noreturn]] void not_finite(std::string_view function, std::string_view field, float value);
[[noreturn]] void not_finite(std::string_view function, std::string_view field, Vec2 value);
[[noreturn]] void out_of_range(std::string_view function, std::string_view field, float value, float min, float max);
[[noreturn]] void out_of_range(std::string_view function, std::string_view field, std::int64_t value, std::int64_t min, std::int64_t max);
[[noreturn]] void out_of_reach(std::string_view function, std::string_view field, Vec2 value, float limit);
[[noreturn]] void not_positive(std::string_view function, std::string_view field, float value);
[[noreturn]] void negative(std::string_view function, std::string_view field, float value);

/// "give a finite <last word of the field>"
inline void require_finite(std::string_view function, std::string_view field, float value)
{
    if (!std::isfinite(value)) [[unlikely]]
        not_finite(function, field, value);
}

/// Names the component: "position.x".
inline void require_finite(std::string_view function, std::string_view field, Vec2 value)
{
    if (!is_finite(value)) [[unlikely]]
        not_finite(function, field, value);
}

/// Finite and min <= value <= max: "give a value from <min> to <max>".
inline void require_range(std::string_view function, std::string_view field, float value, float min, float max)
{
    if (!(value >= min && value <= max) || !std::isfinite(value)) [[unlikely]]
        out_of_range(function, field, value, min, max);
}

template <std::integral T>
void require_range(std::string_view function, std::string_view field, T value, std::type_identity_t<T> min, std::type_identity_t<T> max)
{
    if (value < min || value > max) [[unlikely]]
    {
        out_of_range(function, field, static_cast<std::int64_t>(value), static_cast<std::int64_t>(min), static_cast<std::int64_t>(max));
    }
}

/// Both components finite and within +-limit. Pass carom::max_coordinate for places and lengths.
inline void require_within(std::string_view function, std::string_view field, Vec2 value, float limit)
{
    const bool is_within = value.x >= -limit && value.x <= limit && value.y >= -limit && value.y <= limit;
    if (!is_within) [[unlikely]]
        out_of_reach(function, field, value, limit);
}

/// Finite and > 0.
inline void require_positive(std::string_view function, std::string_view field, float value)
{
    if (!(value > 0) || !std::isfinite(value)) [[unlikely]]
        not_positive(function, field, value);
}

/// Finite and >= 0.
inline void require_not_negative(std::string_view function, std::string_view field, float value)
{
    if (!(value >= 0) || !std::isfinite(value)) [[unlikely]]
        negative(function, field, value);
}

} // namespace carom::detail
