// Boxes and other bodies in heaps: pyramids that stand, piles that settle, and what is driven into them.
#include "lab/field_scenes/makers.hpp"
#include "scenes/helpers.hpp"

#include <array>
#include <cmath>

namespace carom::lab
{

namespace
{

/// A table: a plate on two legs.
FileBody table(const BodyDef& def)
{
    FileBody body{.def = def};
    body.shapes = {{offset_box(2, 0.4f, {0, 0.5f})}, {offset_box(0.3f, 1, {-0.75f, -0.2f})}, {offset_box(0.3f, 1, {0.75f, -0.2f})}};
    return body;
}

/// A cross of two beams with a knob at each end.
FileBody cross_of_beams(const BodyDef& def)
{
    FileBody body{.def = def};
    body.shapes = {{box(1.6f, 0.3f)}, {box(0.3f, 1.6f)}};
    for (const Vec2 end : {Vec2{0.8f, 0}, Vec2{0, 0.8f}, Vec2{-0.8f, 0}, Vec2{0, -0.8f}}) body.shapes.push_back({circle(0.2f, end)});
    return body;
}

/// Two capsules that make an angle, and a weight in it.
FileBody elbow(const BodyDef& def)
{
    FileBody body{.def = def};
    body.shapes = {
        {capsule({-0.8f, -0.6f}, {0, 0.6f}, 0.2f)}, {capsule({0, 0.6f}, {0.8f, -0.6f}, 0.2f)}, {circle(0.35f, {0, 0.6f}), {.density = 2}}};
    return body;
}

} // namespace

SceneFile large_pyramid(const FieldSetup& setup)
{
    SceneFile file;
    file.world.sleep.is_enabled = false;
    const auto width = static_cast<float>(setup.size);
    add(file, body_of({.type = BodyType::Static, .position = {0, -1}}, box(2 * width + 20, 2)));
    add_pyramid(file, {-0.5f * width, 0}, setup.size);
    file.view = FileView{{0, 0.45f * width}, 1.1f * width + 4};
    return file;
}

SceneFile many_pyramids(const FieldSetup& setup)
{
    constexpr int rows = 10;
    constexpr float spacing = 11; // of pyramids and of shelves [m]
    SceneFile file;
    file.world.sleep.is_enabled = false;
    const float width = spacing * static_cast<float>(setup.size);
    FileBody shelves = ground_body();
    for (int shelf = 0; shelf < setup.size; ++shelf)
    {
        const float height = spacing * static_cast<float>(shelf);
        shelves.shapes.push_back({segment({-0.5f * width, height}, {0.5f * width, height})});
    }
    add(file, shelves);
    for (int shelf = 0; shelf < setup.size; ++shelf)
        for (int i = 0; i < setup.size; ++i)
            add_pyramid(file, {-0.5f * width + spacing * static_cast<float>(i) + 0.5f, spacing * static_cast<float>(shelf)}, rows);
    file.view = FileView{{0, 0.5f * width}, 1.05f * width};
    return file;
}

/// Columns of three kinds of bodies fall into a box that they half fill.
SceneFile compounds(const FieldSetup& setup)
{
    constexpr int columns = 20;
    constexpr float spacing = 2.6f; // [m], more than the largest body however it is turned
    SceneFile file;
    const float half_width = 0.5f * spacing * columns + 1;
    add(file, open_box(half_width, 120));
    scenes::Random random(setup.seed, 1);
    for (int i = 0; i < setup.size; ++i)
    {
        const float across = (static_cast<float>(i % columns) + 0.5f) * spacing - 0.5f * spacing * columns;
        const Vec2 place{across + random.uniform(-0.05f, 0.05f), 1.5f + spacing * static_cast<float>(i / columns)};
        const BodyDef def{.position = place, .angle = random.uniform(-pi, pi)};
        const int kind = (i + i / columns) % 3;
        add(file, kind == 0 ? table(def) : kind == 1 ? cross_of_beams(def) : elbow(def));
    }
    file.view = FileView{{0, 26}, 60};
    return file;
}

/// A plate half as high as the pile goes to and fro through it, at 18 m/s.
SceneFile junkyard(const FieldSetup& setup)
{
    constexpr int columns = 100;
    constexpr float spacing = 1.1f; // [m], more than the largest piece
    constexpr float half_width = 0.5f * spacing * columns + 10;
    SceneFile file;
    add(file, open_box(half_width, 60));
    const int pusher = add(file, body_of({.type = BodyType::Kinematic, .position = {-half_width + 3, 5.2f}}, rounded_box(2, 10, 0.3f)));
    scenes::Random random(setup.seed, 1);
    for (int i = 0; i < setup.size; ++i)
    {
        const float across = (static_cast<float>(i % columns) + 0.5f) * spacing - 0.5f * spacing * columns;
        const Vec2 place{across, 0.8f + spacing * static_cast<float>(i / columns)};
        const float angle = random.uniform(-pi, pi);
        const float radius = random.uniform(0.3f, 0.54f);
        add(file, body_of({.position = place, .angle = angle}, scenes::random_polygon(random, radius)));
    }
    constexpr int turn_every = 360; // steps
    for (int step = 0; step < 2 * turn_every + 120; step += turn_every)
    {
        const float way = step / turn_every % 2 == 0 ? 1.0f : -1.0f;
        file.events.push_back({.step = step, .set_bodies = {{.body = pusher, .linear_velocity = Vec2{way * 18, 0}}}});
    }
    file.view = FileView{{0, 24}, 74};
    return file;
}

/// Everything floats; the squares sleep until they are hit.
SceneFile smash(const FieldSetup& setup)
{
    constexpr float square = 0.4f; // [m]
    SceneFile file;
    file.world.gravity = {};
    add(file, body_of({.position = {-20, 0}, .linear_velocity = {40, 0}}, box(8, 8), {.density = 8}));
    const int rows = setup.size;
    const int columns = rows + rows / 2;
    for (int i = 0; i < columns; ++i)
    {
        for (int j = 0; j < rows; ++j)
        {
            const float up = static_cast<float>(j) - 0.5f * static_cast<float>(rows - 1);
            FileBody body = body_of({.position = {30 + square * static_cast<float>(i), square * up}}, box(square, square));
            body.is_awake = false;
            add(file, body);
        }
    }
    file.view = FileView{{50, 0}, 80};
    return file;
}

} // namespace carom::lab
