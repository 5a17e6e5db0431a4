// A shape's way in a step as a straight line with a disc around it: rough, cheap, and never too small.
#pragma once

#include "geometry/extent.hpp"
#include "geometry/manifold.hpp"
#include "geometry/time_of_impact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace carom::detail
{

/// A shape that goes into another no deeper than this share of its inner radius has not begun to pass through: it slides along it, over tiles and
/// seams. Tests: continuous_test, terrain_test.
inline constexpr float sliding_share = 0.25f;

/// The middle of a shape on its way, as a straight line, and all that the shape reaches around it.
struct SweptPath
{
    Vec2 from;
    Vec2 way;
    float reach; ///< [m]
    float swing; ///< of its farthest point by turning [m]
};

inline SweptPath path_of(const Extent& shape, const Sweep& sweep)
{
    const Vec2 arm = shape.middle - sweep.local_center;
    const float bow = length(arm) * std::min(std::abs(sweep.turn), 2.0f); // by which turning takes the middle off the line
    return {sweep.center_start + rotate(sweep.q_start, arm), sweep.center_end - sweep.center_start, shape.outer + bow,
            std::abs(sweep.turn) * (shape.outer + length(arm))};
}

/// What costs little and tells most pairs apart: discs around both shapes come within reach of each other, and the two move by more, as seen from
/// each other, than what the contact can take back.
/// @param least_way relative way that counts [m]
/// @param slop      Tolerances::linear_slop [m]
/// @param depth     by which the core of A that would go into B lies below A's surface [m]
inline bool may_pass_through(const SweptPath& a, const SweptPath& b, float least_way, float depth, float slop)
{
    const Vec2 offset = b.from - a.from;
    const Vec2 way = b.way - a.way;
    const float way2 = length_squared(way);
    if (std::sqrt(way2) + a.swing + b.swing <= least_way) return false;
    const float nearest = way2 > 0 ? std::clamp(-dot(offset, way) / way2, 0.0f, 1.0f) : 0.0f;
    const float reach = std::max(0.0f, a.reach - depth) + b.reach + slop;
    return !(length_squared(offset + nearest * way) > reach * reach); // also when a number is not finite
}

/// The corners of a shape at the start of its way, and how far turning takes the farthest of them [m].
struct StartCorners
{
    std::array<Vec2, max_polygon_vertices> corners;
    std::size_t count;
    float swing;
};

/// @param origin the corners are seen from here [m]
inline StartCorners start_corners(const ConvexPoints& shape, const Sweep& sweep, Vec2 origin)
{
    StartCorners start = {.corners = {}, .count = static_cast<std::size_t>(shape.count), .swing = 0};
    const Vec2 center = sweep.center_start - origin;
    float farthest = 0;
    for (std::size_t i = 0; i < start.count; ++i)
    {
        const Vec2 arm = rotate(sweep.q_start, shape.points[i] - sweep.local_center);
        farthest = std::max(farthest, length_squared(arm));
        start.corners[i] = center + arm;
    }
    start.swing = std::min(std::abs(sweep.turn), 2.0f) * std::sqrt(farthest);
    return start;
}

/// Whether some line between the two keeps them apart on their whole ways: along its normal n, from A to B,
///   s(t) >= s(0) + min(0, n . way of B past A) - what both swing by turning
/// Asked along the faces of both, across their relative way, and from middle to middle. Where they stay apart, time_of_impact finds nothing.
/// @param least distance of the surfaces that counts as apart [m]
inline bool stays_apart(const ConvexPoints& a, const Sweep& way_a, const ConvexPoints& b, const Sweep& way_b, float least)
{
    const StartCorners on_a = start_corners(a, way_a, way_a.center_start);
    const StartCorners on_b = start_corners(b, way_b, way_a.center_start);
    const Vec2 way = (way_b.center_end - way_b.center_start) - (way_a.center_end - way_a.center_start);
    const float needed = a.radius + b.radius + on_a.swing + on_b.swing + least;
    const auto separates = [&](Vec2 n)
    {
        float nearest_of_b = dot(n, on_b.corners[0]);
        for (std::size_t i = 1; i < on_b.count; ++i) nearest_of_b = std::min(nearest_of_b, dot(n, on_b.corners[i]));
        float farthest_of_a = dot(n, on_a.corners[0]);
        for (std::size_t i = 1; i < on_a.count; ++i) farthest_of_a = std::max(farthest_of_a, dot(n, on_a.corners[i]));
        return nearest_of_b - farthest_of_a + std::min(0.0f, dot(n, way)) > needed * length(n); // false when a number is not finite
    };
    const auto faces_separate = [&](const StartCorners& shape, float sign)
    {
        for (std::size_t i = 0; shape.count > 1 && i < shape.count; ++i)
        {
            const Vec2 edge = shape.corners[i + 1 < shape.count ? i + 1 : 0] - shape.corners[i];
            if (separates(sign * right_perp(edge))) return true; // outward, for corners go counter-clockwise
        }
        return false;
    };
    const Vec2 middles = on_b.corners[0] - on_a.corners[0];
    const Vec2 across = left_perp(way);
    return separates(dot(across, middles) < 0 ? -across : across) || faces_separate(on_b, -1) || faces_separate(on_a, 1) ||
           separates(middles);
}

} // namespace carom::detail
