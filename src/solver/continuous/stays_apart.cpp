// Tries four normals at a time, one in each lane. A condition that is not a number is false, so then nothing counts as apart.
#include "solver/continuous/stays_apart.hpp"

#include "math/float4.hpp"

#include <algorithm>
#include <cmath>

namespace carom::detail
{

namespace
{

static_assert(max_polygon_vertices % 4 == 0, "corners are read four at a time");

/// The corners of a shape at one end of its way.
struct Corners
{
    float x[max_polygon_vertices];
    float y[max_polygon_vertices];
    int count;
};

/// @param center of mass, as seen from an origin near both shapes [m]
Corners corners_of(const ConvexPoints& shape, Vec2 local_center, Vec2 center, Rot q)
{
    Corners corners;
    corners.count = shape.count;
    for (int i = 0; i < shape.count; ++i)
    {
        const Vec2 arm = rotate(q, shape.points[static_cast<std::size_t>(i)] - local_center);
        corners.x[i] = center.x + arm.x;
        corners.y[i] = center.y + arm.y;
    }
    return corners;
}

/// Distance of the farthest corner from the centre of mass [m].
float longest_arm(const ConvexPoints& shape, Vec2 local_center)
{
    float longest = 0;
    for (int i = 0; i < shape.count; ++i)
        longest = std::max(longest, length_squared(shape.points[static_cast<std::size_t>(i)] - local_center));
    return std::sqrt(longest);
}

/// Two shapes at one time.
struct Placed
{
    Corners a;
    Corners b;
};

/// Four vectors, or the coordinates of four points.
struct Four
{
    Float4 x;
    Float4 y;
};

Float4 length4(Four v) { return sqrt4(v.x * v.x + v.y * v.y); }

Float4 least_along(Four n, const Corners& shape)
{
    Float4 least = n.x * shape.x[0] + n.y * shape.y[0];
    for (int i = 1; i < shape.count; ++i) least = min4(least, n.x * shape.x[i] + n.y * shape.y[i]);
    return least;
}

Float4 most_along(Four n, const Corners& shape)
{
    Float4 most = n.x * shape.x[0] + n.y * shape.y[0];
    for (int i = 1; i < shape.count; ++i) most = max4(most, n.x * shape.x[i] + n.y * shape.y[i]);
    return most;
}

/// Calls is_apart(n) for the normals of four faces of a shape at a time. They point outward, since its corners go counter-clockwise; but where a core
/// has become so thin that its faces have crossed, they may point anywhere. An edge without a length has the normal 0.
template <class IsApart>
bool any_face(const Corners& shape, IsApart is_apart)
{
    for (int first = 0; shape.count > 1 && first < shape.count; first += 4)
    {
        Four n = {splat4(0), splat4(0)};
        for (int i = first; i < std::min(first + 4, shape.count); ++i)
        {
            const int after = i + 1 < shape.count ? i + 1 : 0;
            n.x[i - first] = shape.y[after] - shape.y[i];
            n.y[i - first] = shape.x[i] - shape.x[after];
        }
        if (is_apart(n)) return true;
    }
    return false;
}

/// Asks along the faces of both, across the relative way, and from middle to middle.
/// @param way    by which B moves, as seen from A [m]
/// @param needed for the distance of corners, with all that they swing by [m]
bool stays_apart_from_start(const Placed& start, Vec2 way, float needed)
{
    const auto keeps_apart = [&](Four n)
    {
        const Float4 closing = min4(n.x * way.x + n.y * way.y, splat4(0));
        return lane_bits(least_along(n, start.b) - most_along(n, start.a) + closing > needed * length4(n)) != 0;
    };
    const auto beyond_b = [&](Four n) { return keeps_apart(Four{-n.x, -n.y}); };
    if (any_face(start.b, beyond_b) || any_face(start.a, keeps_apart)) return true;

    const Vec2 middles = {start.b.x[0] - start.a.x[0], start.b.y[0] - start.a.y[0]};
    const Vec2 left = left_perp(way);
    const Vec2 across = dot(left, middles) < 0 ? -left : left;
    const Four n = {{across.x, middles.x, 0, 0}, {across.y, middles.y, 0, 0}};
    return keeps_apart(n);
}

/// Asks along the faces that both have at the start.
/// @param needed for the distance of corners, with all that their arcs bend by [m]
bool is_apart_at_both_ends(const Placed& start, const Placed& end, float needed)
{
    const auto keeps_apart = [&](Four n)
    {
        const Float4 gap_at_start = least_along(n, start.b) - most_along(n, start.a);
        const Float4 gap_at_end = least_along(n, end.b) - most_along(n, end.a);
        return lane_bits(min4(gap_at_start, gap_at_end) > needed * length4(n)) != 0;
    };
    const auto beyond_b = [&](Four n) { return keeps_apart(Four{-n.x, -n.y}); };
    return any_face(start.b, beyond_b) || any_face(start.a, keeps_apart);
}

} // namespace

bool stays_apart(const ConvexPoints& a, const Sweep& way_a, const ConvexPoints& b, const Sweep& way_b, float least)
{
    const Vec2 origin = way_a.center_start;
    const Placed start = {corners_of(a, way_a.local_center, {}, way_a.q_start),
                          corners_of(b, way_b.local_center, way_b.center_start - origin, way_b.q_start)};
    const Vec2 way = (way_b.center_end - way_b.center_start) - (way_a.center_end - way_a.center_start);
    const float arm_a = longest_arm(a, way_a.local_center);
    const float arm_b = longest_arm(b, way_b.local_center);
    const float needed = a.radius + b.radius + least;
    const float swing = std::min(std::abs(way_a.turn), 2.0f) * arm_a + std::min(std::abs(way_b.turn), 2.0f) * arm_b;
    if (stays_apart_from_start(start, way, needed + swing)) return true;
    if (swing == 0) return false;

    const auto end_of = [&](const ConvexPoints& shape, const Sweep& sweep)
    {
        const Rot q = sweep.turn == 0 ? sweep.q_start : rotation(sweep.turn) * sweep.q_start;
        return corners_of(shape, sweep.local_center, sweep.center_end - origin, q);
    };
    const Placed end = {end_of(a, way_a), end_of(b, way_b)};
    const float bend = 0.125f * (way_a.turn * way_a.turn * arm_a + way_b.turn * way_b.turn * arm_b);
    return is_apart_at_both_ends(start, end, needed + bend);
}

} // namespace carom::detail
