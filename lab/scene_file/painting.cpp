// Hues by number, and the part of the world that is worth showing.
#include "lab/scene_file/painting.hpp"

#include "scenes/painted_scene.hpp"

#include <algorithm>
#include <cmath>

namespace carom::lab
{

namespace
{

/// Hues that lie far apart for numbers that lie near.
scenes::Color color_of(int number)
{
    const float turns = 0.618034f * static_cast<float>(number % 1000);
    return scenes::from_hue(turns - std::floor(turns), 0.5f, 0.56f);
}

} // namespace

void FilePainting::paint_new_bodies(const World& world, const FilePlayback& playback)
{
    for (; painted_ < playback.body_count(); ++painted_)
    {
        const std::optional<BodyView> body = world.find_body(playback.body(painted_));
        if (!body || body->type() == BodyType::Static) continue;
        for (const ShapeId shape : body->shapes()) colors_[shape] = color_of(painted_);
    }
}

void FilePainting::draw(const World& world, const scenes::Camera& camera, scenes::DrawList& list) const
{
    scenes::draw_painted(world, colors_, list);
    constexpr float largest_pin = 0.08f; // [m]
    scenes::draw_joints(world, list, std::min(0.006f * camera.height, largest_pin));
    for (const Ray& ray : file_.rays)
    {
        const std::optional<RayHit> hit = world.cast_ray(ray.start, ray.sweep);
        const Vec2 end = hit ? hit->point : ray.start + ray.sweep;
        list.line(scenes::Layer::Marks, ray.start, end, scenes::with_alpha(scenes::paper, 0.15f));
    }
}

scenes::Camera FilePainting::camera_of(const SceneFile& file, const World& world)
{
    if (file.view) return {file.view->center, file.view->height};
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

} // namespace carom::lab
