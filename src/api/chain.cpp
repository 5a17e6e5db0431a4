// The views of a chain: every call checks that the chain still exists.
#include <carom/chain.hpp>

#include "api/validate.hpp"
#include "dynamics/ids.hpp"
#include "edit/chain_edits.hpp"
#include "edit/edits.hpp"
#include "math/usage_error.hpp"
#include "state/guards.hpp"

namespace carom
{

using detail::require_chain;

namespace
{

std::uint32_t editable(const detail::WorldState& world, ChainId id, std::string_view function)
{
    detail::require_idle(world, function);
    return require_chain(world, id, function);
}

/// Every segment in order: action(shape).
template <class Action>
void for_each_segment(const detail::WorldState& world, std::uint32_t chain, Action&& action)
{
    std::uint32_t shape = world.chains.records[chain].first_shape;
    for (; shape != detail::null_index; shape = detail::next_segment(world, chain, shape)) action(shape);
}

/// Checks the number and walks to the segment.
std::uint32_t segment_at(const detail::WorldState& world, std::uint32_t chain, int segment, std::string_view function)
{
    const detail::ChainRecord& record = world.chains.records[chain];
    detail::require_range(function, "segment", segment, 0, static_cast<int>(record.segment_count) - 1);
    std::uint32_t shape = record.first_shape;
    for (int i = 0; i < segment; ++i) shape = world.shapes.records[shape].next_in_chain;
    return shape;
}

} // namespace

BodyId ChainView::body() const
{
    const std::uint32_t body = world_->chains.records[require_chain(*world_, id_, "body")].body;
    return detail::id_of<BodyId>(world_->bodies, body, world_->world);
}

int ChainView::segment_count() const
{
    return static_cast<int>(world_->chains.records[require_chain(*world_, id_, "segment_count")].segment_count);
}

std::vector<ShapeId> ChainView::segments() const
{
    const std::uint32_t chain = require_chain(*world_, id_, "segments");
    std::vector<ShapeId> ids;
    ids.reserve(world_->chains.records[chain].segment_count);
    for_each_segment(*world_, chain, [&](std::uint32_t shape) { ids.push_back(detail::shape_id(world_->shapes, shape, world_->world)); });
    return ids;
}

bool ChainView::is_loop() const { return world_->chains.records[require_chain(*world_, id_, "is_loop")].is_loop; }

ChainSides ChainView::sides() const
{
    return world_->chains.records[require_chain(*world_, id_, "sides")].is_one_sided ? ChainSides::OneSided : ChainSides::TwoSided;
}

const Material& ChainView::material(int segment) const
{
    const std::uint32_t chain = require_chain(*world_, id_, "material");
    return world_->shapes.records[segment_at(*world_, chain, segment, "material")].material;
}

std::uint64_t ChainView::user_data() const { return world_->chains.records[require_chain(*world_, id_, "user_data")].user_data; }

void Chain::set_material(const Material& material)
{
    const std::uint32_t chain = editable(*world_, id_, "set_material");
    detail::validate(material, "set_material");
    const Material copy = material; // it may be one of those that change
    for_each_segment(*world_, chain, [&](std::uint32_t shape) { detail::set_material(*world_, shape, copy); });
}

void Chain::set_material(int segment, const Material& material)
{
    const std::uint32_t chain = editable(*world_, id_, "set_material");
    detail::validate(material, "set_material");
    detail::set_material(*world_, segment_at(*world_, chain, segment, "set_material"), material);
}

void Chain::set_filter(const Filter& filter)
{
    const std::uint32_t chain = editable(*world_, id_, "set_filter");
    const Filter copy = filter; // it may be a segment's
    for_each_segment(*world_, chain, [&](std::uint32_t shape) { detail::set_filter(*world_, shape, copy); });
}

void Chain::set_user_data(std::uint64_t user_data)
{
    world_->chains.records[editable(*world_, id_, "set_user_data")].user_data = user_data;
}

} // namespace carom
