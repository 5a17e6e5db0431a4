// What games do all day: some hundred bodies, a level, rays, things that come and go.
#include "lab/field_scenes/makers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carom::lab
{

SceneFile mixed(const FieldSetup& setup)
{
    SceneFile file;
    const int columns = std::clamp(static_cast<int>(std::sqrt(static_cast<float>(setup.size))), 5, 60);
    constexpr float spacing = 1.1f; // [m], more than the largest body
    const float half_width = 0.5f * spacing * static_cast<float>(columns) + 1;
    add(file, open_box(half_width, 3 * half_width));
    scenes::Random random(setup.seed, 1);
    for (int i = 0; i < setup.size; ++i)
    {
        const Vec2 cell{static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1), static_cast<float>(i / columns)};
        const Vec2 jitter = random.point_in({{-0.05f, -0.05f}, {0.05f, 0.05f}});
        const float angle = random.uniform(-pi, pi);
        const float radius = random.uniform(0.25f, 0.48f);
        const Vec2 place = spacing * cell + Vec2{0, 2} + jitter;
        add(file, body_of({.position = place, .angle = angle}, mixed_geometry(i, radius, random)));
    }
    file.view = FileView{{0, 0.9f * half_width}, 2.6f * half_width + 3};
    return file;
}

namespace
{

constexpr int platformer_steps = 900;

/// Floor in stretches with gaps of three tiles, and steps of one tile up or down.
struct Level
{
    explicit Level(const FieldSetup& setup) : random(setup.seed, 1)
    {
        int height = 0;
        for (int x = 0; x < setup.size;)
        {
            const int stretch = random.integer(8, 16);
            for (int i = 0; i < stretch && x < setup.size; ++i, ++x) heights.push_back(height);
            for (int i = 0; i < 3 && x < setup.size; ++i, ++x) heights.push_back(gap);
            height = std::clamp(height + random.integer(-1, 1), -2, 2);
        }
    }

    static constexpr int gap = -1000;
    std::vector<int> heights; ///< of the floor's top by tile, or `gap`
    scenes::Random random;
};

/// One static body with a box for each tile, two tiles deep, and walls at both ends.
FileBody tiles_of(const Level& level)
{
    FileBody ground = ground_body();
    for (std::size_t x = 0; x < level.heights.size(); ++x)
    {
        if (level.heights[x] == Level::gap) continue;
        for (int depth = 0; depth < 2; ++depth)
        {
            const Vec2 center{static_cast<float>(x) + 0.5f, static_cast<float>(level.heights[x] - depth) - 0.5f};
            ground.shapes.push_back({offset_box(1, 1, center)});
        }
    }
    for (const float x : {-0.5f, static_cast<float>(level.heights.size()) + 0.5f}) ground.shapes.push_back({offset_box(1, 20, {x, 8})});
    return ground;
}

/// A platform over each gap.
/// @return their numbers
std::vector<int> add_platforms(SceneFile& file, const Level& level)
{
    std::vector<int> platforms;
    for (std::size_t x = 1; x + 3 < level.heights.size(); ++x)
    {
        if (level.heights[x] != Level::gap || level.heights[x - 1] == Level::gap) continue;
        const Vec2 place{static_cast<float>(x) + 1.5f, static_cast<float>(level.heights[x - 1]) - 0.2f};
        platforms.push_back(add(file, body_of({.type = BodyType::Kinematic, .position = place}, box(2.8f, 0.4f))));
    }
    return platforms;
}

/// Heaps of crates and a row of coins on every fourth tile or so.
void add_things(SceneFile& file, Level& level)
{
    for (std::size_t x = 6; x < level.heights.size(); x += 4)
    {
        if (level.heights[x] == Level::gap) continue;
        const Vec2 foot{static_cast<float>(x) + 0.5f, static_cast<float>(level.heights[x])};
        const int crates = level.random.integer(0, 3);
        for (int i = 0; i < crates; ++i)
            add(file, body_of({.position = foot + Vec2{0, 0.4f + 0.8f * static_cast<float>(i)}}, box(0.8f, 0.8f), {.density = 0.3f}));
        const BodyDef coin{.type = BodyType::Static, .position = foot + Vec2{0, 4}};
        add(file, body_of(coin, circle(0.3f), {.is_sensor = true}));
    }
}

/// @return its number
int add_player(SceneFile& file)
{
    return add(file, body_of({.position = {2.5f, 1.2f}, .locks = {.rotation = true}, .can_sleep = false, .is_bullet = true},
                             capsule({0, -0.4f}, {0, 0.4f}, 0.4f), {.density = 2, .material = {.friction = 0.1f}}));
}

/// Each platform goes up and down by one metre and turns back every second. The player runs to the right, and jumps again when a jump is over, by the
/// velocities that a game would set.
void add_events(SceneFile& file, const std::vector<int>& platforms, int player)
{
    for (int step = 0; step < platformer_steps; step += 10)
    {
        FileEvent event{.step = step};
        for (std::size_t i = 0; step % 60 == 0 && i < platforms.size(); ++i)
        {
            const bool is_up = (step / 60 + platforms[i]) % 2 == 0;
            event.set_bodies.push_back({.body = platforms[i], .linear_velocity = Vec2{0, is_up ? 1.0f : -1.0f}});
        }
        if (step % 100 == 30) event.set_bodies.push_back({.body = player, .linear_velocity = Vec2{6, 8}});
        if (!event.set_bodies.empty()) file.events.push_back(std::move(event));
    }
}

} // namespace

