// Decides what a query sees.
#include "api/query_walk.hpp"

#include "dynamics/ids.hpp"

namespace carom::detail
{

BodyId body_id(const WorldState& world, std::uint32_t body) { return id_of<BodyId>(world.bodies, body, world.world); }

bool is_seen(const WorldState& world, std::uint32_t shape, const QueryFilter& filter)
{
    const ShapeRecord& record = world.shapes.records[shape];
    if (record.is_sensor && !filter.sensors) return false;
    if (!should_collide(filter.filter, record.filter)) return false;
    const BodyId body = body_id(world, record.body);
    if (body == filter.ignored_body) return false;
    return !filter.predicate || filter.predicate->accepts(shape_id(world.shapes, shape, world.world), body);
}

} // namespace carom::detail
