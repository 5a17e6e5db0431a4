// The views of a shape: every call checks that the shape still exists.
#include <carom/body.hpp>

#include "api/validate.hpp"
#include "dynamics/ids.hpp"
#include "dynamics/mix_materials.hpp"
#include "dynamics/narrow_phase.hpp"
#include "edit/chain_edits.hpp"
#include "edit/edits.hpp"
#include "edit/wake.hpp"
#include "geometry/bounds.hpp"
#include "geometry/validate.hpp"
#include "state/guards.hpp"

#include <algorithm>

namespace carom
{

using detail::for_each_contact_of_shape;
using detail::require_shape;

namespace
{

std::uint32_t editable(const detail::WorldState& world, ShapeId id, std::string_view function)
{
    detail::require_idle(world, function);
    return require_shape(world, id, function);
}

} // namespace

BodyId ShapeView::body() const
{
    const std::uint32_t body = world_->shapes.records[require_shape(*world_, id_, "body")].body;
    return detail::id_of<BodyId>(world_->bodies, body, world_->world);
}

ChainId ShapeView::chain() const
{
    const std::uint32_t chain = world_->shapes.records[require_shape(*world_, id_, "chain")].chain;
    return detail::id_or_null<ChainId>(world_->chains, chain, world_->world);
}

const Geometry& ShapeView::geometry() const { return world_->shapes.geometry[require_shape(*world_, id_, "geometry")]; }

float ShapeView::density() const { return world_->shapes.records[require_shape(*world_, id_, "density")].density; }

const Material& ShapeView::material() const { return world_->shapes.records[require_shape(*world_, id_, "material")].material; }

const Filter& ShapeView::filter() const { return world_->shapes.records[require_shape(*world_, id_, "filter")].filter; }

bool ShapeView::is_sensor() const { return world_->shapes.records[require_shape(*world_, id_, "is_sensor")].is_sensor; }

bool ShapeView::contact_events() const { return world_->shapes.records[require_shape(*world_, id_, "contact_events")].contact_events; }

bool ShapeView::persist_events() const { return world_->shapes.records[require_shape(*world_, id_, "persist_events")].persist_events; }

bool ShapeView::sensor_events() const { return world_->shapes.records[require_shape(*world_, id_, "sensor_events")].sensor_events; }

bool ShapeView::hit_events() const { return world_->shapes.records[require_shape(*world_, id_, "hit_events")].hit_events; }

bool ShapeView::pre_solve() const { return world_->shapes.records[require_shape(*world_, id_, "pre_solve")].pre_solve; }

Aabb ShapeView::bounds() const { return world_->shapes.bounds[require_shape(*world_, id_, "bounds")].tight; }

std::uint64_t ShapeView::user_data() const { return world_->shapes.records[require_shape(*world_, id_, "user_data")].user_data; }

bool ShapeView::contains(Vec2 world_point) const
{
    const std::uint32_t shape = require_shape(*world_, id_, "contains");
    detail::require_finite("contains", "world_point", world_point);
    const Transform& transform = world_->bodies.poses[world_->shapes.records[shape].body].transform;
    return detail::holds(world_->shapes.geometry[shape], inverse_transform(transform, world_point));
}

std::vector<ShapeId> ShapeView::touching() const
{
    const std::uint32_t shape = require_shape(*world_, id_, "touching");
    std::vector<ShapeId> ids;
    for_each_contact_of_shape(*world_, shape, [&](std::uint32_t slot)
    {
        const detail::Contact& contact = world_->contacts.contacts[slot];
        const std::uint32_t other = contact.shape_a == shape ? contact.shape_b : contact.shape_a;
        if (contact.is_touching) ids.push_back(detail::shape_id(world_->shapes, other, world_->world));
    });
    std::sort(ids.begin(), ids.end());
    return ids;
}

void Shape::set_material(const Material& material)
{
    const std::uint32_t shape = editable(*world_, id_, "set_material");
    detail::validate(material, "set_material");
    detail::set_material(*world_, shape, material);
}

void Shape::set_filter(const Filter& filter)
{
    const std::uint32_t shape = editable(*world_, id_, "set_filter");
    detail::set_filter(*world_, shape, filter);
}

void Shape::set_geometry(const Geometry& geometry)
{
    const std::uint32_t shape = editable(*world_, id_, "set_geometry");
    detail::require_no_segment(*world_, shape, "set_geometry", "make another chain");
    detail::validate(geometry, "set_geometry", world_->shapes.tolerances);
    detail::validate_density(geometry, world_->shapes.records[shape].density, "set_geometry");
    const std::uint32_t body = world_->shapes.records[shape].body;
    detail::wake_with_neighbors(*world_, body);
    detail::review_contacts(*world_, body);
    world_->shapes.geometry[shape] = geometry;
    world_->shapes.extents[shape] = detail::extent_of(geometry);
    if (world_->bodies.records[body].is_enabled)
        detail::renew_proxy(*world_, shape);
    else
        world_->shapes.bounds[shape].tight = detail::bounds_of(geometry, world_->bodies.poses[body].transform);
    // Features of the old geometry mean nothing on the new one.
    for_each_contact_of_shape(*world_, shape, [&](std::uint32_t slot)
    {
        detail::mix_again(*world_, slot);
        detail::forget_impulses(world_->contacts.manifolds[slot]);
        detail::set_roundings(world_->contacts.manifolds[slot], world_->contacts.contacts[slot], world_->shapes);
        world_->contacts.memories[slot] = {};
    });
    detail::refresh_mass(*world_, body);
}

void Shape::set_density(float density)
{
    const std::uint32_t shape = editable(*world_, id_, "set_density");
    detail::validate_density(world_->shapes.geometry[shape], density, "set_density");
    world_->shapes.records[shape].density = density;
    detail::wake_body(*world_, world_->shapes.records[shape].body);
    detail::refresh_mass(*world_, world_->shapes.records[shape].body);
}

void Shape::set_hit_events(bool hit_events)
{
    const std::uint32_t shape = editable(*world_, id_, "set_hit_events");
    world_->shapes.records[shape].hit_events = hit_events;
    for_each_contact_of_shape(*world_, shape,
                              [&](std::uint32_t slot) { detail::refresh_wishes(world_->contacts.contacts[slot], world_->shapes); });
}

void Shape::set_pre_solve(bool pre_solve)
{
    const std::uint32_t shape = editable(*world_, id_, "set_pre_solve");
    world_->shapes.records[shape].pre_solve = pre_solve;
    // What a hook last changed is over.
    for_each_contact_of_shape(*world_, shape, [&](std::uint32_t slot)
    {
        detail::refresh_wishes(world_->contacts.contacts[slot], world_->shapes);
        detail::mix_again(*world_, slot);
    });
}

void Shape::set_user_data(std::uint64_t user_data)
{
    world_->shapes.records[editable(*world_, id_, "set_user_data")].user_data = user_data;
}

} // namespace carom
