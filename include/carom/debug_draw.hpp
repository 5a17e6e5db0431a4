// A visitor that shows a world's insides; the engine draws nothing itself.
#pragma once

#include <carom/body.hpp>
#include <carom/events.hpp>
#include <carom/ids.hpp>
#include <carom/joint.hpp>
#include <carom/math.hpp>
#include <carom/shape.hpp>

namespace carom
{

/// Parts of a world that World::debug_draw can walk; combine with |. A part that is not asked for costs nothing.
enum class DrawPart : unsigned
{
    Shapes = 1,      ///< DebugDraw::shape
    Bounds = 2,      ///< DebugDraw::bounds
    Bodies = 4,      ///< DebugDraw::body
    Pairs = 8,       ///< DebugDraw::pair
    Contacts = 16,   ///< DebugDraw::contact
    Joints = 32,     ///< DebugDraw::joint
    BroadPhase = 64, ///< DebugDraw::broad_phase_node
    All = 127
};

constexpr DrawPart operator|(DrawPart a, DrawPart b) { return static_cast<DrawPart>(static_cast<unsigned>(a) | static_cast<unsigned>(b)); }

/// Whether `parts` has any of those in `wanted`.
constexpr bool includes(DrawPart parts, DrawPart wanted) { return (static_cast<unsigned>(parts) & static_cast<unsigned>(wanted)) != 0; }

struct DebugBody
{
    BodyId id;
    BodyType type = BodyType::Dynamic;
    Transform transform;        ///< of the origin
    Vec2 center_of_mass;        ///< in the world [m]
    Vec2 linear_velocity;       ///< of the centre of mass [m/s]
    float angular_velocity = 0; ///< [rad/s]
    bool is_awake = false;      ///< takes part in steps: enabled, not static, not asleep
    bool is_enabled = true;
    /// Equal for bodies of one island, -1 for those of none: static, kinematic and disabled ones. Bodies that have come apart may be in one island until
    /// one of them would like to sleep.
    int island = -1;
};

struct DebugContact
{
    /// The colour of a contact that found no group and is solved alone, one such contact after the other.
    static constexpr int overflow = 31;

    ShapeId shape_a;
    ShapeId shape_b;
    Manifold manifold;
    int color = -1; ///< the solver's group, 0 to 30, or `overflow`; contacts of one group share no dynamic body. -1 when it is not solved
    bool is_touching = false; ///< as the events of the last step told it
};

struct DebugJoint
{
    JointId id;
    JointType type = JointType::Revolute;
    BodyId body_a; ///< null when it is the world
    BodyId body_b;
    Vec2 anchor_a; ///< origin of frame A in the world; of a mouse joint its target [m]
    Vec2 anchor_b; ///< origin of frame B in the world [m]
    Vec2 force;    ///< on body B, mean over the last step [N]
};

/// Derive, overload what you want to see, and hand to World::debug_draw, or to StepView::debug_draw in the middle of a step. Calls come
/// part by part, the broad phase first and then in the order of the functions below, each part in the order of its store. The world must not be
/// edited from inside.
class DebugDraw
{
public:
    virtual ~DebugDraw() = default;

    virtual void shape(ShapeId, BodyId, const Geometry&, const Transform&) {}
    /// The bounds of a shape of an enabled body; `fat` are those that the broad phase works with.
    virtual void bounds(ShapeId, const Aabb& /*tight*/, const Aabb& /*fat*/) {}
    virtual void body(const DebugBody&) {}
    /// Two shapes whose fattened bounds overlap and that may meet, sensors included; the first has the lower index.
    /// @param is_new found by the last search, which is the first stage of every step
    virtual void pair(ShapeId, ShapeId, bool /*is_new*/) {}
    /// A pair with contact points; no sensors.
    virtual void contact(const DebugContact&) {}
    virtual void joint(const DebugJoint&) {}
    /// A node of the broad phase as of the last search for pairs; the root has depth 0. None after a copy or a change of the broad phase, until
    /// the next step.
    virtual void broad_phase_node(const Aabb&, int /*depth*/) {}
};

} // namespace carom
