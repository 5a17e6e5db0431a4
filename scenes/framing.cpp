// Boxes to cameras.
#include "scenes/framing.hpp"

#include <algorithm>

namespace carom::scenes
{

namespace
{

constexpr float aspect = 16.0f / 9;

/// @param margins of the box's size: left and right, below, above
Camera with_margins(const Aabb& box, float beside, float below, float above)
{
    const Vec2 size = box.max - box.min;
    const float width = (1 + 2 * beside) * size.x;
    const float height = std::max((1 + below + above) * size.y, width / aspect);
    // What is left of the height beside the margins goes above and below in their ratio.
    const float foot = (height - size.y) * below / (below + above);
    return {.center = {0.5f * (box.min.x + box.max.x), box.min.y - foot + 0.5f * height}, .height = height, .width = width};
}

} // namespace

std::optional<Aabb> movable_bounds(const World& world)
{
    std::optional<Aabb> box;
    for (const BodyId id : world.bodies())
    {
        const BodyView body = world.body(id);
        if (body.type() == BodyType::Static) continue;
        box = box ? merge(*box, body.bounds()) : body.bounds();
    }
    return box;
}

Camera framed(const Aabb& content) { return with_margins(content, 0.04f, 0.06f, 0.16f); }

Camera framed(const World& world, const Aabb& more)
{
    const std::optional<Aabb> movable = movable_bounds(world);
    return framed(movable ? merge(*movable, more) : more);
}

Camera framed_field(const Aabb& field) { return with_margins(field, 0.02f, 0.02f, 0.02f); }

Aabb visible_box(const Camera& camera)
{
    const Vec2 half = 0.5f * camera.height * Vec2{aspect, 1};
    return {camera.center - half, camera.center + half};
}

} // namespace carom::scenes
