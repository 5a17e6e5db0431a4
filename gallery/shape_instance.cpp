// Geometry to pixels. Everything is taken relative to the camera first, so that pictures far from the world's origin do not jitter.
#include "gallery/shape_instance.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace carom::gallery
{

namespace
{

using scenes::Color;

/// Corners farther out than this are cut off [pixels]: float would place the edges near the picture's middle by whole pixels.
constexpr float farthest_corner = 16384;

/// What a polygon cut at four sides can have at most.
constexpr std::size_t most_cut_corners = 12;

struct CutPolygon
{
    std::array<Vec2, most_cut_corners> corners;
    std::size_t count = 0;
};

/// The part of a convex polygon where n . p <= limit. Two corners are a line there and back, which keeps its ends.
/// @source I. Sutherland and G. Hodgman, "Reentrant Polygon Clipping", 1974
CutPolygon cut(const CutPolygon& polygon, Vec2 n, float limit)
{
    CutPolygon result;
    for (std::size_t i = 0; i < polygon.count; ++i)
    {
        const Vec2 a = polygon.corners[i];
        const Vec2 b = polygon.corners[(i + 1) % polygon.count];
        const float over_a = dot(n, a) - limit;
        const float over_b = dot(n, b) - limit;
        if (over_a <= 0 && result.count < most_cut_corners) result.corners[result.count++] = a;
        if ((over_a < 0) != (over_b < 0) && over_a != 0 && over_b != 0 && result.count < most_cut_corners)
            result.corners[result.count++] = lerp(a, b, over_a / (over_a - over_b));
    }
    return result;
}

/// In double: the parts are large and nearly equal.
float power_of(Vec2 center, float radius)
{
    const auto x = static_cast<double>(center.x);
    const auto y = static_cast<double>(center.y);
    const auto r = static_cast<double>(radius);
    return static_cast<float>(x * x + y * y - r * r);
}

} // namespace

InstanceMaker::InstanceMaker(const scenes::Camera& camera, scenes::Viewport viewport, const Theme& theme)
    : center_(camera.center),
      scale_(pixels_per_metre(camera, viewport)),
      half_picture_{0.5f * static_cast<float>(viewport.width), 0.5f * static_cast<float>(viewport.height)},
      half_per_unit_(0.5f * static_cast<float>(viewport.height) / reference_height),
      theme_(theme)
{
}

void InstanceMaker::add(const scenes::DrawnLayer& layer, std::vector<ShapeInstance>& instances)
{
    // Each is made where it stays, and taken away again when the picture shows nothing of it.
    for (const scenes::DrawnShape& shape : layer.shapes)
    {
        if (!place(shape, instances.emplace_back())) instances.pop_back();
    }
    for (const scenes::DrawnLine& line : layer.lines)
    {
        if (!place(line, instances.emplace_back())) instances.pop_back();
    }
}

bool InstanceMaker::place(const scenes::DrawnShape& shape, ShapeInstance& instance)
{
    set_corners(shape.geometry, shape.transform, instance);
    instance.half_line = shape.paint.line.a > 0 ? half_per_unit_ * shape.paint.line_width : 0;
    if (!is_visible(instance) || !clip(instance)) return false;
    if (instance.count == 1) instance.power = power_of(instance.corners[0], instance.radius);
    instance.fill = packed(shape.paint.fill);
    instance.line = packed(shape.paint.line);
    return true;
}

bool InstanceMaker::place(const scenes::DrawnLine& line, ShapeInstance& instance)
{
    instance.corners[0] = to_picture(line.from);
    instance.corners[1] = to_picture(line.to);
    instance.count = 2;
    instance.half_line = half_per_unit_ * line.width;
    if (!is_visible(instance) || !clip(instance)) return false;
    instance.power = line.color.a < 1 ? 1 : 0; // round ends would show twice where translucent lines follow each other
    instance.line = packed(line.color);
    return true;
}

Vec2 InstanceMaker::to_picture(Vec2 world) const { return scale_ * (world - center_); }

void InstanceMaker::set_corners(const Geometry& geometry, const Transform& transform, ShapeInstance& instance) const
{
    const Transform seen{.p = transform.p - center_, .q = transform.q};
    const auto set = [&](std::span<const Vec2> points, float radius)
    {
        for (std::size_t i = 0; i < points.size(); ++i) instance.corners[i] = scale_ * (seen * points[i]);
        instance.count = static_cast<float>(points.size());
        instance.radius = scale_ * radius;
    };
    if (const auto* const c = std::get_if<Circle>(&geometry))
        set({&c->center, 1}, c->radius);
    else if (const auto* const capsule = std::get_if<Capsule>(&geometry))
        set(std::array{capsule->p1, capsule->p2}, capsule->radius);
    else if (const auto* const s = std::get_if<Segment>(&geometry))
        set(std::array{s->p1, s->p2}, 0);
    else if (const auto* const p = std::get_if<Polygon>(&geometry))
        set({p->vertices.data(), static_cast<std::size_t>(std::clamp(p->count, 1, max_polygon_vertices))}, p->radius);
}

/// False also for what is not finite.
bool InstanceMaker::is_visible(const ShapeInstance& instance) const
{
    const auto count = static_cast<std::size_t>(instance.count);
    Vec2 low = instance.corners[0];
    Vec2 high = low;
    for (std::size_t i = 1; i < count; ++i)
    {
        low = min(low, instance.corners[i]);
        high = max(high, instance.corners[i]);
    }
    const float margin = instance.radius + instance.half_line + 1; // a pixel for the soft edge
    const Vec2 reach = half_picture_ + Vec2{margin, margin};
    if (!is_finite(low) || !is_finite(high) || !std::isfinite(margin)) return false;
    return low.x <= reach.x && high.x >= -reach.x && low.y <= reach.y && high.y >= -reach.y;
}

/// Cuts off what lies so far outside of the picture that it spoils the precision of what lies inside.
/// @return whether something is left
bool InstanceMaker::clip(ShapeInstance& instance) const
{
    const auto count = static_cast<std::size_t>(instance.count);
    const float limit = farthest_corner + instance.radius + instance.half_line;
    const auto is_far = [&](Vec2 p) { return std::max(std::abs(p.x), std::abs(p.y)) > limit; };
    if (count < 2 || std::none_of(instance.corners.begin(), instance.corners.begin() + static_cast<std::ptrdiff_t>(count), is_far))
        return true;

    CutPolygon polygon;
    polygon.count = count;
    std::copy_n(instance.corners.begin(), count, polygon.corners.begin());
    for (const Vec2 n : {Vec2{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) polygon = cut(polygon, n, limit);
    if (count == 2 && polygon.count > 2) polygon.count = 2;   // what comes back is the same
    if (polygon.count > instance.corners.size()) return true; // too many corners; it stays as it is, a little less precise
    std::copy_n(polygon.corners.begin(), polygon.count, instance.corners.begin());
    instance.count = static_cast<float>(polygon.count);
    return polygon.count > 0;
}

std::uint32_t InstanceMaker::packed(Color color)
{
    if (!(color.a > 0)) return 0;
    if (color == last_color_) return last_packed_;
    const Color c = theme_(color);
    const auto level = [](float v) { return static_cast<std::uint32_t>(std::clamp(v, 0.0f, 1.0f) * 255 + 0.5f); };
    last_color_ = color;
    last_packed_ = level(c.r) | level(c.g) << 8 | level(c.b) << 16 | level(c.a) << 24;
    return last_packed_;
}

} // namespace carom::gallery
