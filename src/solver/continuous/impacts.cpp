// When two shapes begin to pass through each other, and what follows from it: impacts in the order of their times.
#include "solver/continuous/continuous.hpp"

#include "dynamics/ids.hpp"
#include "dynamics/one_sided.hpp"
#include "dynamics/walks.hpp"
#include "geometry/extent.hpp"
#include "geometry/manifold.hpp"
#include "solver/continuous/stays_apart.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace carom::detail
{

namespace
{

/// More than sliding_share against what can give way: in a crowd all push all, and who is stopped at each neighbour keeps a speed with which it
/// does not move (field_scenes_test). Less for bullets, and for what flies many times its own size in a step, since a grazing blow is a blow; and for two
/// that joints hold, which would tangle and never come to rest (ragdolls_test).
constexpr float crowding_share = 0.5f;
constexpr float grazing_share = 0.05f;
constexpr float crowded_way = 4; // in inner radii of the thinner one

Vec2 way_of_center(const Sweep& way) { return way.center_end - way.center_start; }

/// The contact of two shapes, looked for among those of one's body; null when there is none.
const Contact* find_contact(const BodyStore& bodies, const ContactStore& contacts, std::uint32_t body, std::uint32_t a, std::uint32_t b)
{
    for (const Tie tie : contacts_of(bodies, contacts, body))
    {
        const Contact& contact = contacts.contacts[tie.slot];
        if (contact.shape_a == std::min(a, b) && contact.shape_b == std::max(a, b)) return &contact;
    }
    return nullptr;
}

Sweep at_rest(const BodyPose& pose) { return {pose.local_center, pose.center, pose.center, pose.transform.q, 0}; }

/// What is left of a sweep from a part of it on.
Sweep rest(const Sweep& sweep, float from)
{
    if (from == 0) return sweep;
    return {sweep.local_center, lerp(sweep.center_start, sweep.center_end, from), sweep.center_end,
            rotation(from * sweep.turn) * sweep.q_start, (1 - from) * sweep.turn};
}

/// Along each axis the shorter of two ways, or none when they are opposed: it stays within the bounds of both.
Vec2 common_way(Vec2 a, Vec2 b)
{
    const auto common = [](float x, float y) { return x * y > 0 ? (std::abs(x) < std::abs(y) ? x : y) : 0.0f; };
    return {common(a.x, b.x), common(a.y, b.y)};
}

} // namespace

/// A hook is asked once a step about a pair.
bool ContinuousCollision::hook_refuses(const Pair& pair, const Surroundings& near)
{
    const auto is_it = [&](const std::pair<PairKey, bool>& said) { return said.first == pair.key; };
    const auto said = std::find_if(refusals_.begin(), refusals_.end(), is_it);
    if (said != refusals_.end()) return said->second;
    const auto id = [&](std::uint32_t s) { return id_of<ShapeId>(near.shapes, s, near.rules.world); };
    const auto [first, second] = std::minmax(pair.shape_a, pair.shape_b);
    const bool is_refused = !near.rules.hooks->should_collide(id(first), id(second));
    refusals_.emplace_back(pair.key, is_refused);
    return is_refused;
}

/// Whether a pair that its filters allow to meet does not do so now.
bool ContinuousCollision::may_pass(const Pair& pair, const Surroundings& near)
{
    const Mover& mover = movers_[pair.mover_a];
    const Contact* contact = find_contact(near.bodies, near.contacts, mover.body, pair.shape_a, pair.shape_b);
    if (contact && (contact->is_passing || contact->is_disabled)) return true;
    if (!contact && near.rules.hooks != nullptr && hook_refuses(pair, near)) return true;
    const Transform start_b = pair.mover_b == null_index ? near.bodies.poses[near.shapes.records[pair.shape_b].body].transform
                                                         : movers_[pair.mover_b].whole_way.at(0);
    return comes_from_behind(near.shapes, pair.shape_a, pair.shape_b, relative(mover.whole_way.at(0), start_b));
}

Sweep ContinuousCollision::rest_of_way(std::uint32_t mover, std::uint32_t shape, float after, const Surroundings& near) const
{
    return mover == null_index ? at_rest(near.bodies.poses[near.shapes.records[shape].body]) : way_left(mover, after);
}

std::uint32_t ContinuousCollision::version_of(const Pair& pair) const
{
    return movers_[pair.mover_a].version + (pair.mover_b == null_index ? 0 : movers_[pair.mover_b].version);
}

bool ContinuousCollision::can_be_stopped(std::uint32_t mover) const
{
    return mover != null_index && movers_[mover].can_stop && !movers_[mover].is_stopped;
}

/// Whether the mover goes on when it meets the other, and takes it along.
bool ContinuousCollision::carries(std::uint32_t mover, std::uint32_t other) const
{
    if (mover == null_index || !can_be_stopped(other)) return false;
    return !movers_[mover].can_stop || (movers_[mover].is_held && !movers_[mover].is_stopped && !movers_[other].is_held);
}

/// Notes when, after a time, the two would begin to pass through each other: when the core of A would go into B; where that is in B already, a
/// smaller core. They are stopped when they first touch.
void ContinuousCollision::seek_impact(const Pair& pair, float after, const Surroundings& near)
{
    const Tolerances& tolerances = near.shapes.tolerances;
    if (after >= 1 || (!can_be_stopped(pair.mover_a) && !can_be_stopped(pair.mover_b))) return;

    std::uint32_t shape = pair.shape_a;
    std::uint32_t other = pair.shape_b;
    Sweep way_a = rest_of_way(pair.mover_a, pair.shape_a, after, near);
    Sweep way_b = rest_of_way(pair.mover_b, pair.shape_b, after, near);
    float thickness = near.shapes.extents[shape].inner;
    float other_thickness = near.shapes.extents[other].inner;
    const float thinner = other_thickness > 0 ? std::min(thickness, other_thickness) : thickness;
    const BodyRecord* still = pair.mover_b == null_index ? &near.bodies.records[near.shapes.records[pair.shape_b].body] : nullptr;
    const bool are_held = movers_[pair.mover_a].is_held && (still ? still->first_joint != null_index : movers_[pair.mover_b].is_held);
    const bool has_bullet = movers_[pair.mover_a].is_bullet || (pair.mover_b != null_index && movers_[pair.mover_b].is_bullet);
    const float least_way = has_bullet ? 0 : fast_way(thinner, tolerances);
    const bool are_dynamic = movers_[pair.mover_a].can_stop && (still ? still->type == BodyType::Dynamic : movers_[pair.mover_b].can_stop);
    const bool are_crowded = !has_bullet && !are_held && length(way_of_center(way_a) - way_of_center(way_b)) < crowded_way * thinner;
    // In a crowd the thicker one's core counts: what stirs it is left to its contacts, and turns as fast as its spin says.
    const bool are_both_fast = pair.mover_b != null_index && movers_[pair.mover_b].is_fast;
    if (are_dynamic && are_crowded && are_both_fast && other_thickness > thickness)
    {
        std::swap(shape, other);
        std::swap(way_a, way_b);
        std::swap(thickness, other_thickness);
    }
    const float first_share = !are_dynamic ? sliding_share : are_crowded ? crowding_share : grazing_share;
    if (!may_pass_through(path_of(near.shapes.extents[shape], way_a), path_of(near.shapes.extents[other], way_b), least_way,
                          first_share * thickness, tolerances.linear_slop))
        return;

    const Geometry& geometry = near.shapes.geometry[shape];
    const ConvexPoints points_b = convex_points(near.shapes.geometry[other]);
    const float apart = distance_apart(tolerances);
    // What overlaps already is a matter for the contact; but what the contact does not hold must still not come out on the other side.
    std::optional<float> inside;
    for (const float share : {first_share, 0.5f, 0.75f, 0.95f})
    {
        if (share < first_share || (inside && share == first_share)) continue;
        const ConvexPoints core = core_of(geometry, share * thickness);
        if (stays_apart(core, way_a, points_b, way_b, apart)) return;
        if (!inside && !judge(pair, near).makes_contact) return;
        inside = time_of_impact(core, way_a, points_b, way_b, tolerances.impact_distance, tolerances);
        if (!inside || *inside > 0) break;
    }
    if (!inside || *inside <= 0 || may_pass(pair, near)) return;
    const std::optional<float> touch =
        time_of_impact(convex_points(geometry), way_a, points_b, way_b, tolerances.impact_distance, tolerances);
    const float time = after + (1 - after) * (touch && *touch > 0 ? *touch : *inside);
    impacts_.push_back({time, version_of(pair), pair});
    std::push_heap(impacts_.begin(), impacts_.end(), std::greater<>());
}

void ContinuousCollision::resolve_impacts(const Surroundings& near, BroadPhase& broad_phase)
{
    while (!impacts_.empty())
    {
        std::pop_heap(impacts_.begin(), impacts_.end(), std::greater<>());
        const Impact impact = impacts_.back();
        impacts_.pop_back();
        if (impact.version != version_of(impact.pair)) continue; // one of them has met another since, and the pair was judged anew
        changed_.clear();
        meet(impact.pair, impact.time, near, broad_phase);
        const auto judge_anew = [&](const Pair& pair)
        {
            if (pair.key != impact.pair.key) seek_impact(pair, impact.time, near);
        };
        for (const std::uint32_t mover : changed_) for_each_pair(mover, near, broad_phase, judge_anew);
    }
}

/// What is left of a mover's way from a time on.
Sweep ContinuousCollision::way_left(std::uint32_t mover, float time) const
{
    const Mover& m = movers_[mover];
    return rest(m.sweep, m.since < 1 ? (time - m.since) / (1 - m.since) : 1.0f);
}

/// From a time on two go on together: the one that can be stopped with the other, or both by what their ways have in common; so they meet no one that is not
/// near their own ways. A body to which that happens again and again stands still in the end.
void ContinuousCollision::meet(const Pair& pair, float time, const Surroundings& near, BroadPhase& broad_phase)
{
    constexpr std::uint32_t most_meetings = 3;
    const auto is_tired = [&](std::uint32_t m) { return movers_[m].version >= most_meetings; };
    const auto [a, b] = std::pair(pair.mover_a, pair.mover_b);
    const bool a_stops = can_be_stopped(a);
    const bool b_stops = can_be_stopped(b);
    if (carries(a, b) && !is_tired(b)) return follow(b, a, time, near, broad_phase);
    if (carries(b, a) && !is_tired(a)) return follow(a, b, time, near, broad_phase);
    const bool is_held = a_stops && movers_[a].is_held; // then so is B, or it would be carried
    if (!a_stops || !b_stops || is_held || is_tired(a) || is_tired(b))
    {
        if (a_stops) stop(a, time, near);
        if (b_stops) stop(b, time, near);
        return;
    }
    const Sweep left_a = way_left(a, time);
    const Sweep left_b = way_left(b, time);
    const Vec2 way = common_way(left_a.center_end - left_a.center_start, left_b.center_end - left_b.center_start);
    go_on(a, time, left_a, left_a.center_start + way, 0);
    go_on(b, time, left_b, left_b.center_start + way, 0);
}

/// @param left what was left of the mover's way
void ContinuousCollision::go_on(std::uint32_t index, float time, const Sweep& left, Vec2 center_end, float turn)
{
    Mover& mover = movers_[index];
    mover.sweep = {left.local_center, left.center_start, center_end, left.q_start, turn};
    mover.since = time;
    ++mover.version;
    changed_.push_back(index);
}

/// Stands still from a time on, and with it what joints hold to it: the ends of a joint must be where they were at the same time, or it is torn open.
void ContinuousCollision::stop(std::uint32_t index, float time, const Surroundings& near)
{
    constexpr std::size_t most = 64; // of a large mechanism those next to it
    const auto stop_one = [&](std::uint32_t mover)
    {
        const Sweep left = way_left(mover, time);
        go_on(mover, time, left, left.center_start, 0);
        movers_[mover].is_stopped = true;
    };
    const std::size_t first = changed_.size();
    stop_one(index);
    if (!movers_[index].is_held) return;
    for (std::size_t i = first; i < changed_.size() && changed_.size() - first < most; ++i)
    {
        for (const auto [joint, other] : joints_of(near.bodies, near.joints, movers_[changed_[i]].body))
        {
            if (other == null_index || !near.bodies.is_dynamic(other) || near.bodies.motion_index[other] == 0) continue;
            const std::uint32_t mover = mover_of(other, last_key, near);
            if (!movers_[mover].is_stopped) stop_one(mover);
        }
    }
}

/// Keeps its place on another that goes on: off its own way, and so to what was not near that.
void ContinuousCollision::follow(std::uint32_t index, std::uint32_t carrier, float time, const Surroundings& near, BroadPhase& broad_phase)
{
    const Sweep left = way_left(index, time);
    const Sweep lead = way_left(carrier, time);
    go_on(index, time, left, lead.at(1) * inverse_transform(lead.at(0), left.center_start), lead.turn);

    const Sweep way = movers_[index].sweep;
    for (const std::uint32_t shape : shapes_of(near.bodies, near.shapes, movers_[index].body))
    {
        const SweptPath path = path_of(near.shapes.extents[shape], way);
        const Aabb middle = merge(Aabb{path.from, path.from}, Aabb{path.from + path.way, path.from + path.way});
        list_near(expanded(middle, path.reach), broad_phase);
        for (const ProxyIndex other : near_)
            if (!is_known(index, shape, other, near.shapes)) add_late_pair(index, shape, other, near);
    }
}

} // namespace carom::detail
