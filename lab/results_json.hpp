// What the files of the laboratory have in common as JSON.
#pragma once

#include "lab/results.hpp"

#include <nlohmann/json.hpp>

namespace carom::lab
{

nlohmann::ordered_json json_of(const Origin& origin);

} // namespace carom::lab
