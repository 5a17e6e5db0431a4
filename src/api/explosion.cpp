// Pushes bodies away from a point.
#include "api/query_walk.hpp"
#include "api/validate.hpp"
#include "edit/wake.hpp"
#include "geometry/distance.hpp"
#include "state/guards.hpp"

#include <algorithm>

namespace carom
{

using detail::WorldState;

namespace
{

/// The width that a shape turns towards something in a direction [m].
/// @param across unit, in the shape's frame
float width_across(const detail::ConvexPoints& shape, Vec2 across)
{
    float low = dot(shape.points[0], across);
    float high = low;
    for (std::size_t i = 1; i < static_cast<std::size_t>(shape.count); ++i)
    {
        low = std::min(low, dot(shape.points[i], across));
        high = std::max(high, dot(shape.points[i], across));
    }
    return high - low + 2 * shape.radius;
}

/// @return false when the shape is out of reach, or the blast has no direction there
bool push_shape(WorldState& world, std::uint32_t shape, const ExplosionDef& def)
{
    const std::uint32_t body = world.shapes.records[shape].body;
    const Transform& transform = world.bodies.poses[body].transform;
    const detail::ConvexPoints points = detail::convex_points(world.shapes.geometry[shape]);
    detail::ConvexPoints center;
    center.points[0] = inverse_transform(transform, def.center);
    center.count = 1;
    const detail::DistanceResult nearest = detail::distance(points, center, {});
    if (nearest.distance > def.radius + def.falloff) return false;

    // From inside, there is no nearest point of the surface: the body is pushed as a whole.
    const bool is_inside = nearest.distance <= 0;
    const Vec2 at = is_inside ? def.center : transform * nearest.point_a;
    const Vec2 direction = normalize(is_inside ? world.bodies.poses[body].center - def.center : rotate(transform.q, -nearest.normal));
    if (direction == Vec2{}) return false;

    const float beyond = nearest.distance - def.radius;
    const float strength = beyond <= 0 ? 1 : 1 - beyond / def.falloff;
    const float width = width_across(points, inverse_rotate(transform.q, left_perp(direction)));
    const Vec2 impulse = (def.impulse_per_metre * width * strength) * direction;
    detail::wake_body(world, body);
    world.bodies.push(body, impulse, cross(at - world.bodies.poses[body].center, impulse));
    return true;
}

} // namespace

int World::explode(const ExplosionDef& def)
{
    WorldState& world = state("explode");
    detail::require_idle(world, "explode");
    detail::require_within("explode", "center", def.center, max_coordinate);
    detail::require_range("explode", "radius", def.radius, 0, max_coordinate);
    detail::require_range("explode", "falloff", def.falloff, 0, max_coordinate);
    detail::require_range("explode", "impulse_per_metre", def.impulse_per_metre, -1e20f, 1e20f);
    QueryFilter filter = def.filter;
    filter.sensors = false;
    int count = 0;
    detail::for_each_near(world, expanded({def.center, def.center}, def.radius + def.falloff), filter, [&](std::uint32_t shape)
    {
        const detail::BodyRecord& body = world.bodies.records[world.shapes.records[shape].body];
        if (body.type == BodyType::Dynamic && body.is_enabled) count += push_shape(world, shape, def);
        return true;
    });
    return count;
}

} // namespace carom
