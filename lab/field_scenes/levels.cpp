// Large worlds of which little is busy: a map of static tiles, and piles of which most sleep.
#include "lab/field_scenes/makers.hpp"

#include <algorithm>
#include <utility>

namespace carom::lab
{

namespace
{

constexpr int floors = 8;          // of the tile map
constexpr int floor_spacing = 14;  // [tiles], from one floor to the next
constexpr int floor_thickness = 4; // [tiles]
constexpr int most_slope = 2;      // of a floor's top above and below its middle [tiles]

/// A hilly floor as one static body with a box for each tile.
FileBody tile_floor(int length, int bottom, scenes::Random& random)
{
    FileBody body = ground_body();
    const auto add_tile = [&](int x, int y)
    { body.shapes.push_back({offset_box(1, 1, {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f})}); };
    int slope = 0;
    for (int x = 0; x < length; ++x)
    {
        slope = std::clamp(slope + random.integer(-1, 1), -most_slope, most_slope);
        for (int y = 0; y < floor_thickness + slope; ++y) add_tile(x, bottom + y);
    }
    for (int y = 0; y < floor_spacing; ++y)
    {
        add_tile(-1, bottom + y);
        add_tile(length, bottom + y);
    }
    return body;
}

} // namespace

/// Bodies of every kind run over hills of tiles. None sleeps: each of them looks for pairs among the tiles in every step.
SceneFile tile_world(const FieldSetup& setup)
{
    constexpr int spacing = 4; // of the bodies of a floor [tiles]
    SceneFile file;
    file.world.sleep.is_enabled = false;
    scenes::Random random(setup.seed, 1);
    for (int floor = 0; floor < floors; ++floor) add(file, tile_floor(setup.size, floor * floor_spacing, random));
    for (int floor = 0; floor < floors; ++floor)
    {
        for (int x = 0; x < setup.size; x += spacing)
        {
            const Vec2 place{static_cast<float>(x) + 0.5f, static_cast<float>(floor * floor_spacing + floor_thickness + most_slope) + 0.6f};
            const Vec2 velocity{random.uniform(-6, 6), 0};
            const float radius = random.uniform(0.25f, 0.48f);
            add(file, body_of({.position = place, .linear_velocity = velocity}, mixed_geometry(x / spacing + floor, radius, random)));
        }
    }
    const auto length = static_cast<float>(setup.size);
    file.view = FileView{{0.5f * length, 0.5f * floors * floor_spacing}, 0.6f * length + floor_spacing};
    return file;
}

/// Piles fall asleep; every two seconds the top box of each fourth pile hops, which wakes that pile alone.
SceneFile sleep(const FieldSetup& setup)
{
    constexpr int rows = 10;
    constexpr int boxes = rows * (rows + 1) / 2;
    constexpr float spacing = 12;   // of the piles [m]
    constexpr int wake_every = 120; // steps
    constexpr int steps = 600;
    SceneFile file;
    const float width = spacing * static_cast<float>(setup.size);
    add(file, body_of({.type = BodyType::Static, .position = {0, -1}}, box(width + 20, 2)));
    for (int i = 0; i < setup.size; ++i) add_pyramid(file, {spacing * static_cast<float>(i) - 0.5f * width + 1, 0}, rows);
    for (int step = wake_every; step < steps; step += wake_every)
    {
        FileEvent event{.step = step};
        for (int i = step / wake_every % 4; i < setup.size; i += 4)
            event.set_bodies.push_back({.body = (i + 1) * boxes, .linear_velocity = Vec2{0, 2}}); // body 0 is the ground
        if (!event.set_bodies.empty()) file.events.push_back(std::move(event));
    }
    file.view = FileView{{0, 0.25f * width}, 0.6f * width + 10};
    return file;
}

} // namespace carom::lab
