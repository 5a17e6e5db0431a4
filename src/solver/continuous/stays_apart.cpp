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

/// The corners of a shape at the start of its way, and how far turning takes the farthest of them [m].
struct StartCorners
{
    float x[max_polygon_vertices];
    float y[max_polygon_vertices];
    int count;
    float swing;
};

/// @param origin the corners are seen from here [m]
StartCorners start_corners(const ConvexPoints& shape, const Sweep& sweep, Vec2 origin)
{
    StartCorners start;
    start.count = shape.count;
    const Vec2 center = sweep.center_start - origin;
    float farthest = 0;
    for (int i = 0; i < shape.count; ++i)
    {
        const Vec2 arm = rotate(sweep.q_start, shape.points[static_cast<std::size_t>(i)] - sweep.local_center);
        farthest = std::max(farthest, length_squared(arm));
        start.x[i] = center.x + arm.x;
        start.y[i] = center.y + arm.y;
    }
    start.swing = std::min(std::abs(sweep.turn), 2.0f) * std::sqrt(farthest);
    return start;
}

/// Four vectors, or the coordinates of four points.
struct Four
{
    Float4 x;
    Float4 y;
};

Float4 length4(Four v) { return sqrt4(v.x * v.x + v.y * v.y); }

Float4 least_along(Four n, const StartCorners& shape)
{
    Float4 least = n.x * shape.x[0] + n.y * shape.y[0];
    for (int i = 1; i < shape.count; ++i) least = min4(least, n.x * shape.x[i] + n.y * shape.y[i]);
    return least;
}

Float4 most_along(Four n, const StartCorners& shape)
{
    Float4 most = n.x * shape.x[0] + n.y * shape.y[0];
    for (int i = 1; i < shape.count; ++i) most = max4(most, n.x * shape.x[i] + n.y * shape.y[i]);
    return most;
}

/// @param gap  along each normal, times its length
/// @param way  by which the other shape moves, as seen from the one that the normals point away from [m]
bool any_apart(Four n, Float4 gap, Vec2 way, float needed)
{
    const Float4 closing = min4(n.x * way.x + n.y * way.y, splat4(0));
    return lane_bits(gap + closing > needed * length4(n)) != 0;
}

/// The normals of a shape's faces point outward, since its corners go counter-clockwise; none of its corners lies beyond its own face.
bool faces_separate(const StartCorners& shape, const StartCorners& other, Vec2 way_of_other, float needed)
{
    for (int first = 0; shape.count > 1 && first < shape.count; first += 4)
    {
        Four corner = {splat4(0), splat4(0)};
        Four next = corner; // an edge without a length separates nothing
        for (int i = first; i < std::min(first + 4, shape.count); ++i)
        {
            const int after = i + 1 < shape.count ? i + 1 : 0;
            corner.x[i - first] = shape.x[i];
            corner.y[i - first] = shape.y[i];
            next.x[i - first] = shape.x[after];
            next.y[i - first] = shape.y[after];
        }
        const Four n = {next.y - corner.y, corner.x - next.x};
        const Float4 face = n.x * corner.x + n.y * corner.y;
        if (any_apart(n, least_along(n, other) - face, way_of_other, needed)) return true;
    }
    return false;
}

} // namespace

bool stays_apart(const ConvexPoints& a, const Sweep& way_a, const ConvexPoints& b, const Sweep& way_b, float least)
{
    const StartCorners on_a = start_corners(a, way_a, way_a.center_start);
    const StartCorners on_b = start_corners(b, way_b, way_a.center_start);
    const Vec2 way = (way_b.center_end - way_b.center_start) - (way_a.center_end - way_a.center_start);
    const float needed = a.radius + b.radius + on_a.swing + on_b.swing + least;
    if (faces_separate(on_b, on_a, -way, needed) || faces_separate(on_a, on_b, way, needed)) return true;

    const Vec2 middles = {on_b.x[0] - on_a.x[0], on_b.y[0] - on_a.y[0]};
    const Vec2 left = left_perp(way);
    const Vec2 across = dot(left, middles) < 0 ? -left : left;
    const Four n = {{across.x, middles.x, 0, 0}, {across.y, middles.y, 0, 0}};
    return any_apart(n, least_along(n, on_b) - most_along(n, on_a), way, needed);
}

} // namespace carom::detail
