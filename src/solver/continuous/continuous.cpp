// Finds and orders the impacts of fast bodies.
#include "solver/continuous/continuous.hpp"

#include "dynamics/find_pairs.hpp"
#include "dynamics/one_sided.hpp"
#include "geometry/bounds.hpp"
#include "geometry/extent.hpp"
#include "geometry/manifold.hpp"
#include "solver/continuous/swept_path.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

namespace carom::detail
{

namespace
{

/// A shape that goes into another no deeper than this share of its inner radius has not begun to pass through: it slides along it, over tiles and
/// seams. Tests: continuous_test, terrain_test. Against what can give way, more: in a crowd all push all, and who is stopped at each neighbour
/// keeps a speed with which it does not move (field_scenes_test). For bullets, and for what flies many times its own size in a step, less, since a grazing
/// blow is a blow; and for two that joints hold, which would tangle and never come to rest (ragdolls_test).
constexpr float sliding_share = 0.25f;
constexpr float crowding_share = 0.5f;
constexpr float grazing_share = 0.05f;
constexpr float crowded_way = 4; // in inner radii of the thinner one

class Collector final : public BoxVisitor
{
public:
    explicit Collector(std::pmr::vector<ProxyIndex>& list) : list_(list) { list_.clear(); }
    bool visit(ProxyIndex proxy) override
    {
        list_.push_back(proxy);
        return true;
    }

private:
    std::pmr::vector<ProxyIndex>& list_;
};

/// The way of a body that is not fast, told by its velocity at the end: what rides on a lift does not run into it.
Sweep slow_way(const BodyStore& bodies, std::uint32_t body, float dt)
{
    const BodyPose& pose = bodies.poses[body];
    const float turn = dt * bodies.spin(body);
    return {pose.local_center, pose.center - dt * bodies.velocity(body), pose.center, rotation(-turn) * pose.transform.q, turn};
}

Vec2 center_way(const Sweep& way) { return way.center_end - way.center_start; }

/// The contact of two shapes, looked for among those of one's body; null when there is none.
const Contact* find_contact(const BodyStore& bodies, const ContactStore& contacts, std::uint32_t body, std::uint32_t a, std::uint32_t b)
{
    std::uint32_t edge = bodies.records[body].first_contact;
    for (; edge != null_index; edge = contacts.contacts[edge / 2].next[edge % 2])
    {
        const Contact& contact = contacts.contacts[edge / 2];
        if (contact.shape_a == std::min(a, b) && contact.shape_b == std::max(a, b)) return &contact;
    }
    return nullptr;
}

Sweep at_rest(const BodyPose& pose) { return {pose.local_center, pose.center, pose.center, pose.transform.q, 0}; }

/// What is left of a sweep from a part of it on.
Sweep rest(const Sweep& sweep, float from)
{
    return {sweep.local_center, lerp(sweep.center_start, sweep.center_end, from), sweep.center_end,
            rotation(from * sweep.turn) * sweep.q_start, (1 - from) * sweep.turn};
}

/// Two links of one chain, two limbs of one ragdoll. Stopping one of them would tear at the joints between; a whip that folds is better off without.
bool are_parts_of_one(const BodyStore& bodies, std::uint32_t a, std::uint32_t b)
{
    const BodyRecord& record_a = bodies.records[a];
    const BodyRecord& record_b = bodies.records[b];
    const bool have_joints = record_a.first_joint != null_index && record_b.first_joint != null_index;
    return have_joints && record_a.island != null_index && record_a.island == record_b.island;
}

/// An order of shapes on their ways that doesn't depend on when they were created: thin ones first, those without an inside last, and of equal
/// ones the one that goes farther.
bool goes_first(const ShapeStore& shapes, std::uint32_t a, const Sweep& way_a, std::uint32_t b, const Sweep& way_b)
{
    const auto rank = [&](std::uint32_t shape, const Sweep& way)
    {
        const Extent& extent = shapes.extents[shape];
        return std::tuple(extent.inner > 0 ? extent.inner : std::numeric_limits<float>::max(), extent.outer, shapes.geometry[shape].index(),
                          -length(center_way(way)));
    };
    return rank(a, way_a) < rank(b, way_b);
}

/// Along each axis the shorter of two ways, or none when they are opposed: it stays within the bounds of both.
Vec2 common_way(Vec2 a, Vec2 b)
{
    const auto common = [](float x, float y) { return x * y > 0 ? (std::abs(x) < std::abs(y) ? x : y) : 0.0f; };
    return {common(a.x, b.x), common(a.y, b.y)};
}

} // namespace

ContinuousCollision::ContinuousCollision(std::pmr::memory_resource& scratch)
    : movers_(&scratch),
      mover_of_body_(&scratch),
      pairs_(&scratch),
      sensor_pairs_(&scratch),
      impacts_(&scratch),
      changed_(&scratch),
      near_(&scratch),
      crossings_(&scratch)
{
}

void ContinuousCollision::run(std::span<const FastBody> fast, BodyStore& bodies, ShapeStore& shapes, const JointStore& joints,
                              const ContactStore& contacts, const ContactRules& rules, BroadPhase& broad_phase, float dt, float way_ahead)
{
    if (fast.empty()) return;
    mover_of_body_.resize(bodies.records.size(), null_index);
    for (const FastBody& body : fast)
    {
        mover_of_body_[body.body] = static_cast<std::uint32_t>(movers_.size());
        movers_.push_back({.body = body.body,
                           .sweep = body.sweep,
                           .start = body.sweep.at(0),
                           .can_stop = bodies.is_dynamic(body.body),
                           .is_held = bodies.records[body.body].first_joint != null_index,
                           .is_bullet = bodies.records[body.body].is_bullet,
                           .is_fast = true});
    }

    const Surroundings near = {bodies, shapes, joints, contacts, rules, dt};
    find_candidates(near, broad_phase);
    for (std::uint32_t pair = 0; pair < pairs_.size(); ++pair) seek_impact(pair, 0, near);
    resolve_impacts(near, broad_phase);
    place_bodies(bodies, shapes, broad_phase, way_ahead);
    find_crossings(bodies, shapes);
}

void ContinuousCollision::find_candidates(const Surroundings& near, BroadPhase& broad_phase)
{
    const auto count = static_cast<std::uint32_t>(movers_.size());
    for (std::uint32_t mover = 0; mover < count; ++mover)
    {
        std::uint32_t shape = near.bodies.records[movers_[mover].body].first_shape;
        for (; shape != null_index; shape = near.shapes.records[shape].next_of_body)
        {
            Collector collector(near_);
            broad_phase.query(near.shapes.bounds[shape].fat, collector);
            std::sort(near_.begin(), near_.end()); // the broad phase does not show
            for (const ProxyIndex other : near_)
            {
                const std::uint32_t other_mover = mover_of_body_[near.shapes.records[other].body];
                const bool finds_this_one = other_mover != null_index && movers_[other_mover].is_fast && other < shape;
                if (!finds_this_one) add_candidate(mover, shape, other, near);
            }
        }
    }
}

/// Whether a pair that its filters allow to meet does not do so now.
bool ContinuousCollision::may_pass(Pair& pair, const Surroundings& near) const
{
    if (pair.passing == Pair::Passing::Unknown)
    {
        const Mover& mover = movers_[pair.mover_a];
        const Contact* contact = find_contact(near.bodies, near.contacts, mover.body, pair.shape_a, pair.shape_b);
        const auto id_of = [&](std::uint32_t s) { return ShapeId{s, near.shapes.slots.generation(s), near.rules.world}; };
        const auto hook_says_no = [&]
        {
            if (contact || near.rules.hooks == nullptr) return false;
            return !near.rules.hooks->should_collide(id_of(std::min(pair.shape_a, pair.shape_b)),
                                                     id_of(std::max(pair.shape_a, pair.shape_b)));
        };
        const Transform& start_b =
            pair.mover_b == null_index ? near.bodies.poses[near.shapes.records[pair.shape_b].body].transform : movers_[pair.mover_b].start;
        const bool passes = (contact && (contact->is_passing || contact->is_disabled)) || hook_says_no() ||
                            comes_from_behind(near.shapes, pair.shape_a, pair.shape_b, relative(mover.start, start_b));
        pair.passing = passes ? Pair::Passing::Yes : Pair::Passing::No;
    }
    return pair.passing == Pair::Passing::Yes;
}

void ContinuousCollision::add_candidate(std::uint32_t mover, std::uint32_t shape, std::uint32_t other, const Surroundings& near)
{
    const std::uint32_t body = near.shapes.records[other].body;
    const PairVerdict verdict = judge_pair(near.shapes, near.bodies, near.joints, {std::min(shape, other), std::max(shape, other)});
    if (!verdict.makes_contact) return;
    if (!verdict.is_sensor && are_parts_of_one(near.bodies, near.shapes.records[shape].body, body)) return;
    std::uint32_t other_mover = mover_of_body_[body];
    if (other_mover == mover) return;
    // The core of A must not go into B. Of two fast bodies A is the thinner one, whichever was created first.
    const bool are_both_fast = other_mover != null_index && movers_[other_mover].is_fast;
    if (are_both_fast && goes_first(near.shapes, other, movers_[other_mover].sweep, shape, movers_[mover].sweep))
    {
        std::swap(mover, other_mover);
        std::swap(shape, other);
    }
    if (verdict.is_sensor)
    {
        sensor_pairs_.push_back({mover, other_mover, shape, other});
        return;
    }
    const bool is_free = near.bodies.is_dynamic(body) && near.bodies.records[body].first_joint == null_index;
    if (other_mover == null_index && (!movers_[mover].can_stop || (movers_[mover].is_held && is_free)))
        other_mover = mover_of(body, near); // it runs into one that hardly moves
    add_pair({mover, other_mover, shape, other});
}

/// The mover of a body, made if it was slow so far.
std::uint32_t ContinuousCollision::mover_of(std::uint32_t body, const Surroundings& near)
{
    std::uint32_t& mover = mover_of_body_[body];
    if (mover != null_index) return mover;
    mover = static_cast<std::uint32_t>(movers_.size());
    const Sweep sweep = slow_way(near.bodies, body, near.dt);
    const BodyRecord& record = near.bodies.records[body];
    movers_.push_back({.body = body,
                       .sweep = sweep,
                       .start = sweep.at(0),
                       .can_stop = true,
                       .is_held = record.first_joint != null_index,
                       .is_bullet = record.is_bullet,
                       .is_fast = false});
    return mover;
}

void ContinuousCollision::add_pair(const Pair& pair)
{
    const auto index = static_cast<std::uint32_t>(pairs_.size());
    Pair& added = pairs_.emplace_back(pair);
    added.next_of_a = std::exchange(movers_[pair.mover_a].first_pair, index);
    if (pair.mover_b != null_index) added.next_of_b = std::exchange(movers_[pair.mover_b].first_pair, index);
}

std::uint32_t ContinuousCollision::next_pair(std::uint32_t pair, std::uint32_t mover) const
{
    return pairs_[pair].mover_a == mover ? pairs_[pair].next_of_a : pairs_[pair].next_of_b;
}

bool ContinuousCollision::has_pair(std::uint32_t mover, std::uint32_t shape, std::uint32_t other) const
{
    for (std::uint32_t p = movers_[mover].first_pair; p != null_index; p = next_pair(p, mover))
    {
        const Pair& pair = pairs_[p];
        if ((pair.shape_a == shape && pair.shape_b == other) || (pair.shape_a == other && pair.shape_b == shape)) return true;
    }
    return false;
}

Sweep ContinuousCollision::rest_of_way(std::uint32_t mover, std::uint32_t shape, float after, const BodyStore& bodies,
                                       const ShapeStore& shapes) const
{
    return mover == null_index ? at_rest(bodies.poses[shapes.records[shape].body]) : way_left(mover, after);
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
void ContinuousCollision::seek_impact(std::uint32_t index, float after, const Surroundings& near)
{
    const Tolerances& tolerances = near.shapes.tolerances;
    Pair& pair = pairs_[index];
    if (after >= 1 || (!can_be_stopped(pair.mover_a) && !can_be_stopped(pair.mover_b))) return;

    std::uint32_t shape = pair.shape_a;
    std::uint32_t other = pair.shape_b;
    Sweep way_a = rest_of_way(pair.mover_a, pair.shape_a, after, near.bodies, near.shapes);
    Sweep way_b = rest_of_way(pair.mover_b, pair.shape_b, after, near.bodies, near.shapes);
    float thickness = near.shapes.extents[shape].inner;
    float other_thickness = near.shapes.extents[other].inner;
    const float thinner = other_thickness > 0 ? std::min(thickness, other_thickness) : thickness;
    const auto is_dynamic = [&](std::uint32_t s) { return near.bodies.is_dynamic(near.shapes.records[s].body); };
    const auto is_held = [&](std::uint32_t s) { return near.bodies.records[near.shapes.records[s].body].first_joint != null_index; };
    const bool are_held = is_held(pair.shape_a) && is_held(pair.shape_b);
    const bool has_bullet = movers_[pair.mover_a].is_bullet || (pair.mover_b != null_index && movers_[pair.mover_b].is_bullet);
    const float least_way = has_bullet ? 0 : fast_way(thinner, tolerances);
    const bool are_dynamic = is_dynamic(pair.shape_a) && is_dynamic(pair.shape_b);
    const bool are_crowded = !has_bullet && !are_held && length(center_way(way_a) - center_way(way_b)) < crowded_way * thinner;
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
    const float apart = tolerances.impact_distance + tolerances.linear_slop; // well above the rounding of either answer
    if (stays_apart(core_of(geometry, first_share * thickness), way_a, points_b, way_b, apart)) return;
    // What overlaps already is a matter for the contact; but what the contact does not hold must still not come out on the other side.
    std::optional<float> inside;
    for (const float share : {first_share, 0.5f, 0.75f, 0.95f})
    {
        inside = time_of_impact(core_of(geometry, share * thickness), way_a, points_b, way_b, tolerances.impact_distance, tolerances);
        if (!inside || *inside > 0) break;
    }
    if (!inside || *inside <= 0 || may_pass(pair, near)) return;
    const std::optional<float> touch =
        time_of_impact(convex_points(geometry), way_a, points_b, way_b, tolerances.impact_distance, tolerances);
    const float time = after + (1 - after) * (touch && *touch > 0 ? *touch : *inside);
    impacts_.push_back({time, index, version_of(pair)});
    std::push_heap(impacts_.begin(), impacts_.end(), std::greater<>());
}

void ContinuousCollision::resolve_impacts(const Surroundings& near, BroadPhase& broad_phase)
{
    while (!impacts_.empty())
    {
        std::pop_heap(impacts_.begin(), impacts_.end(), std::greater<>());
        const Impact impact = impacts_.back();
        impacts_.pop_back();
        const Pair pair = pairs_[impact.pair];
        if (impact.version != version_of(pair)) continue; // one of them has met another since, and the pair was judged anew
        changed_.clear();
        meet(pair, impact.time, near, broad_phase);
        for (const std::uint32_t mover : changed_)
            for (std::uint32_t p = movers_[mover].first_pair; p != null_index; p = next_pair(p, mover))
                if (p != impact.pair) seek_impact(p, impact.time, near);
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
        std::uint32_t edge = near.bodies.records[movers_[changed_[i]].body].first_joint;
        for (; edge != null_index; edge = near.joints.joints[edge / 2].next[edge % 2])
        {
            const Joint& joint = near.joints.joints[edge / 2];
            const std::uint32_t other = edge % 2 == 0 ? joint.body_b : joint.body_a;
            if (other == null_index || !near.bodies.is_dynamic(other) || near.bodies.motion_index[other] == 0) continue;
            const std::uint32_t mover = mover_of(other, near);
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
    for (std::uint32_t shape = near.bodies.records[movers_[index].body].first_shape; shape != null_index;
         shape = near.shapes.records[shape].next_of_body)
    {
        const SweptPath path = path_of(near.shapes.extents[shape], way);
        const Aabb middle = merge(Aabb{path.from, path.from}, Aabb{path.from + path.way, path.from + path.way});
        Collector collector(near_);
        broad_phase.query(expanded(middle, path.reach), collector);
        std::sort(near_.begin(), near_.end());
        for (const ProxyIndex other : near_)
            if (!has_pair(index, shape, other)) add_candidate(index, shape, other, near);
    }
}

void ContinuousCollision::place_bodies(BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float way_ahead)
{
    for (const Mover& mover : movers_)
    {
        // At the ends of float a way has no middle: then the body stays where the step took it.
        const Transform end = mover.sweep.at(1);
        // One that was carried may have come out of the world: then too.
        const bool is_sound = is_in_world(end.p) && is_in_world(mover.sweep.center_end) && is_finite(Vec2{end.q.c, end.q.s});
        if (mover.version > 0 && is_sound)
        {
            BodyPose& pose = bodies.poses[mover.body];
            bodies.watches[bodies.motion_index[mover.body]].set_back = pose.center - mover.sweep.center_end;
            pose.transform = end;
            pose.transform.q = normalize(pose.transform.q);
            pose.center = mover.sweep.center_end;
        }
        const Vec2 ahead = way_ahead * bodies.velocity(mover.body);
        for (std::uint32_t s = bodies.records[mover.body].first_shape; s != null_index; s = shapes.records[s].next_of_body)
        {
            ShapeBounds& bounds = shapes.bounds[s];
            bounds.tight = bounds_of(shapes.geometry[s], bodies.poses[mover.body].transform);
            bounds.fat = fattened(bounds.tight, ahead, shapes.tolerances.max_bounds_margin);
            broad_phase.update(s, bounds.fat);
            shapes.mark_moved(s);
        }
    }
}

void ContinuousCollision::find_crossings(const BodyStore& bodies, const ShapeStore& shapes)
{
    const Tolerances& tolerances = shapes.tolerances;
    for (const Pair& pair : sensor_pairs_)
    {
        const Geometry& a = shapes.geometry[pair.shape_a];
        const Geometry& b = shapes.geometry[pair.shape_b];
        const BodyPose& pose_b = bodies.poses[shapes.records[pair.shape_b].body];
        const Transform start_b = pair.mover_b == null_index ? pose_b.transform : movers_[pair.mover_b].start;
        const BodyPose& pose_a = bodies.poses[shapes.records[pair.shape_a].body];
        const Transform& start_a = movers_[pair.mover_a].start;
        const bool starts_in = overlap(a, b, relative(start_a, start_b), tolerances);
        if (starts_in || overlap(a, b, relative(pose_a.transform, pose_b.transform), tolerances)) continue;

        const auto whole_way = [](const BodyPose& pose, const Transform& start)
        { return Sweep{pose.local_center, start * pose.local_center, pose.center, start.q, angle(relative(start.q, pose.transform.q))}; };
        const Sweep way_a = whole_way(pose_a, start_a);
        const Sweep way_b = whole_way(pose_b, start_b);
        const float touch = tolerances.crossing_distance;
        const std::optional<float> time = time_of_impact(convex_points(a), way_a, convex_points(b), way_b, touch, tolerances);
        if (!time) continue;
        // From just outside, it goes through when its core does.
        const bool is_through = *time > 0 || time_of_impact(core_of(a, sliding_share * shapes.extents[pair.shape_a].inner), way_a,
                                                            convex_points(b), way_b, touch, tolerances);
        if (is_through) crossings_.push_back({std::min(pair.shape_a, pair.shape_b), std::max(pair.shape_a, pair.shape_b)});
    }
    std::sort(crossings_.begin(), crossings_.end());
    crossings_.erase(std::unique(crossings_.begin(), crossings_.end()), crossings_.end()); // one that was carried was looked at twice
}

} // namespace carom::detail
