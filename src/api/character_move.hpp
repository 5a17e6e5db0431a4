// A move of a character while it is made: what it touches, how far it can go, where it stands.
//
// The outline is kept a skin's width away from everything, by casting it with the skin around it. What the skin overlaps (something was
// moved into it, or it is squeezed) is left out of that cast and acts as a plane; and the bare outline is cast as well, so that nothing
// is ever entered.
#pragma once

#include <carom/character.hpp>
#include <carom/world.hpp>

#include <algorithm>
#include <array>
#include <optional>

namespace carom
{

class CharacterMove
{
public:
    CharacterMove(Character& character, World& world, Vec2 velocity, float dt);

    Vec2 run();

    /// Width of its skin [m].
    static float skin(const CharacterDef& def) { return def.skin * def.length_unit; }
    /// A shape with a skin around it.
    static Geometry grown(const Geometry& geometry, float by);

private:
    /// Planes that are heeded at once; more than a few touch only in a heap of rubble.
    static constexpr std::size_t most_planes = 16;
    /// Share of the skin that even the bare outline keeps.
    static constexpr float least_skin = 0.2f;

    /// How near is near enough, in a world of length unit `unit`.
    struct Margins
    {
        float unit = 1;               ///< [m]
        float contact = 2e-4f * unit; ///< a surface this near to the skin is touched: more than the rounding of a cast that ended there [m]
        float least_way = 1e-6f * unit;   ///< shorter displacements are none [m]
        float least_step = 0.001f * unit; ///< what rises by less is no step [m]
        float surprise = 0.1f * unit;     ///< ground that went farther than expected by more than this was teleported [m]
        float behind_edge = 0.02f * unit; ///< where the face behind an edge is looked for [m]
        float above_edge = 0.05f * unit;  ///< and from how high above it [m]
        float jump_speed = 1e-3f * unit;  ///< a faster velocity along `up` is a jump [m/s]
    };

    /// A surface that the skin touches or overlaps.
    struct Plane
    {
        ShapeId shape;
        BodyId body;
        Vec2 normal;          ///< towards the character
        Vec2 point;           ///< in the world [m]
        float separation = 0; ///< from the skin [m]
    };

    /// Leaves shapes out that act as planes, on top of the user's own predicate.
    class Without final : public QueryPredicate
    {
    public:
        explicit Without(const QueryPredicate* own) : own_(own) {}
        void add(ShapeId shape)
        {
            if (count_ < shapes_.size()) shapes_[count_++] = shape;
        }
        bool accepts(ShapeId shape, BodyId body) const override
        {
            const auto end = shapes_.begin() + static_cast<std::ptrdiff_t>(count_);
            return std::find(shapes_.begin(), end, shape) == end && (!own_ || own_->accepts(shape, body));
        }

    private:
        const QueryPredicate* own_;
        std::array<ShapeId, most_planes> shapes_;
        std::size_t count_ = 0;
    };

    // Where it is and what it touches.
    Transform here() const { return {character_.position_, {}}; }
    bool is_on_ground() const { return character_.ground_.state == GroundState::OnGround; }
    float lowest_point() const;
    bool is_walkable(Vec2 normal) const { return dot(normal, def_.up) >= least_up_; }
    QueryFilter filter(const QueryPredicate* predicate) const;
    void find_planes(float margin);
    std::optional<Vec2> edge_normal(Vec2 point, Vec2 normal) const;
    Vec2 ground_normal(Vec2 point, Vec2 normal) const;

    // Moving.
    void move_by(Vec2 way);
    float free_way(Vec2 way, CastHit* first = nullptr);
    float slide_share(Vec2& way);
    Vec2 against(Vec2 way, const Plane& plane) const;
    Vec2 against_all(Vec2 way) const;
    void carry();
    void get_out();
    void slide(Vec2 way, bool may_step);
    bool step_up(Vec2 way);
    void push(Vec2 wanted);
    void clip_velocity();
    const Plane* best_support() const;
    void find_ground(float reach);
    void stand_on(ShapeId shape, BodyId body, Vec2 point, Vec2 normal);

    Character& character_;
    const CharacterDef& def_;
    World& world_;
    const Margins margins_;
    Vec2 velocity_;
    float dt_;
    Vec2 right_;
    Geometry skinned_;
    Geometry guarded_;       ///< what must never be entered
    float least_up_;         ///< of a normal on which it can walk
    float highest_step_ = 0; ///< height along `up` at which an edge is too high to step on [m]
    std::array<Plane, most_planes> planes_;
    std::size_t plane_count_ = 0;
};

} // namespace carom
