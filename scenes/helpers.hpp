// What several scenes need: walls, flashes, a value for every shape, and drawing what a world holds.
#pragma once

#include "scenes/draw_list.hpp"
#include "scenes/random.hpp"

#include <carom/carom.hpp>

#include <optional>
#include <vector>

namespace carom::scenes
{

/// Four static walls around a field, thick enough that nothing passes through in one step.
void add_walls(World& world, const Aabb& field, const Material& material);
inline constexpr float wall_thickness = 10; ///< [m]

/// A convex polygon of 3 to 8 corners within a circle, none of them too sharp.
Polygon random_polygon(Random& random, float radius);

/// The first shape in store order of a dynamic body that covers a point.
std::optional<ShapeId> shape_at(const World& world, Vec2 point);

/// A light that goes out by itself.
class Flash
{
public:
    static constexpr double seconds = 0.3;
    void start(double now) { until_ = now + seconds; }
    bool is_on(double now) const { return now < until_; }

private:
    double until_ = 0;
};

/// A value for every shape, found by its id. A place whose shape is gone starts afresh with the next one.
template <class T>
class PerShape
{
public:
    T& operator[](ShapeId id)
    {
        if (id.index >= slots_.size()) slots_.resize(id.index + 1);
        Slot& slot = slots_[id.index];
        if (slot.generation != id.generation) slot = {id.generation, T{}};
        return slot.value;
    }
    /// Null when nothing was kept for the shape.
    const T* find(ShapeId id) const
    {
        const bool is_kept = id.index < slots_.size() && slots_[id.index].generation == id.generation;
        return is_kept ? &slots_[id.index].value : nullptr;
    }

private:
    struct Slot
    {
        std::uint32_t generation = 0;
        T value = {};
    };
    std::vector<Slot> slots_;
};

/// Calls draw(ShapeId, const Geometry&, const Transform&) for every shape of the world.
template <class Draw>
void for_each_shape(const World& world, const Draw& draw)
{
    struct Visitor : DebugDraw
    {
        explicit Visitor(const Draw& d) : draw(d) {}
        void shape(ShapeId id, BodyId, const Geometry& geometry, const Transform& transform) override { draw(id, geometry, transform); }
        const Draw& draw;
    };
    Visitor visitor(draw);
    world.debug_draw(visitor, DrawPart::Shapes);
}

/// The squares or boxes in which the broad phase has sorted the shapes.
void draw_broad_phase(const World& world, DrawList& list);
/// The boxes around shapes: tight, and as the broad phase sees them.
void draw_bounds(const World& world, DrawList& list);

} // namespace carom::scenes
