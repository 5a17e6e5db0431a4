// The queries of a world. Each asks the broad phase for what is near, and then the geometry.
#include "api/query_walk.hpp"
#include "api/validate.hpp"
#include "geometry/bounds.hpp"
#include "geometry/cast.hpp"
#include "geometry/validate.hpp"
#include "state/guards.hpp"

#include <algorithm>
#include <tuple>

namespace carom
{

using detail::WorldState;

namespace
{

void validate_ray(std::string_view function, Vec2 start, Vec2 sweep)
{
    detail::require_within(function, "start", start, max_coordinate);
    detail::require_within(function, "sweep", sweep, 2 * max_coordinate);
}

CastHit public_hit(const WorldState& world, std::uint32_t shape, const detail::CastResult& hit)
{
    const Transform& transform = detail::transform_of(world, shape);
    return {.shape = detail::shape_id(world.shapes, shape, world.world),
            .body = detail::body_id(world, world.shapes.records[shape].body),
            .fraction = hit.fraction,
            .point = transform * hit.point,
            .normal = rotate(transform.q, hit.normal),
            .starts_inside = hit.starts_inside};
}

bool comes_first(const CastHit& a, const CastHit& b) { return std::tie(a.fraction, a.shape.index) < std::tie(b.fraction, b.shape.index); }

/// A ray as each shape sees it in its own frame.
struct RayCaster
{
    Vec2 start;
    Vec2 sweep;

    detail::BoxSweep bounds() const { return {{start, start}, sweep}; }
    std::optional<detail::CastResult> operator()(const WorldState& world, std::uint32_t shape) const
    {
        const Transform& transform = detail::transform_of(world, shape);
        return detail::cast_ray(world.shapes.geometry[shape], inverse_transform(transform, start), inverse_rotate(transform.q, sweep),
                                world.shapes.tolerances);
    }
};

struct ShapeCaster
{
    const Geometry& geometry;
    detail::ConvexPoints points;
    Transform start;
    Vec2 sweep;
    float touch_distance; ///< of the world [m]

    detail::BoxSweep bounds() const { return {expanded(detail::bounds_of(geometry, start), touch_distance), sweep}; }
    std::optional<detail::CastResult> operator()(const WorldState& world, std::uint32_t shape) const
    {
        const Transform& transform = detail::transform_of(world, shape);
        return detail::cast_shape(detail::convex_points(world.shapes.geometry[shape]), points, relative(transform, start),
                                  inverse_rotate(transform.q, sweep), world.shapes.tolerances);
    }
};

ShapeCaster shape_caster(const WorldState& world, std::string_view function, const Geometry& geometry, const Transform& start, Vec2 sweep)
{
    detail::validate(geometry, function, world.shapes.tolerances);
    detail::validate(start, function, "start");
    detail::require_within(function, "sweep", sweep, 2 * max_coordinate);
    return {geometry, detail::convex_points(geometry), start, sweep, world.shapes.tolerances.touch_distance};
}

/// Calls report(hit) for each shape that is met, in any order; it returns the fraction that still matters, as a SweepVisitor does.
template <class Caster, class Report>
class CastVisitor final : public detail::SweepVisitor
{
public:
    CastVisitor(const WorldState& world, const Caster& caster, const QueryFilter& filter, Report& report)
        : world_(world),
          caster_(caster),
          filter_(filter),
          report_(report)
    {
    }

