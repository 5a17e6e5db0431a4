// Writes scenes into files, and lists those that are made for it.
#include "cli/export_command.hpp"

#include "cli/errors.hpp"
#include "cli/outputs.hpp"
#include "cli/scene_source.hpp"
#include "files/text.hpp"
#include "lab/field_scenes/field_scenes.hpp"
#include "scene_file/check.hpp"
#include "scene_file/schema.hpp"
#include "scene_file/writer.hpp"
#include "scenes/text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace carom::cli
{

using lab::FieldScene;
using lab::SceneFile;

namespace
{

std::string list_text()
{
    std::string text;
    std::string suite;
    for (const FieldScene& scene : lab::field_scenes())
    {
        if (scene.suite != suite) text += (text.empty() ? "" : "\n") + scene.suite + "\n";
        suite = scene.suite;
        std::string name = scene.name;
        name.resize(std::max<std::size_t>(18, name.size() + 2), ' ');
        text += "  " + name + scene.description + "\n" + std::string(20, ' ') + "size=" + std::to_string(scene.size.initial) + " " +
                scene.size.what + ", from " + std::to_string(scene.size.min) + " to " + std::to_string(scene.size.max) + "; " +
                std::to_string(scene.steps) + " steps\n";
    }
    return text;
}

nlohmann::ordered_json list_json()
{
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const FieldScene& scene : lab::field_scenes())
    {
        list.push_back({{"name", scene.name},
                        {"suite", scene.suite},
                        {"description", scene.description},
                        {"size", {{"what", scene.size.what}, {"default", scene.size.initial}, {"range", {scene.size.min, scene.size.max}}}},
                        {"steps", scene.steps}});
    }
    return list;
}

std::string contents_of(const SceneFile& file)
{
    std::size_t bodies = file.bodies.size();
    std::size_t joints = file.joints.size();
    for (const lab::FileEvent& event : file.events)
    {
        bodies += event.create_bodies.size();
        joints += event.create_joints.size();
    }
    const std::vector<std::string> needs = lab::needs_of(file);
    std::string text = std::to_string(bodies) + " bodies, " + std::to_string(joints) + " joints, " + std::to_string(file.events.size()) +
                       " events, " + std::to_string(file.steps) + " steps";
    if (!needs.empty()) text += "; an engine needs " + scenes::joined(needs);
    return text;
}

} // namespace

void export_command(const ExportRequest& request, const Surroundings& surroundings)
{
    if (request.schema) return void(surroundings.out << lab::scene_file_schema());
    if (request.lists) return void(surroundings.out << (request.is_json ? list_json().dump(2) + "\n" : list_text()));
    if (request.scene.empty()) throw BadUsage("a scene is missing; give its name and a file, or --list");
    if (request.file.empty()) throw BadUsage("a file is missing; give its name, as " + request.scene + ".json");
    const SceneSource source = SceneSource::find(request.scene);
    SceneFile file = source.scene_file(scenes::parsed_settings(source.info().parameters, request.settings), request.seed);
    if (request.steps) file.steps = *request.steps;
    Outputs outputs(surroundings);
    files::OutputFile& out = outputs.open("export", request.file);
    lab::write_scene_file(out.stream(), file);
    out.commit();
    const std::string name = files::is_standard_output(request.file) ? request.scene : request.file;
    for (const std::string& note : file.notes) surroundings.err << "carom: " << files::printable(name + ": " + note) << "\n";
    outputs.words() << files::printable(name + ": " + contents_of(file)) << "\n";
}

} // namespace carom::cli
