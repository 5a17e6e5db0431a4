// Reads an input file, and words its errors by entry and field.
#include "cli/input_script.hpp"

#include "cli/errors.hpp"
#include "files/input_file.hpp"
#include "scenes/parameters.hpp"
#include "scenes/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace carom::cli
{

using nlohmann::json;
using scenes::PointerEvent;

namespace
{

template <class T>
struct Word
{
    const char* name;
    T value;
};

constexpr Word<PointerEvent::Action> actions[] = {{"down", PointerEvent::Action::Down},
                                                  {"up", PointerEvent::Action::Up},
                                                  {"move", PointerEvent::Action::Move},
                                                  {"wheel", PointerEvent::Action::Wheel}};
constexpr Word<PointerEvent::Button> buttons[] = {
    {"left", PointerEvent::Button::Left}, {"middle", PointerEvent::Button::Middle}, {"right", PointerEvent::Button::Right}};

constexpr std::size_t most_bytes = 64 << 20; // of a file: hundreds of thousands of entries; bounds the memory for an endless one
constexpr int most_nested = 8;               // deeper than an entry ever goes; printing a value takes stack for each level
constexpr double most_notches = 1e6;         // of a wheel in one entry

/// Enough of a text to recognise it in a message.
std::string shortened(std::string text)
{
    constexpr std::size_t most = 200;
    if (text.size() <= most) return text;
    std::size_t end = most;
    while ((static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end; // not within a character
    return text.substr(0, end) + "...";
}

/// The library's message without the name of its exception, "[json.exception.parse_error.101] ".
std::string without_tag(const std::string& message)
{
    const std::size_t end = message.find("] ");
    return message.starts_with('[') && end != std::string::npos ? message.substr(end + 2) : message;
}

std::vector<std::string> key_names(const scenes::SceneInfo& scene)
{
    std::vector<std::string> names;
    for (const scenes::Control& control : scene.controls)
    {
        if (control.kind == scenes::Control::Kind::Key) names.push_back(control.input);
    }
    return names;
}

} // namespace

/// Reads one entry, and knows its place for messages.
class ScriptReader
{
public:
    ScriptReader(const std::string& source, std::size_t number, const json& entry, const scenes::SceneInfo& scene)
        : place_(source + ", entry " + std::to_string(number)),
          entry_(entry),
          scene_(scene)
    {
        if (!entry.is_object()) fail("is not an object", "write {\"step\": ...}");
    }

    void read_into(InputScript& script) const
    {
        const int step = read_step();
        const bool is_key = entry_.contains("key");
        if (is_key == entry_.contains("pointer")) fail("needs one of the fields \"key\" and \"pointer\"", "give the one that is meant");
        script.by_step_[step].push_back(is_key ? InputScript::Event(InputScript::KeyPress{read_key()})
                                               : InputScript::Event(read_pointer()));
    }

private:
    int read_step() const
    {
        const json& step = field("step");
        constexpr int most = std::numeric_limits<int>::max();
        const bool fits = step.is_number_unsigned() && step.get<std::uint64_t>() <= most;
        if (!fits) fail_field("step", "give a whole number, 0 or more");
        return step.get<int>();
    }

    std::string read_key() const
    {
        refuse_other_fields({"step", "key"});
        const std::string key = scenes::lower_case(read_text("key"));
        for (const std::string& name : key_names(scene_))
        {
            if (name == key) return key;
        }
        fail_field("key", "the keys of " + scene_.name + " are " + scenes::joined(key_names(scene_)));
    }

    PointerEvent read_pointer() const
    {
        PointerEvent event;
        event.action = read_word("pointer", actions);
        event.position = {read_number("x", scenes::farthest_pointer), read_number("y", scenes::farthest_pointer)};
        const bool has_button = event.action == PointerEvent::Action::Down || event.action == PointerEvent::Action::Up;
        if (has_button)
        {
            refuse_other_fields({"step", "pointer", "button", "x", "y"});
            event.button = read_word("button", buttons);
        }
        else if (event.action == PointerEvent::Action::Wheel)
        {
            refuse_other_fields({"step", "pointer", "wheel", "x", "y"});
            event.wheel = read_number("wheel", most_notches);
        }
        else
            refuse_other_fields({"step", "pointer", "x", "y"});
        return event;
    }

    template <class T, std::size_t N>
    T read_word(const char* name, const Word<T> (&words)[N]) const
    {
        const std::string text = scenes::lower_case(read_text(name));
        std::vector<std::string> known;
        for (const Word<T>& word : words)
        {
            if (text == word.name) return word.value;
            known.emplace_back(word.name);
        }
        fail_field(name, "give one of " + scenes::joined(known));
    }

    std::string read_text(const char* name) const
    {
        if (!field(name).is_string()) fail_field(name, "give a text in quotes");
        return field(name).get<std::string>();
    }

    /// @param most either way of zero
    float read_number(const char* name, double most) const
    {
        const std::string limit = scenes::to_text(most);
        if (!field(name).is_number() || std::abs(field(name).get<double>()) > most)
            fail_field(name, "give a number from -" + limit + " to " + limit);
        return field(name).get<float>();
    }

    const json& field(const char* name) const
    {
        if (!entry_.contains(name)) fail("has no field \"" + std::string(name) + "\"", "add it");
        return entry_.at(name);
    }

    void refuse_other_fields(const std::vector<std::string>& known) const
    {
        for (const auto& item : entry_.items())
        {
            if (std::find(known.begin(), known.end(), item.key()) == known.end())
                fail("has an unknown field \"" + shortened(item.key()) + "\"", "its fields are " + scenes::joined(known));
        }
    }

    [[noreturn]] void fail_field(const char* name, const std::string& remedy) const
    {
        fail("field \"" + std::string(name) + "\" is " + shortened(entry_.at(name).dump()), remedy);
    }
    [[noreturn]] void fail(const std::string& problem, const std::string& remedy) const
    {
        throw BadUsage("--input: " + place_ + ": " + problem + "; " + remedy);
    }

    std::string place_;
    const json& entry_;
    const scenes::SceneInfo& scene_;
};

InputScript InputScript::read(const std::filesystem::path& path, const scenes::SceneInfo& scene)
{
    try
    {
        return parse(files::read_text(path, most_bytes), path.string(), scene);
    }
    catch (const files::CannotRead& error)
    {
        throw BadUsage(std::string("--input: ") + error.what());
    }
}

InputScript InputScript::parse(std::string_view text, const std::string& name, const scenes::SceneInfo& scene)
{
    const auto refuse_depth = [&](int depth, json::parse_event_t, const json&)
    {
        if (depth > most_nested) throw BadUsage("--input: " + name + ": nested too deeply; an entry holds texts and numbers");
        return true;
    };
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw BadUsage("--input: " + name + ": the file is empty; write [ {\"step\": ...}, ... ]");
    json entries;
    try
    {
        entries = json::parse(text, refuse_depth);
    }
    catch (const json::exception& error)
    {
        throw BadUsage("--input: " + name + ": not JSON: " + shortened(without_tag(error.what())));
    }
    if (!entries.is_array()) throw BadUsage("--input: " + name + ": not an array; write [ {\"step\": ...}, ... ]");

    InputScript script;
    std::size_t number = 0;
    for (const json& entry : entries) ScriptReader(name, ++number, entry, scene).read_into(script);
    return script;
}

void InputScript::apply(scenes::Scene& scene, int step) const
{
    const auto found = by_step_.find(step);
    if (found == by_step_.end()) return;
    for (const Event& event : found->second)
    {
        if (const auto* pointer = std::get_if<PointerEvent>(&event)) scene.pointer(*pointer);
        if (const auto* key = std::get_if<KeyPress>(&event)) scene.key(key->name);
    }
}

std::size_t InputScript::size() const { return count_from(0); }

std::size_t InputScript::count_from(int step) const
{
    std::size_t count = 0;
    for (auto at = by_step_.lower_bound(step); at != by_step_.end(); ++at) count += at->second.size();
    return count;
}

} // namespace carom::cli
