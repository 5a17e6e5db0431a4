// Questions to a world: what a ray or a moving shape meets, what overlaps, what is nearest. And the same between two shapes.
#pragma once

#include <carom/ids.hpp>
#include <carom/math.hpp>
#include <carom/shape.hpp>

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace carom
{

/// Further reasons why a query should not see a shape. Derive, overload, and hand to QueryFilter.
class QueryPredicate
{
public:
    /// Asked about shapes that the rest of the filter lets through, in any order, and perhaps more than once. It must not change the world; it may query
    /// it. When several threads query with it at once, it is called by all of them.
    virtual bool accepts(ShapeId shape, BodyId body) const = 0;

protected:
    ~QueryPredicate() = default;
};

/// Which shapes a query sees. Shapes of disabled bodies are never seen.
struct QueryFilter
{
    Filter filter = {};       ///< sees a shape that a shape with this filter would meet
    bool sensors = false;     ///< sees sensors too
    BodyId ignored_body = {}; ///< does not see the shapes of this body, as of the one that asks; a stale id ignores nothing
    const QueryPredicate* predicate = nullptr; ///< null lets everything through
};

/// A way from a point.
struct Ray
{
    Vec2 start = {}; ///< [m]
    Vec2 sweep = {}; ///< from the start to the end: not a direction, its length counts [m]
};

/// What a ray or a moving shape meets.
///
/// A cast that starts inside of a shape, overlapping it by more than 5 um (times WorldDef::length_unit), meets it at once: starts_inside is set, the fraction is 0, the
/// normal (0, 0), the point that of the start. So a weapon that is pushed into a wall does not shoot through it, and a moving shape that is
/// stuck is told; who wants to pass through what it starts in asks starts_inside, or ignores the shape by the filter. A cast that starts
/// on a surface, within 5 um, meets it only if it leads inwards: a ray can start where another one ended, and a box slides along the floor
/// that it lies on. A segment has no inside: a ray that starts on it does not meet it.
///
/// A surface belongs to its shape. So a cast that comes from outside and only grazes a shape meets it: a ray exactly along a face, through a
/// corner, or along the tangent of a circle or of a rounding. A ray along a face meets the corner at which the face begins. Every query
/// that casts keeps this rule, as far as rounding can tell the cases apart.
struct CastHit
{
    ShapeId shape;
    BodyId body;                ///< whose shape it is
    float fraction = 0;         ///< of the sweep, in [0, 1]
    Vec2 point;                 ///< where they meet, on the surface of the shape [m]
    Vec2 normal;                ///< of the shape, unit, towards what was cast
    bool starts_inside = false; ///< see above
};
using RayHit = CastHit;

/// The point of some shape that is nearest to a given one.
struct NearestPoint
{
    ShapeId shape;
    BodyId body;
    Vec2 point;         ///< on the surface; the given point itself when that is inside [m]
    Vec2 normal;        ///< unit, from the surface to the given point; (0, 0) inside
    float distance = 0; ///< 0 inside [m]
};

/// Anything that can be called with a ShapeId: a lambda, as a rule. It is only referred to, for the time of a call. When it returns bool, false
/// ends the query.
class ShapeVisitor
{
public:
    template <class Visit>
        requires std::is_invocable_v<Visit&, ShapeId> && (!std::is_same_v<std::remove_cvref_t<Visit>, ShapeVisitor>)
    ShapeVisitor(Visit&& visit)
        : target_(const_cast<void*>(static_cast<const void*>(std::addressof(visit)))),
          call_(call<std::remove_reference_t<Visit>>)
    {
    }

    bool operator()(ShapeId shape) const { return call_(target_, shape); }

private:
    template <class Visit>
    static bool call(void* target, ShapeId shape)
    {
        Visit& visit = *static_cast<Visit*>(target);
        if constexpr (std::is_convertible_v<std::invoke_result_t<Visit&, ShapeId>, bool>)
            return visit(shape);
        else
            return visit(shape), true;
    }

    void* target_;
    bool (*call_)(void*, ShapeId);
};

/// Pushes the dynamic bodies around a point, once, away from it. A shape gets an impulse at its point that is nearest to the centre, in proportion to
/// the width that it turns towards the centre, as a blast wave would: large things are pushed harder and light things fly farther. What
/// stands in between gives no cover. Sleepers wake.
struct ExplosionDef
{
    Vec2 center = {};            ///< [m]
    float radius = 1;            ///< shapes within are pushed with full force [m], >= 0
    float falloff = 0;           ///< beyond the radius the force falls to 0 over this distance, evenly [m], >= 0
    float impulse_per_metre = 0; ///< of width [N s/m]; negative pulls
    QueryFilter filter = {};     ///< which shapes it pushes; sensors never, whatever the filter says
};

/// How near two shapes are. In the world's frame.
struct ShapeDistance
{
    float distance = 0; ///< between the surfaces, 0 when they overlap [m]
    Vec2 point_a;       ///< of A, nearest to B; a common point when they overlap [m]
    Vec2 point_b;       ///< of B, nearest to A [m]
    Vec2 normal;        ///< unit, from A to B; (0, 0) when they overlap by more than their rounding
};

/// @param transform_a, transform_b the frames of the shapes: p within max_coordinate, q a unit rotation
/// @throws UsageError on a shape or a transform that is out of range or not finite
ShapeDistance distance(const Geometry& a, const Transform& transform_a, const Geometry& b, const Transform& transform_b);

/// The way of a shape over a span of time: its centre moves evenly along a line while it turns evenly about it.
struct ShapeMotion
{
    Transform start = {}; ///< the frame of the shape at time 0
    Vec2 sweep = {};      ///< from time 0 to 1 [m]
    float turn = 0;       ///< from time 0 to 1, counter-clockwise, at most 1000 [rad]
    Vec2 center = {};     ///< about which it turns, in the frame of the shape, as a rule the centre of mass [m]
};

/// The first time at which two moving shapes come within a distance of each other.
/// @param target_distance between the surfaces, from 0.1 mm, times the length unit, to max_coordinate [m]
/// @param length_unit     typical size of a shape [m], as of WorldDef: the time is that of a distance within 0.25 mm, times this unit, of the target
/// @return in [0, 1], and never late: before it, they were not nearer at any moment; 0 when they start nearer; empty when they do not come that
///         near. When the shapes turn very much (tens of turns) it may be too early.
/// @throws UsageError on a shape or a motion that is out of range or not finite
std::optional<float> time_of_impact(const Geometry& a, const ShapeMotion& motion_a, const Geometry& b, const ShapeMotion& motion_b,
                                    float target_distance = 0.001f, float length_unit = 1);

} // namespace carom
