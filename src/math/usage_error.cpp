// UsageError, the handler that stands in for exceptions, and the wording of the common checks.
#include "math/usage_error.hpp"

#include <array>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

namespace carom
{

namespace
{

void print_to_standard_error(const UsageError& error)
{
    std::fputs(error.what(), stderr);
    std::fputc('\n', stderr);
    std::fflush(stderr);
}

std::atomic<UsageErrorHandler> current_handler = print_to_standard_error;

} // namespace

UsageError::UsageError(std::string function, std::string field, std::string value, std::string remedy)
    : std::logic_error(function + ": " + field + " is " + value + "; " + remedy),
      function_(std::move(function)),
      field_(std::move(field)),
      value_(std::move(value)),
      remedy_(std::move(remedy))
{
}

UsageErrorHandler set_usage_error_handler(UsageErrorHandler handler)
{
    return current_handler.exchange(handler != nullptr ? handler : print_to_standard_error);
}

namespace detail
{

namespace
{

/// The shortest decimal digits that give the same number back, whatever the locale.
template <class Number>
std::string text_of(Number value)
{
    if constexpr (std::floating_point<Number>)
    {
        if (std::isnan(value)) return "nan"; // its sign means nothing
    }
    std::array<char, 64> buffer;
    const std::to_chars_result end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return std::string(buffer.data(), end.ptr);
}

std::string joined(std::string_view a, std::string_view b) { return std::string(a).append(b); }

/// The word for a field in a remedy: "def.linear_velocity" is a "linear velocity". An element of an array has no article:
/// "polygon.vertices[2]" gives "vertices".
std::string remedy_noun(std::string_view article, std::string_view field)
{
    std::string noun(field.substr(field.rfind('.') + 1));
    if (const std::size_t bracket = noun.find('['); bracket != std::string::npos)
        noun.resize(bracket);
    else
        noun.insert(0, article);
    for (char& c : noun)
    {
        if (c == '_') c = ' ';
    }
    return noun;
}

std::string finite_remedy(std::string_view field)
{
    const std::string noun = remedy_noun("a ", field);
    return noun.starts_with("a ") ? "give a finite " + noun.substr(2) : "give finite " + noun;
}

} // namespace

void usage_error(std::string_view function, std::string_view field, std::string_view value, std::string_view remedy)
{
    UsageError error{std::string(function), std::string(field), std::string(value), std::string(remedy)};
#if defined(__cpp_exceptions)
    throw error;
#else
    current_handler.load()(error);
    std::abort();
#endif
}

void usage_error(std::string_view function, std::string_view field, float value, std::string_view remedy)
{
    usage_error(function, field, text_of(value), remedy);
}

void usage_error(std::string_view function, std::string_view field, double value, std::string_view remedy)
{
    usage_error(function, field, text_of(value), remedy);
}

void usage_error(std::string_view function, std::string_view field, Vec2 value, std::string_view remedy)
{
    usage_error(function, field, "(" + text_of(value.x) + ", " + text_of(value.y) + ")", remedy);
}

void usage_error_integer(std::string_view function, std::string_view field, std::int64_t value, std::string_view remedy)
{
    usage_error(function, field, text_of(value), remedy);
}

void usage_error_integer(std::string_view function, std::string_view field, std::uint64_t value, std::string_view remedy)
{
    usage_error(function, field, text_of(value), remedy);
}

void not_finite(std::string_view function, std::string_view field, float value)
{
    usage_error(function, field, value, finite_remedy(field));
}

void not_finite(std::string_view function, std::string_view field, Vec2 value)
{
    const bool is_x = !std::isfinite(value.x);
    usage_error(function, joined(field, is_x ? ".x" : ".y"), is_x ? value.x : value.y, finite_remedy(field));
}

void out_of_range(std::string_view function, std::string_view field, float value, float min, float max)
{
    usage_error(function, field, value, "give a value from " + text_of(min) + " to " + text_of(max));
}

void out_of_range(std::string_view function, std::string_view field, std::int64_t value, std::int64_t min, std::int64_t max)
{
    usage_error(function, field, value, "give a value from " + text_of(min) + " to " + text_of(max));
}

void out_of_reach(std::string_view function, std::string_view field, Vec2 value, float limit)
{
    require_finite(function, field, value);
    const bool is_x = !(value.x >= -limit && value.x <= limit);
    usage_error(function, joined(field, is_x ? ".x" : ".y"), is_x ? value.x : value.y,
                "give a value from " + text_of(-limit) + " to " + text_of(limit));
}

void not_positive(std::string_view function, std::string_view field, float value)
{
    require_finite(function, field, value);
    usage_error(function, field, value, "give a value greater than 0");
}

void negative(std::string_view function, std::string_view field, float value)
{
    require_finite(function, field, value);
    usage_error(function, field, value, "give a value of 0 or more");
}

} // namespace detail

} // namespace carom
