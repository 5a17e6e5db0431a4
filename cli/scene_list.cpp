// The JSON array and the page of all scenes.
#include "cli/scene_list.hpp"

#include "scenes/registry.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

namespace carom::cli
{

using nlohmann::ordered_json;
using scenes::Applies;
using scenes::Control;
using scenes::ParameterInfo;
using scenes::ParameterKind;
using scenes::SceneInfo;

namespace
{

constexpr std::size_t page_width = 100;

ordered_json plain(const scenes::ParameterValue& value)
{
    return std::visit([](const auto& v) { return ordered_json(v); }, value);
}

ordered_json parameter_json(const ParameterInfo& info)
{
    ordered_json json;
    json["name"] = info.name;
    json["description"] = info.description;
    json["kind"] = name_of(info.kind);
    json["unit"] = info.unit;
    json["default"] = plain(info.initial);
    if (info.kind == ParameterKind::Integer) json["range"] = {static_cast<std::int64_t>(info.min), static_cast<std::int64_t>(info.max)};
    if (info.kind == ParameterKind::Real) json["range"] = {info.min, info.max};
    if (info.kind == ParameterKind::Choice) json["choices"] = info.choices;
    json["live"] = info.applies == Applies::Live;
    return json;
}

ordered_json scene_json(const SceneInfo& scene)
{
    ordered_json json;
    json["name"] = scene.name;
    json["title"] = scene.title;
    json["description"] = scene.description;
    json["group"] = scene.group;
    json["parameters"] = ordered_json::array();
    for (const ParameterInfo& info : scene.parameters) json["parameters"].push_back(parameter_json(info));
    json["controls"] = ordered_json::array();
    for (const Control& control : scene.controls)
    {
        const char* kind = control.kind == Control::Kind::Key ? "key" : "pointer";
        json["controls"].push_back({{"kind", kind}, {"input", control.input}, {"action", control.action}});
    }
    return json;
}

/// Words in lines of the page's width, each line indented.
std::string wrapped(const std::string& text, std::size_t indent)
{
    std::istringstream words(text);
    std::string result;
    std::string line;
    const auto flush = [&] { result += std::string(indent, ' ') + line + "\n"; };
    for (std::string word; words >> word;)
    {
        if (!line.empty() && indent + line.size() + 1 + word.size() > page_width)
        {
            flush();
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    flush();
    return result;
}

std::string column(std::string text, std::size_t width)
{
    text.resize(std::max(width, text.size() + 2), ' ');
    return text;
}

std::string parameter_text(const ParameterInfo& info)
{
    const std::string unit = info.unit.empty() ? "" : " " + info.unit;
    const std::string when = info.applies == Applies::Live ? " (live)" : "";
    const std::string line = "    " + column(info.name + "=" + scenes::to_text(info.initial) + unit, 28) + info.description + "\n";
    return line + std::string(32, ' ') + allowed_values(info) + when + "\n";
}

std::string control_text(const Control& control)
{
    const std::string input = control.kind == Control::Kind::Key ? "key " + control.input : "pointer " + control.input;
    return "    " + column(input, 28) + control.action + "\n";
}

} // namespace

ordered_json scenes_json()
{
    ordered_json json = ordered_json::array();
    for (const SceneInfo& scene : scenes::all_scenes()) json.push_back(scene_json(scene));
    return json;
}

std::string scenes_text()
{
    std::string text;
    for (const SceneInfo& scene : scenes::all_scenes())
    {
        text += (text.empty() ? "" : "\n") + scene.name + "\n" + wrapped(scene.description, 2) + "\n  parameters\n";
        for (const ParameterInfo& info : scene.parameters) text += parameter_text(info);
        text += "\n  controls\n";
        for (const Control& control : scene.controls) text += control_text(control);
    }
    return text;
}

} // namespace carom::cli
