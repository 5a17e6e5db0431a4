// Parses the text of a scene file part by part, so that a large file never lies in memory as one JSON tree.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace carom::scene_file
{

/// One element of a long list at the top of the file.
using ElementHandler = std::function<void(std::string_view list, std::size_t index, const nlohmann::json& element)>;

/// Parses a JSON object.
/// @param name   of the file, for messages
/// @param lists  fields of the object whose elements go to `handle` one by one
/// @return the object, with those lists empty
/// @throws SceneFileError on a syntax error, with line and column; on a field that appears twice; when it is nested too deeply
nlohmann::json parse_parts(std::string_view text, const std::string& name, std::span<const std::string_view> lists,
                           const ElementHandler& handle);

/// Enough of a text to recognise it in a message.
std::string shortened(std::string text);

} // namespace carom::scene_file
