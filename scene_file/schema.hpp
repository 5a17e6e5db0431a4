// The JSON Schema of scene files.
#pragma once

#include <string>

namespace carom::scene_file
{

/// The schema, in draft 2020-12 of JSON Schema, from the same lists of fields that the reader walks.
std::string scene_file_schema();

} // namespace carom::scene_file