    float visit(detail::ProxyIndex shape) override
    {
        if (!detail::is_seen(world_, shape, filter_)) return most_;
        if (const std::optional<detail::CastResult> hit = caster_(world_, shape)) most_ = report_(public_hit(world_, shape, *hit));
        return most_;
    }

private:
    const WorldState& world_;
    const Caster& caster_;
    const QueryFilter& filter_;
    Report& report_;
    float most_ = 1;
};

template <class Caster, class Report>
void cast(WorldState& world, const Caster& caster, const QueryFilter& filter, Report&& report)
{
    CastVisitor visitor(world, caster, filter, report);
    world.broad_phase->query(caster.bounds(), visitor);
}

template <class Caster>
std::optional<CastHit> first_hit(WorldState& world, const Caster& caster, const QueryFilter& filter)
{
    std::optional<CastHit> first;
    cast(world, caster, filter, [&first](const CastHit& hit)
    {
        if (!first || comes_first(hit, *first)) first = hit;
        return first->fraction;
    });
    return first;
}

template <class Caster>
std::vector<CastHit> all_hits(WorldState& world, const Caster& caster, const QueryFilter& filter)
{
    std::vector<CastHit> hits;
    cast(world, caster, filter, [&hits](const CastHit& hit)
    {
        hits.push_back(hit);
        return 1.0f;
    });
    std::sort(hits.begin(), hits.end(), comes_first);
    return hits;
}

// What the two forms of each overlap query share. visit(shape slot) returns false to end.

template <class Visit>
void visit_in_box(WorldState& world, std::string_view function, const Aabb& box, const QueryFilter& filter, Visit&& visit)
{
    detail::require_queryable(world, function);
    detail::require_within(function, "box.min", box.min, max_coordinate);
    detail::require_within(function, "box.max", box.max, max_coordinate);
    if (box.min.x > box.max.x || box.min.y > box.max.y)
        detail::usage_error(function, "box.max", box.max, "give a max that is not less than min");
    detail::for_each_near(world, box, filter,
                          [&](std::uint32_t shape) { return !overlaps(world.shapes.bounds[shape].tight, box) || visit(shape); });
}

template <class Visit>
void visit_in_shape(WorldState& world, std::string_view function, const Geometry& geometry, const Transform& transform,
                    const QueryFilter& filter, Visit&& visit)
{
    detail::require_queryable(world, function);
    const detail::Tolerances& tolerances = world.shapes.tolerances;
    detail::validate(geometry, function, tolerances);
    detail::validate(transform, function, "transform");
    const Aabb box = expanded(detail::bounds_of(geometry, transform), tolerances.touch_distance);
    detail::for_each_near(world, box, filter, [&](std::uint32_t shape)
    {
        const Transform in_shape = relative(detail::transform_of(world, shape), transform);
        return !detail::overlap(world.shapes.geometry[shape], geometry, in_shape, tolerances) || visit(shape);
    });
}

template <class Visit>
void visit_at(WorldState& world, std::string_view function, Vec2 point, const QueryFilter& filter, Visit&& visit)
{
    detail::require_queryable(world, function);
    detail::require_within(function, "point", point, max_coordinate);
    detail::for_each_near(world, {point, point}, filter, [&](std::uint32_t shape)
    {
        const Vec2 local = inverse_transform(detail::transform_of(world, shape), point);
        return !detail::holds(world.shapes.geometry[shape], local) || visit(shape);
    });
}

/// Passes slots on as ids.
auto to_ids(const WorldState& world, ShapeVisitor visit)
{
    return [&world, visit](std::uint32_t shape) { return visit(detail::shape_id(world.shapes, shape, world.world)); };
}

auto to_list(const WorldState& world, std::vector<ShapeId>& ids)
{
    return [&world, &ids](std::uint32_t shape)
    {
        ids.push_back(detail::shape_id(world.shapes, shape, world.world));
        return true;
    };
}

/// Of the shapes within a distance.
std::optional<NearestPoint> nearest_within(WorldState& world, Vec2 point, float distance, const QueryFilter& filter)
{
    detail::ConvexPoints asked;
    asked.points[0] = point;
    asked.count = 1;
    std::optional<NearestPoint> nearest;
    detail::for_each_near(world, expanded({point, point}, distance), filter, [&](std::uint32_t shape)
    {
        const Transform& transform = detail::transform_of(world, shape);
        const Vec2 local = inverse_transform(transform, point);
        asked.points[0] = local;
        const detail::DistanceResult result = detail::distance(detail::convex_points(world.shapes.geometry[shape]), asked, {});
        if (result.distance > distance || (nearest && result.distance >= nearest->distance)) return true;
        const bool is_inside = result.distance <= 0;
        nearest = {.shape = detail::shape_id(world.shapes, shape, world.world),
                   .body = detail::body_id(world, world.shapes.records[shape].body),
                   .point = is_inside ? point : transform * result.point_a,
                   .normal = is_inside ? Vec2{} : rotate(transform.q, result.normal),
                   .distance = result.distance};
        return !is_inside;
    });
    return nearest;
}

} // namespace

std::optional<RayHit> World::cast_ray(Vec2 start, Vec2 sweep, const QueryFilter& filter) const
{
    WorldState& world = state("cast_ray");
    detail::require_queryable(world, "cast_ray");
    validate_ray("cast_ray", start, sweep);
    return first_hit(world, RayCaster{start, sweep}, filter);
}

bool World::is_ray_blocked(Vec2 start, Vec2 sweep, const QueryFilter& filter) const
{
    WorldState& world = state("is_ray_blocked");
    detail::require_queryable(world, "is_ray_blocked");
    validate_ray("is_ray_blocked", start, sweep);
    bool is_blocked = false;
    cast(world, RayCaster{start, sweep}, filter, [&is_blocked](const CastHit&)
    {
        is_blocked = true;
        return -1.0f;
    });
    return is_blocked;
}

std::vector<RayHit> World::cast_ray_all(Vec2 start, Vec2 sweep, const QueryFilter& filter) const
{
    WorldState& world = state("cast_ray_all");
    detail::require_queryable(world, "cast_ray_all");
    validate_ray("cast_ray_all", start, sweep);
    return all_hits(world, RayCaster{start, sweep}, filter);
}

void World::cast_rays(std::span<const Ray> rays, std::span<std::optional<RayHit>> hits, const QueryFilter& filter) const
{
    WorldState& world = state("cast_rays");
    detail::require_queryable(world, "cast_rays");
    if (hits.size() != rays.size()) detail::usage_error("cast_rays", "hits.size()", hits.size(), "give as many hits as rays");
    for (const Ray& ray : rays) validate_ray("cast_rays", ray.start, ray.sweep);
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = first_hit(world, RayCaster{rays[i].start, rays[i].sweep}, filter);
}

std::optional<CastHit> World::cast_shape(const Geometry& geometry, const Transform& start, Vec2 sweep, const QueryFilter& filter) const
{
    WorldState& world = state("cast_shape");
    detail::require_queryable(world, "cast_shape");
    return first_hit(world, shape_caster(world, "cast_shape", geometry, start, sweep), filter);
}

std::optional<CastHit> World::cast_circle(Vec2 center, float radius, Vec2 sweep, const QueryFilter& filter) const
{
    WorldState& world = state("cast_circle");
    detail::require_queryable(world, "cast_circle");
    detail::require_within("cast_circle", "center", center, max_coordinate);
    detail::require_range("cast_circle", "radius", radius, world.shapes.tolerances.min_edge_length, max_coordinate);
    const Geometry geometry = Circle{{}, radius};
    return first_hit(world, shape_caster(world, "cast_circle", geometry, {center, {}}, sweep), filter);
}

std::vector<CastHit> World::cast_shape_all(const Geometry& geometry, const Transform& start, Vec2 sweep, const QueryFilter& filter) const
{
    WorldState& world = state("cast_shape_all");
    detail::require_queryable(world, "cast_shape_all");
    return all_hits(world, shape_caster(world, "cast_shape_all", geometry, start, sweep), filter);
}

std::vector<ShapeId> World::overlapping(const Aabb& box, const QueryFilter& filter) const
{
    WorldState& world = state("overlapping");
    std::vector<ShapeId> ids;
    visit_in_box(world, "overlapping", box, filter, to_list(world, ids));
    return ids;
}

std::vector<ShapeId> World::overlapping(const Geometry& geometry, const Transform& transform, const QueryFilter& filter) const
{
    WorldState& world = state("overlapping");
    std::vector<ShapeId> ids;
    visit_in_shape(world, "overlapping", geometry, transform, filter, to_list(world, ids));
    return ids;
}

std::vector<ShapeId> World::shapes_at(Vec2 point, const QueryFilter& filter) const
{
    WorldState& world = state("shapes_at");
    std::vector<ShapeId> ids;
    visit_at(world, "shapes_at", point, filter, to_list(world, ids));
    return ids;
}

void World::visit_overlapping(const Aabb& box, ShapeVisitor visit, const QueryFilter& filter) const
{
    WorldState& world = state("visit_overlapping");
    visit_in_box(world, "visit_overlapping", box, filter, to_ids(world, visit));
}

void World::visit_overlapping(const Geometry& geometry, const Transform& transform, ShapeVisitor visit, const QueryFilter& filter) const
{
    WorldState& world = state("visit_overlapping");
    visit_in_shape(world, "visit_overlapping", geometry, transform, filter, to_ids(world, visit));
}

void World::visit_shapes_at(Vec2 point, ShapeVisitor visit, const QueryFilter& filter) const
{
    WorldState& world = state("visit_shapes_at");
    visit_at(world, "visit_shapes_at", point, filter, to_ids(world, visit));
}

std::optional<NearestPoint> World::closest_point(Vec2 point, float max_distance, const QueryFilter& filter) const
{
    WorldState& world = state("closest_point");
    detail::require_queryable(world, "closest_point");
    detail::require_within("closest_point", "point", point, max_coordinate);
    detail::require_range("closest_point", "max_distance", max_distance, 0, 4 * max_coordinate);
    // As a rule something is near, however far the caller would look.
    const float first_look = 0.5f * world.shapes.tolerances.length_unit;
    constexpr float growth = 3;
    for (float reach = first_look; reach < max_distance; reach *= growth)
        if (const std::optional<NearestPoint> nearest = nearest_within(world, point, reach, filter)) return nearest;
    return nearest_within(world, point, max_distance, filter);
}

} // namespace carom
