// Four boxes side by side, compared with another box in four lanes at once.
#pragma once

#include "math/float4.hpp"

#include <carom/math.hpp>

#include <limits>

namespace carom::detail
{

/// The boxes of a node's four children: one cache line. An absent child has the empty box, which overlaps nothing.
struct alignas(64) Box4
{
    float min_x[4];
    float min_y[4];
    float max_x[4];
    float max_y[4];
};

inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr Aabb empty_box = {{infinity, infinity}, {-infinity, -infinity}};
inline constexpr Box4 empty_box4 = {{infinity, infinity, infinity, infinity},
                                    {infinity, infinity, infinity, infinity},
                                    {-infinity, -infinity, -infinity, -infinity},
                                    {-infinity, -infinity, -infinity, -infinity}};

inline Aabb get_box(const Box4& boxes, unsigned lane)
{
    return {{boxes.min_x[lane], boxes.min_y[lane]}, {boxes.max_x[lane], boxes.max_y[lane]}};
}

inline void set_box(Box4& boxes, unsigned lane, const Aabb& box)
{
    boxes.min_x[lane] = box.min.x;
    boxes.min_y[lane] = box.min.y;
    boxes.max_x[lane] = box.max.x;
    boxes.max_y[lane] = box.max.y;
}

/// The box around all four; empty when all are absent.
inline Aabb merge4(const Box4& b)
{
    const auto least = [](const float (&v)[4]) { return std::min(std::min(v[0], v[1]), std::min(v[2], v[3])); };
    const auto most = [](const float (&v)[4]) { return std::max(std::max(v[0], v[1]), std::max(v[2], v[3])); };
    return {{least(b.min_x), least(b.min_y)}, {most(b.max_x), most(b.max_y)}};
}

/// Bit j is set where the box and box j of the four share at least a point.
inline unsigned overlap_bits(const Aabb& box, const Box4& boxes)
{
    const Int4 in_x = (load4(boxes.min_x) <= box.max.x) & (load4(boxes.max_x) >= box.min.x);
    const Int4 in_y = (load4(boxes.min_y) <= box.max.y) & (load4(boxes.max_y) >= box.min.y);
    return lane_bits(in_x & in_y);
}

} // namespace carom::detail
