// Shapes: geometry, bounds and surface by slot, and which of them have left their fattened bounds.
#pragma once

#include "dynamics/slot_pool.hpp"
#include "geometry/extent.hpp"
#include "geometry/tolerances.hpp"

#include <carom/math.hpp>
#include <carom/shape.hpp>

#include <algorithm>
#include <cstdint>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

struct Contact;

/// What the hot loops don't read of each shape, by slot. What tells whether two shapes may meet comes first, side by side.
struct ShapeRecord
{
    std::uint32_t body = null_index;
    std::uint32_t previous_of_body = null_index;
    std::uint32_t next_of_body = null_index;
    std::uint32_t chain = null_index;             ///< that the shape is a segment of
    std::uint32_t previous_in_chain = null_index; ///< the segment that ends where this one starts
    std::uint32_t next_in_chain = null_index;
    bool is_one_sided = false; ///< a segment that is solid on the right of the way from p1 to p2 only
    bool is_sensor = false;
    bool contact_events = true;
    bool persist_events = false;
    bool sensor_events = true;
    bool hit_events = false;
    bool pre_solve = false;
    Filter filter;
    float density = 1;
    Material material;
    std::uint64_t user_data = 0;
    /// The number of steps when an edit last made it meet others: put it there, moved it, changed its filter.
    std::uint64_t placed_at = never;
};

/// Where a shape is, by slot. The fat bounds are what the broad phase sees: they change only when the tight ones leave them.
struct ShapeBounds
{
    Aabb tight;
    Aabb fat;
};

/// All shapes of a world, in arrays by slot.
class ShapeStore
{
public:
    explicit ShapeStore(std::pmr::memory_resource& memory)
        : slots(memory),
          records(&memory),
          geometry(&memory),
          extents(&memory),
          bounds(&memory),
          searched(&memory),
          moved(&memory),
          place_in_moved(&memory)
    {
    }

    /// Changes nothing when memory runs out.
    /// @param shape by value: the caller's may lie in the array that grows here
    std::uint32_t create(std::uint32_t body, Geometry shape, const ShapeDef& def);
    void destroy(std::uint32_t slot);
    void reserve(std::size_t count);
    /// Room to mark every shape as moved: what create() sees to, and a copy of the arrays does not bring along.
    void make_room();
    /// Gives back the memory of what lies behind the last shape, and spare room.
    void shrink();

    /// Asks for new pairs of this shape in the next step.
    void mark_moved(std::uint32_t slot);
    /// The same after an edit: pairs that could not be contacts before may be now.
    void mark_changed(std::uint32_t slot);
    /// The next search judges every pair of this shape, also those whose bounds overlapped in the last one.
    void forget_search(std::uint32_t slot);
    /// The search for pairs is over. @param keeps whether each pair that it found was judged by the stores alone
    void end_search(bool keeps);
    void unmark_moved(std::uint32_t slot);
    void clear_moved();

    Tolerances tolerances; ///< how near is near enough between these shapes: of the world
    SlotPool slots;
    std::pmr::vector<ShapeRecord> records;
    std::pmr::vector<Geometry> geometry;
    std::pmr::vector<Extent> extents; ///< of the geometry
    std::pmr::vector<ShapeBounds> bounds;
    /// The fat bounds in the last search for pairs, or an empty box. Where those of two shapes overlap, the pair is a contact or must not be one.
    std::pmr::vector<Aabb> searched;
    std::pmr::vector<std::uint32_t> moved;          ///< slots whose fat bounds are new since the last search for pairs, in any order
    std::pmr::vector<std::uint32_t> place_in_moved; ///< by slot; null_index when not there
};

/// A box and all places that it comes to on a straight way [m].
inline Aabb swept(const Aabb& box, Vec2 way)
{
    return {{box.min.x + std::min(way.x, 0.0f), box.min.y + std::min(way.y, 0.0f)},
            {box.max.x + std::max(way.x, 0.0f), box.max.y + std::max(way.y, 0.0f)}};
}

/// Bounds that a shape may move in for a while without being looked at again.
/// @param way        where the body goes in the near future [m]: the margin follows the velocity
/// @param max_margin Tolerances::max_bounds_margin [m]
Aabb fattened(const Aabb& tight, Vec2 way, float max_margin);

/// Makes what a contact tells of itself follow the wishes of its shapes.
void refresh_wishes(Contact& contact, const ShapeStore& shapes);

/// Whether two shapes may meet at all.
bool should_collide(const Filter& a, const Filter& b);

} // namespace carom::detail
