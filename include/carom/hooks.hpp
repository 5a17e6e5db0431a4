// A program's say in how contacts behave: which pairs meet, how surfaces mix, and what becomes of a contact before it is solved.
#pragma once

#include <carom/events.hpp>
#include <carom/ids.hpp>
#include <carom/shape.hpp>

namespace carom
{

/// A contact that is about to be solved. What you change holds for this step only; a number outside of Material's range, or not finite,
/// is ignored.
struct PreSolve
{
    ShapeId shape_a;
    ShapeId shape_b;
    /// Where they touch now, with the approach speeds of this step; impulses are 0.
    Manifold manifold;
    bool was_touching = false;    ///< in the step before, as the events told it
    bool is_enabled = true;       ///< false: the contact carries nothing in this step, and does not count as touching
    float friction = 0;           ///< as mixed
    float restitution = 0;        ///< as mixed
    float rolling_resistance = 0; ///< as mixed, times the larger radius [m]
    float tangent_speed = 0;      ///< as mixed [m/s]
};

/// Derive, overload what you want to decide, and give it to WorldDef::hooks or World::set_hooks. Calls come in an order that equal runs
/// repeat, from steps and from edits; destroying the world makes none. A hook may read the world; changing it throws UsageError, as during a step. An exception that leaves a hook stops the
/// step, and the world is then as after a step that its memory resource stopped.
class ContactHooks
{
public:
    virtual ~ContactHooks() = default;

    /// Whether two shapes that have come near each other, and whose filters allow it, may meet; also asked for sensors. The answer lasts as
    /// long as they stay near. Those that were refused are asked about again as they move.
    virtual bool should_collide(ShapeId /*a*/, ShapeId /*b*/) { return true; }

    /// Friction of two surfaces.
    /// @param mixed what MaterialMixing gives
    /// @return kept for as long as the contact lasts; a value that is negative or not finite is ignored, and `mixed` holds
    virtual float mix_friction(const Material& /*a*/, const Material& /*b*/, float mixed) { return mixed; }
    /// The same for restitution, 0 to 1.
    virtual float mix_restitution(const Material& /*a*/, const Material& /*b*/, float mixed) { return mixed; }

    /// Called in every step for each contact with points of a shape that has ShapeDef::pre_solve; not for sensors, nor while both
    /// bodies sleep.
    virtual void pre_solve(PreSolve& /*contact*/) {}
};

} // namespace carom
