// A few bodies with shapes and contacts, without a world: for tests of the stages that read and write the stores.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/shape_store.hpp"
#include "geometry/bounds.hpp"
#include "geometry/extent.hpp"

#include <algorithm>
#include <cstdint>
#include <memory_resource>

namespace carom::detail
{

struct SmallScene
{
    std::pmr::memory_resource& memory = *std::pmr::new_delete_resource();
    BodyStore bodies{memory};
    ShapeStore shapes{memory};
    ContactStore contacts{memory};

    /// A body with one shape around its origin.
    /// @return its slot, which is that of the shape too
    std::uint32_t add(const BodyDef& def, const Geometry& geometry, const ShapeDef& shape_def = {})
    {
        const std::uint32_t body = bodies.create(def);
        add_shape(body, geometry, shape_def);
        BodyRecord& record = bodies.records[body];
        record.shapes_mass = {.mass = 1, .center = {}, .inertia = 1};
        record.inner_radius = inner_radius(geometry);
        record.outer_radius = outer_radius(geometry, {});
        bodies.refresh_mass(body);
        bodies.refresh(body);
        return body;
    }

    std::uint32_t add_shape(std::uint32_t body, const Geometry& geometry, const ShapeDef& def = {})
    {
        const std::uint32_t shape = shapes.create(body, geometry, def);
        BodyRecord& record = bodies.records[body];
        shapes.records[shape].next_of_body = record.first_shape;
        record.first_shape = shape;
        ++record.shape_count;
        const Aabb tight = bounds_of(geometry, bodies.poses[body].transform);
        shapes.bounds[shape] = {tight, expanded(tight, 0.1f)};
        return shape;
    }

    std::uint32_t touch(std::uint32_t a, std::uint32_t b, bool is_sensor = false)
    {
        Contact contact = {.shape_a = std::min(a, b), .shape_b = std::max(a, b)};
        contact.body_a = shapes.records[contact.shape_a].body;
        contact.body_b = shapes.records[contact.shape_b].body;
        contact.is_sensor = is_sensor;
        return contacts.create(contact, bodies);
    }

    void place(std::uint32_t body, const Transform& transform)
    {
        bodies.set_transform(body, transform);
        for (std::uint32_t s = bodies.records[body].first_shape; s != null_index; s = shapes.records[s].next_of_body)
            shapes.bounds[s].tight = bounds_of(shapes.geometry[s], transform);
    }
};

} // namespace carom::detail
