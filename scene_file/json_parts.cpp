// Follows the parser through the text: where it is, which fields it has seen, and which elements are complete.
#include "scene_file/json_parts.hpp"

#include "scene_file/model.hpp"

#include <algorithm>
#include <array>

namespace carom::scene_file
{

using nlohmann::json;

namespace
{

constexpr int most_nested = 12;                       // deeper than a corner of a polygon in an event goes
constexpr std::size_t most_fields = 64;               // of one object: more than any has
constexpr std::size_t most_values = 32 * 1024 * 1024; // of one element, which lies in memory as a tree

/// One object or list that the parser is in.
struct Level
{
    bool is_list = false;
    std::size_t index = 0; ///< of the next element of a list
    std::vector<std::string> fields;
};

class PartParser
{
public:
    PartParser(const std::string& name, std::span<const std::string_view> lists, const ElementHandler& handle)
        : name_(name),
          lists_(lists),
          handle_(handle)
    {
    }

    /// @return false when the value was handed on and need not be kept
    bool on(int depth, json::parse_event_t event, const json& value)
    {
        const auto level = static_cast<std::size_t>(depth);
        if (depth > most_nested) fail("nested too deeply; a scene has at most " + std::to_string(most_nested) + " levels");
        switch (event)
        {
        case json::parse_event_t::object_start:
        case json::parse_event_t::array_start: return begin(level, event == json::parse_event_t::array_start);
        case json::parse_event_t::key: return add_field(level - 1, value.get_ref<const std::string&>());
        case json::parse_event_t::value: count_value(); [[fallthrough]];
        case json::parse_event_t::object_end:
        case json::parse_event_t::array_end: return end(level, value);
        }
        return true;
    }

private:
    bool begin(std::size_t level, bool is_list)
    {
        count_value();
        depth_ = level + 1;
        levels_[level].is_list = is_list;
        levels_[level].index = 0;
        levels_[level].fields.clear();
        return true;
    }

    bool add_field(std::size_t level, const std::string& field)
    {
        std::vector<std::string>& fields = levels_[level].fields;
        if (std::find(fields.begin(), fields.end(), field) != fields.end())
            fail("the field \"" + shortened(field) + "\" of " + path(level) + " appears twice; give it once");
        if (fields.size() >= most_fields) fail(path(level) + " has more than " + std::to_string(most_fields) + " fields; see the schema");
        fields.push_back(field);
        return true;
    }

    /// A value is complete: a scalar, an object or a list.
    bool end(std::size_t level, const json& value)
    {
        if (level == 0) return true;
        depth_ = level;
        Level& parent = levels_[level - 1];
        const std::size_t index = parent.index;
        if (parent.is_list) ++parent.index;
        if (level == 1) count_ = 0;
        if (level != 2 || !parent.is_list) return true;
        const std::string& list = levels_[0].fields.back();
        if (std::find(lists_.begin(), lists_.end(), list) == lists_.end()) return true;
        count_ = 0;
        handle_(list, index, value);
        return false;
    }

    void count_value()
    {
        if (++count_ > most_values) fail("one element holds more than " + std::to_string(most_values) + " values; divide it");
    }

    /// Of the object at a level, "bodies[3].shapes[0]".
    std::string path(std::size_t level) const
    {
        std::string text;
        for (std::size_t i = 0; i < level; ++i)
        {
            if (levels_[i].is_list)
                text += "[" + std::to_string(levels_[i].index) + "]";
            else
                text += (text.empty() ? "" : ".") + shortened(levels_[i].fields.back());
        }
        return text.empty() ? "the file" : text;
    }

    [[noreturn]] void fail(const std::string& problem) const { throw SceneFileError(name_ + ": " + problem); }

    const std::string& name_;
    std::span<const std::string_view> lists_;
    const ElementHandler& handle_;
    std::array<Level, most_nested + 2> levels_;
    std::size_t depth_ = 0;
    std::size_t count_ = 0;
};

/// The library's "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error ..." as "scene.json:3:5: syntax error ...".
std::string worded(const std::string& name, std::string message)
{
    if (const std::size_t tag = message.find("] "); message.starts_with('[') && tag != std::string::npos) message.erase(0, tag + 2);
    constexpr std::string_view start = "parse error at line ";
    const std::size_t comma = message.find(", column ");
    const std::size_t colon = message.find(": ");
    if (!message.starts_with(start) || comma == std::string::npos || colon == std::string::npos || comma > colon)
        return name + ": " + shortened(message);
    const std::string line = message.substr(start.size(), comma - start.size());
    const std::string column = message.substr(comma + 9, colon - comma - 9);
    return name + ":" + line + ":" + column + ": " + shortened(message.substr(colon + 2));
}

} // namespace

std::string shortened(std::string text)
{
    constexpr std::size_t most = 200;
    if (text.size() <= most) return text;
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end; // not within a character
    return text.substr(0, end) + "...";
}

json parse_parts(std::string_view text, const std::string& name, std::span<const std::string_view> lists, const ElementHandler& handle)
{
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw SceneFileError(name + ": the file is empty; write {\"carom_scene\": 1, ...}");
    PartParser parser(name, lists, handle);
    json root;
    try
    {
        root = json::parse(text, [&](int depth, json::parse_event_t event, const json& value) { return parser.on(depth, event, value); });
    }
    catch (const json::exception& error)
    {
        throw SceneFileError(worded(name, error.what()));
    }
    if (!root.is_object()) throw SceneFileError(name + ": the file is no object; write {\"carom_scene\": 1, ...}");
    return root;
}

} // namespace carom::scene_file
