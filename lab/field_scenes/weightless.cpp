// No ground: the collision scene that Carom inherited, and planets around a sun.
#include "lab/field_scenes/makers.hpp"
#include "lab/scene_file/scene_snapshot.hpp"
#include "scenes/registry.hpp"

#include <cmath>

namespace carom::lab
{

/// The named scene `collisions` as it is made.
SceneFile bouncing(const FieldSetup& setup)
{
    const std::int64_t size = setup.size;
    return snapshot_of(*scenes::make_scene("collisions", {{"circles", size}, {"boxes", size}}, setup.seed));
}

/// A disc of small bodies on circles, as fast as the sun's pull alone asks. They are so light that they hardly change each other's ways, but the pull
/// between all of them is summed.
SceneFile orbits(const FieldSetup& setup)
{
    constexpr float constant = 1e-3f;   // of gravity [m^3/(kg s^2)]
    constexpr float sun_radius = 3;     // [m]
    constexpr float sun_density = 1e5f; // [kg/m^2]
    const float pull = constant * pi * sun_radius * sun_radius * sun_density;
    const float inner = 12;
    const float outer = inner + 1.5f * std::sqrt(static_cast<float>(setup.size));

    SceneFile file;
    file.world.gravity = {};
    file.world.fields.push_back(NBodyField{.gravitational_constant = constant, .softening = 0.1f});
    add(file, body_of({.type = BodyType::Static, .is_attractor = true}, circle(sun_radius), {.density = sun_density}));
    scenes::Random random(setup.seed, 1);
    for (int i = 0; i < setup.size; ++i)
    {
        // As many on each square metre; the golden angle keeps neighbours apart.
        const float share = (static_cast<float>(i) + 0.5f) / static_cast<float>(setup.size);
        const float radius = std::sqrt(inner * inner + share * (outer * outer - inner * inner));
        const double turns = 0.6180339887498949 * i;
        const SinCos v = sin_cos(2 * pi * static_cast<float>(turns - std::floor(turns)));
        const Vec2 out{v.cos, v.sin};
        const float speed_there = std::sqrt(pull / radius);
        const float size = random.uniform(0.1f, 0.3f);
        add(file, body_of({.position = radius * out, .linear_velocity = speed_there * left_perp(out)}, circle(size)));
    }
    file.view = FileView{{}, 2.1f * outer};
    return file;
}

} // namespace carom::lab
