// Bodies on joints, and bodies in drums.
#include "lab/field_scenes/makers.hpp"

#include <cmath>

namespace carom::lab
{

namespace
{

constexpr float drum_speed = 25 * pi / 180; // [rad/s]

/// A closed line whose inside is solid: its front lies on the right of the way, so it goes around clockwise.
FileChain ring(Vec2 center, float radius, int points, const Material& material = {})
{
    FileChain chain;
    chain.def.is_loop = true;
    chain.def.sides = ChainSides::OneSided;
    if (!(material == Material{})) chain.materials = {material};
    for (int i = 0; i < points; ++i)
    {
        const SinCos v = sin_cos(-2 * pi * static_cast<float>(i) / static_cast<float>(points));
        chain.points.push_back(center + radius * Vec2{v.cos, v.sin});
    }
    return chain;
}

FileJoint pin(int a, int b, Vec2 in_a, Vec2 in_b)
{
    return {.body_a = a, .body_b = b, .def = {.frame_a = {in_a, {}}, .frame_b = {in_b, {}}}, .spec = RevoluteJoint{}};
}

} // namespace

/// Circles that do not touch each other, each pinned to those left of it and above it. Seven in the middle of the top row are fixed.
SceneFile joint_grid(const FieldSetup& setup)
{
    SceneFile file;
    file.world.sleep.is_enabled = false;
    const int count = setup.size;
    const ShapeDef shape{.filter = {.category = 2, .mask = ~std::uint64_t{2}}};
    for (int column = 0; column < count; ++column)
    {
        for (int row = 0; row < count; ++row)
        {
            const bool is_fixed = row == 0 && std::abs(column - count / 2) <= 3;
            const Vec2 place{static_cast<float>(column), -static_cast<float>(row)};
            const int body =
                add(file, body_of({.type = is_fixed ? BodyType::Static : BodyType::Dynamic, .position = place}, circle(0.4f), shape));
            if (row > 0) file.joints.push_back(pin(body - 1, body, {0, -0.5f}, {0, 0.5f}));
            if (column > 0) file.joints.push_back(pin(body - count, body, {0.5f, 0}, {-0.5f, 0}));
        }
    }
    const auto width = static_cast<float>(count);
    file.view = FileView{{0.5f * width, -0.5f * width}, 1.15f * width};
    return file;
}

/// The beam turns by a motor that is strong enough to plough through all.
SceneFile spinner(const FieldSetup& setup)
{
    constexpr float radius = 40;
    SceneFile file;
    FileBody ground = ground_body();
    ground.chains.push_back(ring({}, radius, 360, {.friction = 0.1f}));
    const int ring_number = add(file, ground);
    const Vec2 hub{0, -20};
    const int beam = add(file, body_of({.position = hub, .can_sleep = false}, rounded_box(0.8f, 40, 0.2f), {.material = {.friction = 0}}));
    FileJoint motor = pin(ring_number, beam, hub, {});
    motor.spec = RevoluteJoint{.motor = Motor{5, 40000}};
    file.joints.push_back(motor);

    const ShapeDef shape{.density = 0.25f, .material = {.friction = 0.1f, .restitution = 0.1f}};
    constexpr float widths[] = {1, 0.7f, 0.7f};
    constexpr float gap = 0.02f;
    constexpr float row_height = 0.72f;
    int made = 0;
    // Rows from the bottom up, as wide as the ring is there, on both sides of the beam.
    for (float y = -radius + 1; made < setup.size && y < radius - 1; y += row_height)
    {
        const float reach = radius - 0.6f;
        const float end = std::sqrt(std::max(reach * reach - (std::abs(y) + 0.4f) * (std::abs(y) + 0.4f), 0.0f));
        for (float x = -end; made < setup.size;)
        {
            const float width = widths[made % 3];
            const bool meets_beam = std::abs(y - hub.y) < 21 && x < 0.5f && x + width > -0.5f;
            if (meets_beam) x = 0.5f;
            if (x + width > end) break;
            const BodyDef def{.position = {x + 0.5f * width, y}};
            const Geometry geometry = made % 3 == 0   ? Geometry(capsule({-0.25f, 0}, {0.25f, 0}, 0.25f))
                                      : made % 3 == 1 ? Geometry(circle(0.35f))
                                                      : Geometry(box(0.7f, 0.7f));
            add(file, body_of(def, geometry, shape));
            x += width + gap;
            ++made;
        }
    }
    file.view = FileView{{}, 84};
    return file;
}

SceneFile tumbler(const FieldSetup& setup)
{
    SceneFile file;
    FileBody drum{.def = {.type = BodyType::Kinematic, .angular_velocity = drum_speed}, .name = "drum"};
    drum.shapes = {
        {offset_box(1, 21, {10, 0})}, {offset_box(1, 21, {-10, 0})}, {offset_box(21, 1, {0, 10})}, {offset_box(21, 1, {0, -10})}};
    add(file, drum);
    constexpr float spacing = 0.4f;
    const float middle = 0.5f * static_cast<float>(setup.size - 1);
    // A block of more than 45 boxes a side reaches into the drum's walls, unless they lie closer.
    const float step = std::min(spacing, 18.0f / static_cast<float>(setup.size));
    for (int i = 0; i < setup.size; ++i)
        for (int j = 0; j < setup.size; ++j)
            add(file, body_of({.position = {step * (static_cast<float>(i) - middle), step * (static_cast<float>(j) - middle)}},
                              box(0.25f, 0.25f)));
    file.view = FileView{{}, 32};
    return file;
}

SceneFile washer(const FieldSetup& setup)
{
    constexpr float radius = 14;
    constexpr float square = 0.2f;
    SceneFile file;
    FileBody drum{.def = {.type = BodyType::Kinematic, .angular_velocity = drum_speed}, .name = "drum"};
    for (int i = 0; i < 4; ++i)
    {
        const float angle = 0.5f * pi * static_cast<float>(i);
        drum.shapes.push_back({offset_box(2.2f, 1, rotate(rotation(angle), Vec2{radius - 0.9f, 0}), angle)});
    }
    drum.chains.push_back(ring({}, radius, 180));
    add(file, drum);
    constexpr float spacing = 0.21f;
    const int columns = std::max(1, static_cast<int>(std::sqrt(static_cast<float>(setup.size))));
    const int rows = (setup.size + columns - 1) / columns;
    for (int i = 0; i < setup.size; ++i)
    {
        const Vec2 cell{static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1),
                        static_cast<float>(i / columns) - 0.5f * static_cast<float>(rows - 1)};
        add(file, body_of({.position = spacing * cell}, box(square, square)));
    }
    file.view = FileView{{}, 30};
    return file;
}

} // namespace carom::lab
