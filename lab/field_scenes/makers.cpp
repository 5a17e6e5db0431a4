// What several scenes need.
#include "lab/field_scenes/makers.hpp"

#include "scenes/helpers.hpp"

#include <utility>

namespace carom::lab
{

FileBody body_of(const BodyDef& def, const Geometry& geometry, const ShapeDef& shape)
{
    FileBody body{.def = def};
    body.shapes.push_back({geometry, shape});
    return body;
}

FileBody ground_body() { return {.def = {.type = BodyType::Static}, .name = "ground"}; }

int add(SceneFile& file, FileBody body)
{
    file.bodies.push_back(std::move(body));
    return static_cast<int>(file.bodies.size()) - 1;
}

FileBody open_box(float half_width, float height, const ShapeDef& shape)
{
    constexpr float thickness = 2; // [m]
    FileBody ground = ground_body();
    ground.shapes.push_back({offset_box(2 * (half_width + thickness), thickness, {0, -0.5f * thickness}), shape});
    for (const float side : {-1.0f, 1.0f})
        ground.shapes.push_back({offset_box(thickness, height, {side * (half_width + 0.5f * thickness), 0.5f * height}), shape});
    return ground;
}

Geometry mixed_geometry(int kind, float radius, scenes::Random& random)
{
    const float flatness = random.uniform(0.5f, 1);
    switch (kind % 4)
    {
    case 0: return circle(radius);
    case 1: return box(1.4f * radius, 1.4f * flatness * radius);
    case 2: return capsule({-0.5f * radius, 0}, {0.5f * radius, 0}, 0.5f * flatness * radius);
    default: return scenes::random_polygon(random, radius);
    }
}

void add_pyramid(SceneFile& file, Vec2 foot, int rows)
{
    for (int row = 0; row < rows; ++row)
    {
        for (int i = 0; i < rows - row; ++i)
        {
            const Vec2 place{0.5f * static_cast<float>(row) + static_cast<float>(i) + 0.5f, static_cast<float>(row) + 0.5f};
            add(file, body_of({.position = foot + place}, box(1, 1)));
        }
    }
}

} // namespace carom::lab