SceneFile platformer(const FieldSetup& setup)
{
    SceneFile file;
    Level level(setup);
    add(file, tiles_of(level));
    const std::vector<int> platforms = add_platforms(file, level);
    add_things(file, level);
    const int player = add_player(file);
    add_events(file, platforms, player);
    file.view = FileView{{64, 4}, 34};
    return file;
}

SceneFile stack(const FieldSetup& setup)
{
    SceneFile file;
    add(file, body_of({.type = BodyType::Static, .position = {0, -1}}, box(40, 2)));
    for (int i = 0; i < setup.size; ++i) add(file, body_of({.position = {0, static_cast<float>(i) + 0.5f}}, box(1, 1)));
    const auto height = static_cast<float>(setup.size);
    file.view = FileView{{0, 0.5f * height}, 1.15f * height + 2};
    return file;
}

/// Weightless bodies drift between four walls, and rays go from the middle of the field in all directions.
SceneFile rays(const FieldSetup& setup)
{
    const int bodies = setup.size / 2;
    const int columns = std::max(2, static_cast<int>(std::sqrt(static_cast<float>(2 * bodies))));
    const int rows = (bodies + columns - 1) / columns;
    constexpr float spacing = 3; // [m]
    const Vec2 half{0.5f * spacing * static_cast<float>(columns) + 1, 0.5f * spacing * static_cast<float>(rows) + 1};

    SceneFile file;
    file.world.gravity = {};
    FileBody walls = ground_body();
    const ShapeDef elastic{.material = {.friction = 0, .restitution = 1}};
    for (const float sign : {-1.0f, 1.0f})
    {
        walls.shapes.push_back({offset_box(2, 2 * half.y + 4, {sign * (half.x + 1), 0}), elastic});
        walls.shapes.push_back({offset_box(2 * half.x, 2, {0, sign * (half.y + 1)}), elastic});
    }
    add(file, walls);
    scenes::Random random(setup.seed, 1);
    for (int i = 0; i < bodies; ++i)
    {
        const Vec2 cell{static_cast<float>(i % columns) - 0.5f * static_cast<float>(columns - 1),
                        static_cast<float>(i / columns) - 0.5f * static_cast<float>(rows - 1)};
        const float radius = random.uniform(0.3f, 0.9f);
        const Vec2 velocity = 3.0f * random.direction();
        add(file, body_of({.position = spacing * cell, .linear_velocity = velocity}, mixed_geometry(i, radius, random), elastic));
    }
    for (int i = 0; i < setup.size; ++i)
    {
        const SinCos v = sin_cos(2 * pi * static_cast<float>(i) / static_cast<float>(setup.size));
        const Vec2 start = 0.8f * random.point_in({-half, half});
        file.rays.push_back({.start = start, .sweep = 20.0f * Vec2{v.cos, v.sin}});
    }
    file.view = FileView{{}, 2.1f * half.y + 2};
    return file;
}

SceneFile spawn_and_destroy(const FieldSetup& setup)
{
    constexpr int steps = 600;
    constexpr int life = 120; // steps
    constexpr float spacing = 1.1f;
    SceneFile file;
    const float half_width = 0.5f * spacing * static_cast<float>(setup.size) * 4 + 1;
    add(file, open_box(half_width, 20));
    scenes::Random random(setup.seed, 1);
    for (int step = 0; step < steps; ++step)
    {
        FileEvent event{.step = step};
        for (int i = 0; i < setup.size; ++i)
        {
            const int lane = i * 4 + step % 4; // a place is used again after four steps, when the last one has fallen out of it
            const float angle = random.uniform(-pi, pi);
            const float radius = random.uniform(0.2f, 0.4f);
            const BodyDef def{.position = {spacing * (static_cast<float>(lane) + 0.5f) - half_width + 1, 14},
                              .angle = angle,
                              .linear_velocity = {0, -15}};
            event.create_bodies.push_back(body_of(def, mixed_geometry(step + i, radius, random)));
        }
        for (int i = 0; step >= life && i < setup.size; ++i) event.destroy_bodies.push_back(1 + (step - life) * setup.size + i);
        file.events.push_back(std::move(event));
    }
    file.view = FileView{{0, 8}, 20};
    return file;
}

} // namespace carom::lab
