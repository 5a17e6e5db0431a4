// Continuous collision: stops fast bodies where they would pass through something.
//
// The solver lets bodies move first; then the few that moved more than half their size in the step are looked at again, along their way. Those that
// would have gone through another body are set back to the moment of touch, with the velocity that they have; in the next step the touch is an
// ordinary contact. A pair that moves by less than that, as seen from each other, is left to its contact: what rides in a drum hardly moves against
// its wall. Two fast bodies that meet go on by what their ways have in common: a crowd that flows goes on flowing. A body that a moving
// kinematic one would have passed through is carried along by it from then on; so is a free body by one that joints hold, which would tear at them
// if it were stopped.
//
// Impacts are handled in the order of their times. Whenever the way of a body changes, it is judged anew against those of others. So nothing passes through
// anything, whatever the bodies are.
//
//   continuous.cpp  the stage as a whole, and what it writes
//   candidates.cpp  which shapes may meet
//   impacts.cpp     when they do, and what follows
//   crossings.cpp   sensors that were crossed
#pragma once

#include "broadphase/broad_phase.hpp"
#include "dynamics/body_store.hpp"
#include "dynamics/contact_rules.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/finalize_bodies.hpp"
#include "dynamics/find_pairs.hpp"
#include "dynamics/joint_store.hpp"
#include "dynamics/shape_store.hpp"
#include "dynamics/walks.hpp"
#include "geometry/time_of_impact.hpp"
#include "solver/continuous/swept_path.hpp"

#include <cstdint>
#include <functional>
#include <memory_resource>
#include <utility>
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
    /// @param fast    as finalize_bodies left it; the fat bounds of fast shapes hold the whole way, and are ordinary ones after
    /// @param contacts, rules who passes whom: through a one-sided segment, or because a hook says so
    /// @param dt    of the step [s]
    void run(const FastMotion& fast, BodyStore& bodies, ShapeStore& shapes, const JointStore& joints, const ContactStore& contacts,
             const ContactRules& rules, BroadPhase& broad_phase, float dt);

    std::span<const Crossing> crossings() const { return crossings_; }

