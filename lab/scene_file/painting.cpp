// Hues by number, and the part of the world that is worth showing.
#include "lab/scene_file/painting.hpp"

#include "scenes/framing.hpp"
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

/// What moves may turn around, so that a narrow picture shows at least as much to the sides as the view is high.
scenes::Camera camera_of(const FileView& view, const std::optional<Aabb>& movable)
{
    constexpr float margin = 1.08f;
    if (!movable) return {view.center, view.height};
    const float width = std::max(view.height, 2 * margin * std::max(view.center.x - movable->min.x, movable->max.x - view.center.x));
    return {.center = view.center, .height = view.height, .width = std::min(width, 16 * view.height / 9)};
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
    std::optional<Aabb> box = scenes::movable_bounds(world);
    if (file.view) return lab::camera_of(*file.view, box);
    if (!box)
        for (const BodyId id : world.bodies()) box = box ? merge(*box, world.body(id).bounds()) : world.body(id).bounds();
    if (!box) return {};
    constexpr Vec2 least = {0.25f, 0.25f}; // half of a picture's size at least [m]
    return scenes::framed(merge(*box, {box->center() - least, box->center() + least}));
}

} // namespace carom::lab
