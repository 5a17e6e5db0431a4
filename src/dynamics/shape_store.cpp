// Adds and removes shapes, and keeps the list of those that moved.
#include "dynamics/shape_store.hpp"

#include "broadphase/box4.hpp"
#include "dynamics/contact_store.hpp"
#include "memory/make_room.hpp"

#include <algorithm>

namespace carom::detail
{

std::uint32_t ShapeStore::create(std::uint32_t body, Geometry shape, const ShapeDef& def)
{
    const std::size_t count = records.size() + 1;
    detail::make_room(records, count);
    detail::make_room(geometry, count);
    detail::make_room(extents, count);
    detail::make_room(bounds, count);
    detail::make_room(searched, count);
    detail::make_room(place_in_moved, count);
    detail::make_room(moved, count); // so that marking a shape never allocates
    const std::uint32_t slot = slots.acquire();
    if (slot == records.size())
    {
        records.emplace_back();
        geometry.emplace_back();
        extents.emplace_back();
        bounds.emplace_back();
        searched.push_back(empty_box);
        place_in_moved.push_back(null_index);
    }
    records[slot] = {.body = body,
                     .is_sensor = def.is_sensor,
                     .contact_events = def.contact_events,
                     .persist_events = def.persist_events,
                     .sensor_events = def.sensor_events,
                     .hit_events = def.hit_events,
                     .pre_solve = def.pre_solve,
                     .filter = def.filter,
                     .density = def.density,
                     .material = def.material,
                     .user_data = def.user_data};
    geometry[slot] = shape;
    extents[slot] = extent_of(shape);
    bounds[slot] = {};
    forget_search(slot);
    return slot;
}

void ShapeStore::make_room() { detail::make_room(moved, records.size()); }

void ShapeStore::shrink()
{
    slots.drop_tail();
    cut(records, slots.size());
    cut(geometry, slots.size());
    cut(extents, slots.size());
    cut(bounds, slots.size());
    cut(searched, slots.size());
    cut(place_in_moved, slots.size());
    cut(moved, moved.size());
    make_room();
}

void ShapeStore::destroy(std::uint32_t slot)
{
    unmark_moved(slot);
    slots.release(slot);
}

void ShapeStore::reserve(std::size_t count)
{
    slots.reserve(count);
    records.reserve(count);
    geometry.reserve(count);
    extents.reserve(count);
    bounds.reserve(count);
    searched.reserve(count);
    moved.reserve(count);
    place_in_moved.reserve(count);
}

void ShapeStore::mark_moved(std::uint32_t slot)
{
    if (place_in_moved[slot] != null_index) return;
    place_in_moved[slot] = static_cast<std::uint32_t>(moved.size());
    moved.push_back(slot);
}

void ShapeStore::mark_changed(std::uint32_t slot)
{
    forget_search(slot);
    mark_moved(slot);
}

void ShapeStore::forget_search(std::uint32_t slot) { searched[slot] = empty_box; }

void ShapeStore::end_search(bool keeps)
{
    for (const std::uint32_t slot : moved) searched[slot] = keeps ? bounds[slot].fat : empty_box;
    clear_moved();
}

void ShapeStore::unmark_moved(std::uint32_t slot)
{
    const std::uint32_t place = place_in_moved[slot];
    if (place == null_index) return;
    moved[place] = moved.back();
    place_in_moved[moved[place]] = place;
    moved.pop_back();
    place_in_moved[slot] = null_index;
}

void ShapeStore::clear_moved()
{
    for (const std::uint32_t slot : moved) place_in_moved[slot] = null_index;
    moved.clear();
}

Aabb fattened(const Aabb& tight, Vec2 way, float max_margin)
{
    constexpr float share_of_size = 0.125f;
    const Vec2 half = tight.half_extent();
    const float margin = std::min(2 * share_of_size * std::max(half.x, half.y), max_margin);
    return swept(expanded(tight, margin), way);
}

void refresh_wishes(Contact& contact, const ShapeStore& shapes)
{
    const ShapeRecord& a = shapes.records[contact.shape_a];
    const ShapeRecord& b = shapes.records[contact.shape_b];
    contact.wants_persist = a.persist_events || b.persist_events;
    contact.wants_hits = a.hit_events || b.hit_events;
    contact.is_watched = contact.wants_persist || contact.wants_hits || a.pre_solve || b.pre_solve;
}

bool should_collide(const Filter& a, const Filter& b)
{
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

} // namespace carom::detail
