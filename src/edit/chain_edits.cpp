// A chain is its segments, each a shape, and the links between them.
#include "edit/chain_edits.hpp"

#include "dynamics/walks.hpp"
#include "edit/edits.hpp"
#include "edit/wake.hpp"
#include "math/usage_error.hpp"

namespace carom::detail
{

namespace
{

/// Takes away the segments made so far; they are linked forwards, and the last has no next.
void remove_segments(WorldState& world, std::uint32_t first)
{
    for (std::uint32_t shape = first; shape != null_index;)
    {
        const std::uint32_t next = world.shapes.records[shape].next_in_chain;
        remove_shape(world, shape);
        shape = next;
    }
}

void link(ShapeStore& shapes, std::uint32_t shape, std::uint32_t next)
{
    shapes.records[shape].next_in_chain = next;
    shapes.records[next].previous_in_chain = shape;
}

} // namespace

std::uint32_t create_chain(WorldState& world, std::uint32_t body, const ChainDef& def)
{
    const std::size_t count = def.points.size();
    const std::size_t segments = def.is_loop ? count : count - 1;
    const bool is_one_sided = def.sides == ChainSides::OneSided;
    // A single material may be a shape's of this world, whose store is about to grow.
    const Material shared = def.materials.empty() ? Material{} : def.materials.front();
    ShapeDef shape_def = {.material = {},
                          .filter = def.filter,
                          .contact_events = def.contact_events,
                          .persist_events = def.persist_events,
                          .sensor_events = def.sensor_events,
                          .hit_events = def.hit_events,
                          .pre_solve = def.pre_solve};

    const std::uint32_t chain = world.chains.create({.body = body,
                                                     .segment_count = static_cast<std::uint32_t>(segments),
                                                     .is_loop = def.is_loop,
                                                     .is_one_sided = is_one_sided,
                                                     .user_data = def.user_data});
    std::uint32_t first = null_index;
    std::uint32_t last = null_index;
    Rollback without_chain([&]
    {
        remove_segments(world, first);
        world.chains.destroy(chain);
    });
    for (std::size_t i = 0; i < segments; ++i)
    {
        shape_def.material = def.materials.size() > 1 ? def.materials[i] : shared;
        const Segment segment = {def.points[i], def.points[i + 1 < count ? i + 1 : 0]};
        const std::uint32_t shape = create_shape(world, body, segment, shape_def);
        world.shapes.records[shape].chain = chain;
        world.shapes.records[shape].is_one_sided = is_one_sided;
        if (last != null_index) link(world.shapes, last, shape);
        first = first != null_index ? first : shape;
        last = shape;
    }
    without_chain.dismiss();
    if (def.is_loop) link(world.shapes, last, first);
    world.chains.records[chain].first_shape = first;
    return chain;
}

void destroy_chain(WorldState& world, std::uint32_t chain)
{
    const ChainRecord& record = world.chains.records[chain];
    wake_with_neighbors(world, record.body);
    for (const Tie tie : contacts_of(world.bodies, world.contacts, record.body))
    {
        const Contact& contact = world.contacts.contacts[tie.slot];
        if (world.shapes.records[contact.shape_a].chain == chain || world.shapes.records[contact.shape_b].chain == chain)
            destroy_contact(world, tie.slot);
    }
    const std::uint32_t first = record.first_shape;
    const std::uint32_t before = world.shapes.records[first].previous_in_chain;
    if (before != null_index) world.shapes.records[before].next_in_chain = null_index; // opens a loop
    remove_segments(world, first);
    refresh_extent(world, record.body);
    world.chains.destroy(chain);
}

std::uint32_t next_segment(const WorldState& world, std::uint32_t chain, std::uint32_t shape)
{
    const std::uint32_t next = world.shapes.records[shape].next_in_chain;
    return next == world.chains.records[chain].first_shape ? null_index : next;
}

void require_no_segment(const WorldState& world, std::uint32_t shape, std::string_view function, std::string_view remedy)
{
    if (world.shapes.records[shape].chain != null_index) [[unlikely]]
        usage_error(function, "shape", std::string_view("a segment of a chain"), remedy);
}

} // namespace carom::detail
