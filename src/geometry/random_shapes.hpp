// Random shapes and places for property tests. Test code only; the same sequence on every machine.
#pragma once

#include <carom/shape.hpp>

#include <array>
#include <random>
#include <vector>

namespace carom::detail
{

/// std::uniform_real_distribution differs between standard libraries; this does not.
class RandomShapes
{
public:
    explicit RandomShapes(std::uint32_t seed) : random_(seed) {}

    float uniform(float low, float high) { return low + (high - low) * static_cast<float>(random_() >> 8) * (1 / 16777216.0f); }
    int integer(int low, int high) { return low + static_cast<int>(random_() % static_cast<std::uint32_t>(high - low + 1)); }
    Vec2 point(float reach) { return {uniform(-reach, reach), uniform(-reach, reach)}; }
    Transform transform(float reach) { return {point(reach), rotation(uniform(-pi, pi))}; }

    // Compilers evaluate the arguments of a call in different orders, those in braces from left to right: at most one draw in a call.
    Circle circle_of(float size)
    {
        const Circle c = {point(size), uniform(0.1f, 1) * size};
        return circle(c.radius, c.center);
    }

    Capsule capsule_of(float size)
    {
        const Vec2 p1 = point(size);
        const Rot direction = rotation(uniform(-pi, pi));
        const float length = uniform(0.1f, 2) * size;
        return capsule(p1, p1 + rotate(direction, {length, 0}), uniform(0.05f, 0.5f) * size);
    }

    Segment segment_of(float size)
    {
        const Capsule c = capsule_of(size);
        return segment(c.p1, c.p2);
    }

    /// Corners on an ellipse, so that all of them stay; one polygon in three is rounded.
    Polygon polygon_of(float size)
    {
        const int count = integer(3, 8);
        std::array<Vec2, max_polygon_vertices> corners;
        const Vec2 axes = {uniform(0.3f, 1) * size, uniform(0.3f, 1) * size};
        const float start = uniform(-pi, pi);
        for (int i = 0; i < count; ++i)
        {
            const SinCos v = sin_cos(start + (static_cast<float>(i) + uniform(-0.3f, 0.3f)) * 2 * pi / static_cast<float>(count));
            corners[static_cast<std::size_t>(i)] = {axes.x * v.cos, axes.y * v.sin};
        }
        const float radius = integer(0, 2) == 0 ? uniform(0.05f, 0.5f) * size : 0;
        return convex_hull({corners.data(), static_cast<std::size_t>(count)}, radius);
    }

    /// @param type index in Geometry
    Geometry geometry_of(int type, float size)
    {
        switch (type)
        {
        case 0: return circle_of(size);
        case 1: return capsule_of(size);
        case 2: return segment_of(size);
        default: return polygon_of(size);
        }
    }

private:
    std::mt19937 random_;
};

} // namespace carom::detail
