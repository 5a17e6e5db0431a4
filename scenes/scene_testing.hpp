// What the tests of several scenes need: stepping, clicking, and the measures that their bounds are about.
#pragma once

#include "scenes/scene.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace carom::scenes
{

inline void step(Scene& scene, int count)
{
    for (int i = 0; i < count; ++i) scene.step();
}

inline void click(Scene& scene, Vec2 place, PointerEvent::Button button = PointerEvent::Button::Left)
{
    scene.pointer({.action = PointerEvent::Action::Down, .button = button, .position = place});
}

/// The lines of text over the picture.
inline std::string captions_of(const Scene& scene)
{
    DrawList list;
    scene.draw(list);
    std::string all;
    for (const DrawnText& text : list.layer(Layer::Captions).texts) all += text.text + "\n";
    return all;
}

/// In the order of the world's bodies.
inline std::vector<BodyId> dynamic_bodies(const Scene& scene)
{
    std::vector<BodyId> bodies = scene.world().bodies();
    std::erase_if(bodies, [&](BodyId id) { return scene.world().body(id).type() != BodyType::Dynamic; });
    return bodies;
}

/// The first body of that name.
inline BodyId body_named(const Scene& scene, std::string_view name)
{
    for (const BodyId id : scene.world().bodies())
        if (scene.world().body(id).name() == name) return id;
    return {};
}

/// The largest error of any joint at the end of any of so many steps [m]. It throws where there are no joints.
inline float largest_joint_error(Scene& scene, int steps)
{
    if (scene.world().joint_count() == 0) throw std::logic_error("largest_joint_error: the scene has no joints");
    float largest = 0;
    for (int i = 0; i < steps; ++i)
    {
        scene.step();
        for (const JointId joint : scene.world().joints()) largest = std::max(largest, scene.world().joint(joint).error());
    }
    return largest;
}

/// How far from where it is now each body gets at the end of any of so many steps [m]; a body that is taken away counts as one that has
/// gone as far as it can.
inline std::vector<float> farthest_ways(Scene& scene, std::span<const BodyId> bodies, int steps)
{
    std::vector<Vec2> before;
    for (const BodyId id : bodies) before.push_back(scene.world().body(id).position());
    std::vector<float> farthest(bodies.size(), 0.0f);
    for (int step = 0; step < steps; ++step)
    {
        scene.step();
        for (std::size_t i = 0; i < bodies.size(); ++i)
        {
            const auto body = scene.world().find_body(bodies[i]);
            farthest[i] = std::max(farthest[i], body ? distance(before[i], body->position()) : farthest_pointer);
        }
    }
    return farthest;
}

/// The largest of them. It throws where there are none.
inline float farthest_way(Scene& scene, std::span<const BodyId> bodies, int steps)
{
    if (bodies.empty()) throw std::logic_error("farthest_way: no bodies");
    const std::vector<float> ways = farthest_ways(scene, bodies, steps);
    return ways.empty() ? 0 : *std::max_element(ways.begin(), ways.end());
}

/// How often in so many steps a dynamic body's centre of mass was outside of a field. It throws where there are
/// none.
inline int times_outside(Scene& scene, const Aabb& field, int steps)
{
    if (dynamic_bodies(scene).empty()) throw std::logic_error("times_outside: the scene has no dynamic bodies");
    int count = 0;
    for (int i = 0; i < steps; ++i)
    {
        scene.step();
        for (const BodyId id : dynamic_bodies(scene)) count += !contains(field, scene.world().body(id).center_of_mass());
    }
    return count;
}

} // namespace carom::scenes
