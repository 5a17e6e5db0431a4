// Small helpers for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace carom::scenes
{

/// "a, b, c".
std::string joined(std::span<const std::string> words);
std::string lower_case(std::string_view text);
/// Of the candidates the one that `name` is likely a slip of; empty when none is close.
std::string closest(std::string_view name, std::span<const std::string> candidates);
/// What to try instead of a name that does not exist: "did you mean circles?", or all that there are.
std::string suggestion(std::string_view name, std::span<const std::string> candidates);

} // namespace carom::scenes
