// A shape's way in a step as a straight line with a disc around it: rough, cheap, and never too small.
#pragma once

#include "geometry/extent.hpp"
#include "geometry/time_of_impact.hpp"

#include <algorithm>
#include <cmath>

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

/// Whether two shapes move by no more, as seen from each other, than what the contact can take back.
/// @param least_way relative way that counts [m]
inline bool moves_less(const SweptPath& a, const SweptPath& b, float least_way)
{
    const float left = least_way - a.swing - b.swing;
    return left >= 0 && length_squared(b.way - a.way) <= left * left;
}

/// Whether discs around both shapes come within reach of each other.
/// @param depth by which the core of A that would go into B lies below A's surface [m]
/// @param slop  Tolerances::linear_slop [m]
inline bool come_near(const SweptPath& a, const SweptPath& b, float depth, float slop)
{
    const Vec2 offset = b.from - a.from;
    const Vec2 way = b.way - a.way;
    const float way2 = length_squared(way);
    const float nearest = way2 > 0 ? std::clamp(-dot(offset, way) / way2, 0.0f, 1.0f) : 0.0f;
    const float reach = std::max(0.0f, a.reach - depth) + b.reach + slop;
    return !(length_squared(offset + nearest * way) > reach * reach); // also when a number is not finite
}

/// What costs little and tells most pairs apart.
inline bool may_pass_through(const SweptPath& a, const SweptPath& b, float least_way, float depth, float slop)
{
    return !moves_less(a, b, least_way) && come_near(a, b, depth, slop);
}

} // namespace carom::detail
