// A visitor that shows a world's insides; the engine draws nothing itself.
#pragma once

#include <carom/events.hpp>
#include <carom/ids.hpp>
#include <carom/math.hpp>
#include <carom/shape.hpp>

namespace carom
{

/// Derive, overload what you want to see, and hand to World::debug_draw. Calls come by store order. The world must not be edited
/// from inside.
class DebugDraw
{
public:
    virtual ~DebugDraw() = default;

    virtual void shape(ShapeId, BodyId, const Geometry&, const Transform&) {}
    /// The bounds of a shape; `fat` are those that the broad phase works with.
    virtual void bounds(ShapeId, const Aabb& /*tight*/, const Aabb& /*fat*/) {}
    virtual void center_of_mass(BodyId, Vec2) {}
    virtual void contact(ShapeId, ShapeId, const Manifold&) {}
    /// A node of the broad phase; the root has depth 0.
    virtual void broad_phase_node(const Aabb&, int /*depth*/) {}
};

} // namespace carom
