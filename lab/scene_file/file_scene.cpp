// Plays a scene file into a scene's world.
#include "lab/scene_file/file_scene.hpp"

#include "scene_file/check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom::lab
{

using scenes::SceneInfo;

namespace
{

scenes::Parameters parameters_of(const SceneInfo& info, const scenes::ParameterValues& values)
{
    scenes::Parameters parameters(info.parameters);
    for (const auto& [name, value] : values) parameters.set(name, value);
    return parameters;
}

FileSceneParts parts_of(SceneFile file, std::string source, const std::vector<scenes::ParameterInfo>& own_parameters)
{
    check(file, source);
    SceneInfo info = FileScene::info_of(file, own_parameters);
    return {std::move(file), std::move(source), std::move(info)};
}

} // namespace

SceneInfo FileScene::info_of(const SceneFile& file, const std::vector<scenes::ParameterInfo>& own_parameters)
{
    SceneInfo info{.name = file.name.empty() ? "scene-file" : file.name,
                   .title = file.name.empty() ? "Scene file" : file.name,
                   .description = file.description,
                   .group = "Files",
                   .controls = scenes::with_common_controls({}),
                   .parameters = scenes::with_common_parameters(own_parameters, BroadPhaseType::Tree, file.substeps)};
    for (scenes::ParameterInfo& parameter : info.parameters)
    {
        if (parameter.name != "step_rate") continue;
        const double rate = 1 / static_cast<double>(file.time_step);
        parameter.initial = std::round(1000 * rate) / 1000;
        parameter.min = std::min(parameter.min, rate);
        parameter.max = std::max(parameter.max, rate);
    }
    return info;
}

FileScene::FileScene(SceneFile scene_file, std::string source_name, const scenes::ParameterValues& values,
                     const std::vector<scenes::ParameterInfo>& own_parameters)
    : FileSceneParts(parts_of(std::move(scene_file), std::move(source_name), own_parameters)),
      PaintedScene({scene_info, parameters_of(scene_info, values), 1}, FilePlayback::world_def(file)),
      playback_(file, source),
      painting_(file),
      file_rate_(scenes::Parameters(scene_info.parameters).real("step_rate"))
{
    playback_.begin(world());
    painting_.paint_new_bodies(world(), playback_);
    camera_ = FilePainting::camera_of(file, world());
}

float FileScene::step_length() const { return real("step_rate") == file_rate_ ? file.time_step : time_step(); }

void FileScene::before_step()
{
    playback_.before_step(world(), next_step_++);
    painting_.paint_new_bodies(world(), playback_);
}

void FileScene::after_step(const StepReport&)
{
    if (!file.rays.empty()) rays_ = playback_.cast_rays(world());
}

void FileScene::on_draw(scenes::DrawList& list) const { painting_.draw(world(), camera_, list); }

std::string FileScene::status() const
{
    const std::string rays =
        file.rays.empty() ? "" : ", " + std::to_string(rays_.hits) + " of " + std::to_string(file.rays.size()) + " rays hit";
    return std::to_string(world().body_count()) + " bodies, " + std::to_string(world().joint_count()) + " joints" + rays;
}

} // namespace carom::lab
