// Plays a scene file into a scene's world, and paints its bodies by their numbers.
#include "lab/scene_file/file_scene.hpp"

#include "lab/scene_file/check.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom::lab
{

using scenes::Color;
using scenes::SceneInfo;

namespace
{

scenes::Parameters parameters_of(const SceneInfo& info, const scenes::ParameterValues& values)
{
    scenes::Parameters parameters(info.parameters);
    for (const auto& [name, value] : values) parameters.set(name, value);
    return parameters;
}

/// Hues that lie far apart for numbers that lie near.
Color color_of(int number)
{
    const float turns = 0.618034f * static_cast<float>(number % 1000);
    return scenes::from_hue(turns - std::floor(turns), 0.5f, 0.56f);
}

/// Shows all that can move, or all that there is.
scenes::Camera camera_around(const World& world)
{
    std::optional<Aabb> moving;
    std::optional<Aabb> all;
    for (const BodyId id : world.bodies())
    {
        const BodyView body = world.body(id);
        const Aabb bounds = body.bounds();
        all = all ? merge(*all, bounds) : bounds;
        if (body.type() != BodyType::Static) moving = moving ? merge(*moving, bounds) : bounds;
    }
    if (!all) return {};
    const Aabb box = moving.value_or(*all);
    const Vec2 size = box.max - box.min;
    return {box.center(), std::max({1.2f * size.y, 0.7f * size.x, 1.0f})};
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
      file_rate_(scenes::Parameters(scene_info.parameters).real("step_rate"))
{
    playback_.begin(world());
    paint_new_bodies();
    camera_ = file.view ? scenes::Camera{file.view->center, file.view->height} : camera_around(world());
}

float FileScene::step_length() const { return real("step_rate") == file_rate_ ? file.time_step : time_step(); }

void FileScene::before_step()
{
    playback_.before_step(world(), next_step_++);
    paint_new_bodies();
}

void FileScene::after_step(const StepReport&)
{
    if (!file.rays.empty()) rays_ = playback_.cast_rays(world());
}

void FileScene::paint_new_bodies()
{
    for (; painted_ < playback_.body_count(); ++painted_)
    {
        const std::optional<BodyView> body = std::as_const(world()).find_body(playback_.body(painted_));
        if (!body || body->type() == BodyType::Static) continue;
        for (const ShapeId shape : body->shapes()) colors_[shape] = color_of(painted_);
    }
}

void FileScene::on_draw(scenes::DrawList& list) const
{
    scenes::draw_painted(world(), colors_, list);
    constexpr float largest_pin = 0.08f; // [m]
    scenes::draw_joints(world(), list, std::min(0.006f * camera_.height, largest_pin));
    for (const Ray& ray : file.rays)
    {
        const std::optional<RayHit> hit = world().cast_ray(ray.start, ray.sweep);
        const Vec2 end = hit ? hit->point : ray.start + ray.sweep;
        list.line(scenes::Layer::Marks, ray.start, end, scenes::with_alpha(scenes::paper, 0.15f));
    }
}

std::string FileScene::status() const
{
    const std::string rays =
        file.rays.empty() ? "" : ", " + std::to_string(rays_.hits) + " of " + std::to_string(file.rays.size()) + " rays hit";
    return std::to_string(world().body_count()) + " bodies, " + std::to_string(world().joint_count()) + " joints" + rays;
}

} // namespace carom::lab
