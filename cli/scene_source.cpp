// Finds a scene by its name, and makes it or writes it down.
#include "cli/scene_source.hpp"

#include "cli/errors.hpp"
#include "lab/field_scenes/field_scenes.hpp"
#include "lab/scene_file/file_scene.hpp"
#include "lab/scene_file/scene_snapshot.hpp"
#include "scene_file/reader.hpp"
#include "scenes/registry.hpp"
#include "scenes/text.hpp"

#include <algorithm>

namespace carom::cli
{

using lab::FieldScene;
using lab::SceneFile;
using scenes::ParameterValues;
using scenes::Scene;
using scenes::SceneInfo;

namespace
{

bool is_file_name(const std::string& name) { return name.ends_with(".json") || name.find('/') != std::string::npos; }

/// Throws for a name that is neither a named scene's nor one of the laboratory's.
const SceneInfo& named_scene(const std::string& name)
{
    std::vector<std::string> names;
    for (const SceneInfo& info : scenes::all_scenes())
    {
        if (info.name == name) return info;
        names.push_back(info.name);
    }
    for (const FieldScene& scene : lab::field_scenes()) names.push_back(scene.name);
    throw scenes::SceneError("scene", "\"" + name + "\" does not exist", scenes::suggestion(name, names));
}

/// Whether a parameter is the laboratory scene's own.
bool is_size(const std::pair<std::string, scenes::ParameterValue>& value) { return value.first == "size"; }

int size_from(const ParameterValues& values, const FieldScene& scene)
{
    const auto found = std::find_if(values.begin(), values.end(), is_size);
    if (found == values.end()) return scene.size.initial;
    return static_cast<int>(std::get<std::int64_t>(scenes::checked(lab::size_parameter(scene), found->second)));
}

/// Time step and substeps as the parameters have them, where those are given.
void apply_common(SceneFile& file, const ParameterValues& values)
{
    const SceneInfo info = lab::FileScene::info_of(file);
    for (const auto& [name, value] : values)
    {
        const scenes::ParameterValue checked = scenes::checked(find_parameter(info.parameters, name), value);
        if (name == "step_rate") file.time_step = 1 / static_cast<float>(std::get<double>(checked));
        if (name == "substeps") file.substeps = static_cast<int>(std::get<std::int64_t>(checked));
    }
}

} // namespace

SceneSource SceneSource::find(const std::string& name)
{
    SceneSource source;
    source.name_ = name;
    if (is_file_name(name))
    {
        source.kind_ = Kind::File;
        source.file_ = std::make_shared<SceneFile>(lab::read_scene_file(name));
        source.info_ = std::make_shared<SceneInfo>(lab::FileScene::info_of(*source.file_));
        source.steps_ = source.file_->steps;
    }
    else if (const FieldScene* scene = lab::find_field_scene(name))
    {
        source.kind_ = Kind::Laboratory;
        const SceneFile small = lab::make_field_scene(*scene, {.size = scene->size.min});
        source.info_ = std::make_shared<SceneInfo>(lab::FileScene::info_of(small, {lab::size_parameter(*scene)}));
        source.steps_ = small.steps;
    }
    else
        source.info_ = {&named_scene(name), [](const SceneInfo*) {}};
    return source;
}

std::unique_ptr<Scene> SceneSource::make(const ParameterValues& values, std::uint64_t seed) const
{
    if (kind_ == Kind::Named) return scenes::make_scene(name_, values, seed);
    if (kind_ == Kind::File) return std::make_unique<lab::FileScene>(*file_, name_, values);
    const FieldScene& scene = *lab::find_field_scene(name_);
    SceneFile file = lab::make_field_scene(scene, {.size = size_from(values, scene), .seed = seed});
    return std::make_unique<lab::FileScene>(std::move(file), name_, values, std::vector{lab::size_parameter(scene)});
}

SceneFile SceneSource::scene_file(const ParameterValues& values, std::uint64_t seed) const
{
    if (kind_ == Kind::Named) return lab::snapshot_of(*scenes::make_scene(name_, values, seed));
    SceneFile file;
    ParameterValues common = values;
    if (kind_ == Kind::File)
        file = *file_;
    else
    {
        const FieldScene& scene = *lab::find_field_scene(name_);
        file = lab::make_field_scene(scene, {.size = size_from(values, scene), .seed = seed});
        std::erase_if(common, is_size);
    }
    apply_common(file, common);
    return file;
}

} // namespace carom::cli
