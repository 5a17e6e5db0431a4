// Fast things against thin ones: what an engine lets through.
#include "lab/field_scenes/makers.hpp"

namespace carom::lab
{

namespace
{

/// What stands in the way of a shot, at x = 0.
FileBody obstacle_of(int kind, Vec2 place)
{
    constexpr float thickness = 0.1f; // [m]
    constexpr float height = 2;       // [m]
    switch (kind)
    {
    case 0: return body_of({.type = BodyType::Static, .position = place}, box(thickness, height));
    case 1: return body_of({.type = BodyType::Static, .position = place}, segment({0, -0.5f * height}, {0, 0.5f * height}));
    case 2: return body_of({.position = place}, box(thickness, height), {.density = 20});
    default: return body_of({.position = place}, circle(0.3f));
    }
}

} // namespace

/// Each shot has a lane of its own, and flies at 10 to 300 m/s at a thin wall, a bare segment, a plate that is free to move, or a ball. Every second one of
/// a kind is marked as a bullet. In half of the lanes it is a ball, in the others a box that spins.
SceneFile shots(const FieldSetup& setup)
{
    constexpr float lane_width = 4; // [m]
    SceneFile file;
    file.world.gravity = {};
    scenes::Random random(setup.seed, 1);
    for (int lane = 0; lane < setup.size; ++lane)
    {
        const float y = lane_width * (static_cast<float>(lane) - 0.5f * static_cast<float>(setup.size - 1));
        const float share = static_cast<float>(lane) / static_cast<float>(setup.size);
        const float distance = random.uniform(4, 10);
        add(file, obstacle_of(lane % 4, {0, y}));
        BodyDef shot{.position = {-distance, y}, .linear_velocity = {10 + 290 * share, 0}, .is_bullet = lane / 4 % 2 == 1};
        const bool is_ball = lane / 8 % 2 == 0;
        if (!is_ball) shot.angular_velocity = random.uniform(-5, 5);
        add(file, body_of(shot, is_ball ? Geometry(circle(0.1f)) : Geometry(box(0.2f, 0.2f)), {.density = 2}));
    }
    file.view = FileView{{0, 0}, 20};
    return file;
}

} // namespace carom::lab