private:
    /// Orders pairs by the shapes of fast bodies, in the order of these, and by the other shape; those that are found later come later. So it
    /// does not depend on where a pair was found.
    using PairKey = std::uint64_t;
    static constexpr PairKey first_late_key = PairKey{1} << 63;
    static constexpr PairKey last_key = ~PairKey{0};

    /// A body whose way is judged.
    struct Mover
    {
        std::uint32_t body;
        Sweep whole_way; ///< of the step, as the solver left it
        Sweep sweep;     ///< from `since` to the end of the step
        bool can_stop;   ///< dynamic
        bool is_held;    ///< has joints: goes on rather than a body without
        bool is_bullet;
        bool is_fast;                          ///< found by its way, and not as what another runs into
        bool is_stopped = false;               ///< stands still since then
        float since = 0;                       ///< in the time of the step, 0 to 1
        std::uint32_t version = 0;             ///< counts its meetings
        PairKey made_for = 0;                  ///< of a body that is not fast: in pairs before this one it is taken to stand still
        std::uint32_t first_late = null_index; ///< of its pairs in late_pairs_
    };

    /// A shape of a fast body on its way: what tells most pairs apart, in one cache line.
    struct alignas(64) ShapeWay
    {
        SweptPath path;
        Aabb bounds;     ///< hold the whole way
        float least_way; ///< relative way that counts [m]
        std::uint32_t shape;
        std::uint32_t mover;
        bool is_sensor;
    };

    /// Two shapes that may meet; B may be of a body that is not fast.
    struct Pair
    {
        std::uint32_t mover_a;
        std::uint32_t mover_b; ///< null_index: at rest where it is
        std::uint32_t shape_a;
        std::uint32_t shape_b;
        PairKey key;
    };

    /// Found when a body left its own way.
    struct LatePair
    {
        Pair pair;
        std::uint32_t next_of_a; ///< in the list of mover A's late pairs
        std::uint32_t next_of_b;
    };

    struct Impact
    {
        float time;
        std::uint32_t version; ///< of both movers together, when it was found
        Pair pair;

        friend bool operator>(const Impact& l, const Impact& r) { return l.time != r.time ? l.time > r.time : l.pair.key > r.pair.key; }
    };

    /// A shape of a fast body, by its place in ways_, and another that is near.
    struct Candidate
    {
        std::uint32_t way;
        std::uint32_t other;
    };

    /// The stores that say which shapes may meet.
    struct Surroundings
    {
        const BodyStore& bodies;
        const ShapeStore& shapes;
        const JointStore& joints;
        const ContactStore& contacts;
        const ContactRules& rules;
        std::span<const Displacement> displacements; ///< by motion index
        float dt;                                    ///< of the step [s]
    };

    class NearFast;

    void add_movers(std::span<const FastBody> fast, const Surroundings& near);
    std::uint32_t mover_of(std::uint32_t body, PairKey made_for, const Surroundings& near);

    void find_candidates(std::span<const std::uint32_t> strayed, const Surroundings& near, BroadPhase& broad_phase);
    void search(std::span<const std::uint32_t> moved, const Surroundings& near, BroadPhase& broad_phase);
    void walk_contacts(std::span<const std::uint32_t> strayed, const Surroundings& near);
    void consider(std::uint32_t a, std::uint32_t b, const Surroundings& near);
    bool moves_along(const ShapeWay& way, std::uint32_t other, const Surroundings& near) const;
    void find_carried(const Surroundings& near);
    bool may_meet(const ShapeWay& way, const Pair& pair, const Surroundings& near) const;
    void judge_candidates(const Surroundings& near);
    PairKey key_of(std::uint32_t way, std::uint32_t other) const;
    Pair pair_of(std::uint32_t mover, std::uint32_t shape, std::uint32_t other, PairKey key, const Surroundings& near) const;
    PairVerdict judge(const Pair& pair, const Surroundings& near) const;
    bool runs_into(const Pair& pair, const Surroundings& near) const;
    const Sweep& way_for_order(std::uint32_t mover, PairKey key) const;
    template <class Action>
    void for_each_pair(std::uint32_t mover, const Surroundings& near, BroadPhase& broad_phase, Action&& action);
    bool is_known(std::uint32_t mover, std::uint32_t shape, std::uint32_t other, const ShapeStore& shapes) const;
    void add_late_pair(std::uint32_t mover, std::uint32_t shape, std::uint32_t other, const Surroundings& near);
    std::uint32_t next_late(std::uint32_t late, std::uint32_t mover) const;
    void list_near(const Aabb& box, BroadPhase& broad_phase);

    bool may_pass(const Pair& pair, const Surroundings& near);
    bool hook_refuses(const Pair& pair, const Surroundings& near);
    Sweep rest_of_way(std::uint32_t mover, std::uint32_t shape, float after, const Surroundings& near) const;
    bool can_be_stopped(std::uint32_t mover) const;
    bool carries(std::uint32_t mover, std::uint32_t other) const;
    void seek_impact(const Pair& pair, float after, const Surroundings& near);
    std::uint32_t version_of(const Pair& pair) const;
    void resolve_impacts(const Surroundings& near, BroadPhase& broad_phase);
    Sweep way_left(std::uint32_t mover, float time) const;
    void meet(const Pair& pair, float time, const Surroundings& near, BroadPhase& broad_phase);
    void go_on(std::uint32_t mover, float time, const Sweep& left, Vec2 center_end, float turn);
    void stop(std::uint32_t mover, float time, const Surroundings& near);
    void follow(std::uint32_t mover, std::uint32_t carrier, float time, const Surroundings& near, BroadPhase& broad_phase);

    void place_bodies(BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float dt);
    void find_crossings(const BodyStore& bodies, const ShapeStore& shapes);

    std::pmr::vector<Mover> movers_;
    std::pmr::vector<std::uint32_t> mover_of_body_; ///< by body slot; null_index
    std::pmr::vector<ShapeWay> ways_;
    std::pmr::vector<std::uint32_t> way_of_shape_; ///< by shape slot; null_index
    std::pmr::vector<Candidate> candidates_;
    std::pmr::vector<LatePair> late_pairs_;
    std::pmr::vector<Pair> sensor_pairs_;
    std::pmr::vector<Impact> impacts_;        ///< a heap: the first comes first
    std::pmr::vector<std::uint32_t> changed_; ///< movers whose way an impact has changed
    std::pmr::vector<ProxyIndex> near_;
    std::pmr::vector<std::pair<PairKey, bool>> refusals_; ///< what a hook has said of pairs
    std::pmr::vector<Crossing> crossings_;
    bool has_carriers_ = false; ///< fast bodies that go on when they meet others
};

/// Calls action(pair) for each pair of a mover: of those that were near at first, and of those that came to be.
template <class Action>
void ContinuousCollision::for_each_pair(std::uint32_t mover, const Surroundings& near, BroadPhase& broad_phase, Action&& action)
{
    const Mover& m = movers_[mover];
    for (const std::uint32_t shape : shapes_of(near.bodies, near.shapes, m.body))
    {
        const Aabb& bounds = near.shapes.bounds[shape].fat;
        list_near(bounds, broad_phase);
        for (const ProxyIndex other : near_)
        {
            const bool is_other_fast = way_of_shape_[other] != null_index;
            if ((!m.is_fast && !is_other_fast) || !overlaps(bounds, near.shapes.bounds[other].fat)) continue;
            const bool finds_other = m.is_fast && (!is_other_fast || shape < other);
            const std::uint32_t finder = finds_other ? shape : other;
            const std::uint32_t found = finds_other ? other : shape;
            const std::uint32_t way = way_of_shape_[finder];
            if (near.shapes.records[other].body == m.body || near.shapes.records[finder].is_sensor || near.shapes.records[found].is_sensor)
                continue;
            const Pair pair = pair_of(ways_[way].mover, finder, found, key_of(way, found), near);
            if (pair.mover_a == mover || pair.mover_b == mover) action(pair);
        }
    }
    for (std::uint32_t p = movers_[mover].first_late; p != null_index; p = next_late(p, mover)) action(late_pairs_[p].pair);
}

} // namespace carom::detail
