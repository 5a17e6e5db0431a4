// The scenes and what can be set in them, for machines and for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace carom::cli
{

/// The array that `carom scenes --json` prints.
nlohmann::ordered_json scenes_json();
/// What `carom scenes` prints.
std::string scenes_text();

} // namespace carom::cli
