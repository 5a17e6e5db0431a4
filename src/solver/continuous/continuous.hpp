// Continuous collision: stops fast bodies where they would pass through something.
//
// The solver lets bodies move first; then the few that moved more than half their size in the step are looked at again, along their way. Those that
// would have gone through another body are set back to the moment of touch, with the velocity that they have; in the next step the touch is an
// ordinary contact. Two fast bodies that meet go on by what their ways have in common: a crowd that flows goes on flowing. A body that a moving
// kinematic one would have passed through is carried along by it from then on; so is a free body by one that joints hold, which would tear at them
// if it were stopped.
//
// Impacts are handled in the order of their times. Whenever the way of a body changes, it is judged anew against those of others. So nothing passes through
// anything, whatever the bodies are.
#pragma once

#include "broadphase/broad_phase.hpp"
#include "dynamics/body_store.hpp"
#include "dynamics/contact_rules.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/finalize_bodies.hpp"
#include "dynamics/joint_store.hpp"
#include "dynamics/shape_store.hpp"
#include "geometry/time_of_impact.hpp"

#include <cstdint>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

/// A shape went through a sensor within the step, and was outside before and after.
struct Crossing
{
    std::uint32_t shape_a; ///< the lower index; one of the two is a sensor
    std::uint32_t shape_b;

    friend auto operator<=>(const Crossing&, const Crossing&) = default;
};

class ContinuousCollision
{
public:
    /// @param scratch for the lists of a step
    explicit ContinuousCollision(std::pmr::memory_resource& scratch);

    /// To be called once.
    /// @param fast  bodies with their ways, as finalize_bodies found them; their fat bounds hold the whole way, and are ordinary ones after
    /// @param contacts, rules who passes whom: through a one-sided segment, or because a hook says so
    /// @param dt    of the step [s]
    /// @param way_ahead the way that fat bounds reach ahead, in steps [s]
    void run(std::span<const FastBody> fast, BodyStore& bodies, ShapeStore& shapes, const JointStore& joints, const ContactStore& contacts,
             const ContactRules& rules, BroadPhase& broad_phase, float dt, float way_ahead);

    std::span<const Crossing> crossings() const { return crossings_; }

private:
    /// A body whose way is judged.
    struct Mover
    {
        std::uint32_t body;
        Sweep sweep;     ///< from `since` to the end of the step
        Transform start; ///< where it was when the step began
        bool can_stop;   ///< dynamic
        bool is_held;    ///< has joints: goes on rather than a body without
        bool is_bullet;
        bool is_fast;                          ///< found by its way, and not as what another runs into
        float since = 0;                       ///< in the time of the step, 0 to 1
        bool is_stopped = false;               ///< stands still since then
        std::uint32_t version = 0;             ///< counts its meetings
        std::uint32_t first_pair = null_index; ///< of its list
    };

    /// Two shapes that may meet; B may be of a body that is not fast.
    struct Pair
    {
        std::uint32_t mover_a;
        std::uint32_t mover_b; ///< null_index: at rest where it is
        std::uint32_t shape_a;
        std::uint32_t shape_b;
        std::uint32_t next_of_a = null_index; ///< in the list of mover A's pairs
        std::uint32_t next_of_b = null_index;
        enum class Passing : std::uint8_t
        {
            Unknown, ///< asked when they would meet
            Yes,
            No
        } passing = Passing::Unknown;
    };

    struct Impact
    {
        float time;
        std::uint32_t pair;
        std::uint32_t version; ///< of both movers together, when it was found

        friend bool operator>(const Impact& l, const Impact& r) { return l.time != r.time ? l.time > r.time : l.pair > r.pair; }
    };

    /// The stores that say which shapes may meet.
    struct Surroundings
    {
        const BodyStore& bodies;
        const ShapeStore& shapes;
        const JointStore& joints;
        const ContactStore& contacts;
        const ContactRules& rules;
        float dt; ///< of the step [s]
    };

    void find_candidates(const Surroundings& near, BroadPhase& broad_phase);
    void add_candidate(std::uint32_t mover, std::uint32_t shape, std::uint32_t other, const Surroundings& near);
    std::uint32_t mover_of(std::uint32_t body, const Surroundings& near);
    void add_pair(const Pair& pair);
    bool has_pair(std::uint32_t mover, std::uint32_t shape, std::uint32_t other) const;
    std::uint32_t next_pair(std::uint32_t pair, std::uint32_t mover) const;
    bool may_pass(Pair& pair, const Surroundings& near) const;
    Sweep rest_of_way(std::uint32_t mover, std::uint32_t shape, float after, const BodyStore& bodies, const ShapeStore& shapes) const;
    bool can_be_stopped(std::uint32_t mover) const;
    bool carries(std::uint32_t mover, std::uint32_t other) const;
    void seek_impact(std::uint32_t pair, float after, const Surroundings& near);
    std::uint32_t version_of(const Pair& pair) const;
    void resolve_impacts(const Surroundings& near, BroadPhase& broad_phase);
    Sweep way_left(std::uint32_t mover, float time) const;
    void meet(const Pair& pair, float time, const Surroundings& near, BroadPhase& broad_phase);
    void go_on(std::uint32_t mover, float time, const Sweep& left, Vec2 center_end, float turn);
    void stop(std::uint32_t mover, float time, const Surroundings& near);
    void follow(std::uint32_t mover, std::uint32_t carrier, float time, const Surroundings& near, BroadPhase& broad_phase);
    void place_bodies(BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float way_ahead);
    void find_crossings(const BodyStore& bodies, const ShapeStore& shapes);

    std::pmr::vector<Mover> movers_;
    std::pmr::vector<std::uint32_t> mover_of_body_; ///< by body slot; null_index
    std::pmr::vector<Pair> pairs_;
    std::pmr::vector<Pair> sensor_pairs_;
    std::pmr::vector<Impact> impacts_;        ///< a heap: the first comes first
    std::pmr::vector<std::uint32_t> changed_; ///< movers whose way an impact has changed
    std::pmr::vector<ProxyIndex> near_;
    std::pmr::vector<Crossing> crossings_;
};

} // namespace carom::detail
