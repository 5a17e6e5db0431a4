// A character that walks: moves by collide-and-slide instead of by forces, so that it does exactly what a player asks, and never tips over.
#pragma once

#include <carom/ids.hpp>
#include <carom/math.hpp>
#include <carom/queries.hpp>
#include <carom/shape.hpp>

#include <optional>

namespace carom
{

class World;

/// Lengths in metres, but for the skin. All is checked when a Character is made.
struct CharacterDef
{
    /// Its outline in its own frame, which never turns: as a rule an upright capsule, whose round foot takes small bumps.
    Geometry geometry = Capsule{{0, -0.5f}, {0, 0.5f}, 0.3f};
    Vec2 position = {};         ///< of its frame
    Vec2 up = {0, 1};           ///< unit: against gravity
    float max_slope = 0.87f;    ///< steepest ground that it walks on, 0 to 1.5 [rad]
    float step_height = 0.3f;   ///< highest step that it walks up, >= 0
    float snap_distance = 0.3f; ///< while it walks, ground so far below is followed down: steps and slopes downwards; >= 0
    float skin = 0.01f;         ///< gap that it keeps to everything [length units], 0.001 to 0.1
    float length_unit = 1;      ///< WorldDef::length_unit of the world that it moves in [m]
    float push_force = 0;       ///< with which it pushes dynamic bodies in its way [N], >= 0; 0 makes them like walls
    /// What it collides with; sensors never. When it has a body in the world for others to collide with, that is the ignored_body.
    QueryFilter filter = {};
};

enum class GroundState
{
    InAir,    ///< nothing below
    TooSteep, ///< on ground that is steeper than max_slope: it slides down
    OnGround  ///< on ground that it can walk on
};

/// What a character stands on.
struct CharacterGround
{
    GroundState state = GroundState::InAir;
    ShapeId shape; ///< null in the air
    BodyId body;   ///< null in the air
    Vec2 point;    ///< where it stands, in the world [m]
    Vec2 normal;   ///< of the ground, unit; of the face behind it, on the edge of a step
    Vec2 velocity; ///< of the ground at that point [m/s]
};

/// Moves through a world by queries alone; it is no body, and bodies do not see it. Plain data: copy it to try a move, or to keep a snapshot.
///
///     velocity.x = 5 * input;
///     velocity.y += -9.81f * dt;
///     if (jumps && character.ground().state == GroundState::OnGround) velocity.y = 5;
///     velocity = character.move(world, velocity, dt);
///     world.step(dt);
class Character
{
public:
    /// @throws UsageError on a value that is not finite or out of range
    explicit Character(const CharacterDef& def);

    /// Moves for one step: is carried by what it stands on, walks up steps and slopes, slides along what is in the way, follows the ground down, and
    /// gets out of what was moved into it.
    /// @param velocity wanted [m/s], up to max_speed; relative to the ground while it is on ground, else to the world. Upwards it is a jump: it leaves the ground.
    /// @param dt       [s], > 0, at most 1
    /// @return what is left of the velocity: without what walls, ceilings and ground took; to be given to the next move. It is relative to the ground
    ///         when the move ended on ground, else to the world: who jumps off a train keeps its speed.
    /// @throws UsageError also in a world that steps, or has another length unit. Changes the world only when push_force is not 0.
    Vec2 move(World& world, Vec2 velocity, float dt);

    Vec2 position() const { return position_; }
    /// Teleports: it is in the air until the next move.
    void set_position(Vec2 position);
    const CharacterGround& ground() const { return ground_; } ///< as of the last move
    const CharacterDef& def() const { return def_; }
    Transform transform() const { return {position_, {}}; } ///< for drawing its geometry

private:
    friend class CharacterMove;

    CharacterDef def_;
    Vec2 position_;
    CharacterGround ground_;
    Vec2 foot_on_ground_; ///< ground_.point in the frame of the ground's body
};

} // namespace carom
