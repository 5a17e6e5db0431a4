// Finds and orders the impacts of fast bodies.
#include "solver/continuous.hpp"

#include "dynamics/find_pairs.hpp"
#include "dynamics/one_sided.hpp"
#include "geometry/extent.hpp"
#include "geometry/manifold.hpp"
#include "memory/make_room.hpp"

#include <algorithm>

namespace carom::detail
{

namespace
{

/// How near two shapes are when they count as touching [m]. The contact solver takes over well before.
constexpr float impact_distance = 0.5f * linear_slop;

/// A shape that goes into another no deeper than this share of its inner radius has not begun to pass through: it slides along it, over tiles and
/// seams. Tests: continuous_test, terrain_test. Against what can give way, less, since a grazing blow is a blow.
constexpr float sliding_share = 0.25f;
constexpr float grazing_share = 0.05f;

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

} // namespace

ContinuousCollision::ContinuousCollision(std::pmr::memory_resource& memory)
    : movers_(&memory),
      mover_of_body_(&memory),
      pairs_(&memory),
      pairs_of_mover_(&memory),
      sensor_pairs_(&memory),
      impacts_(&memory),
      near_(&memory),
      crossings_(&memory)
{
}

void ContinuousCollision::make_room_for(std::size_t bodies)
{
    constexpr std::size_t few = 32;
    make_room(mover_of_body_, bodies);
    make_room(movers_, few);
    make_room(pairs_, 4 * few);
    make_room(pairs_of_mover_, 8 * few);
    make_room(sensor_pairs_, few);
    make_room(impacts_, 4 * few);
    make_room(near_, 4 * few);
    make_room(crossings_, few);
}

void ContinuousCollision::run(std::span<const FastBody> fast, BodyStore& bodies, ShapeStore& shapes, const JointStore& joints,
                              const ContactStore& contacts, const ContactRules& rules, BroadPhase& broad_phase, float dt, float way_ahead)
{
    crossings_.clear();
    if (fast.empty()) return;
    movers_.clear();
    pairs_.clear();
    sensor_pairs_.clear();
    impacts_.clear();
    mover_of_body_.resize(bodies.records.size(), null_index);
    for (const FastBody& body : fast)
    {
        mover_of_body_[body.body] = static_cast<std::uint32_t>(movers_.size());
        movers_.push_back({.body = body.body,
                           .sweep = body.sweep,
                           .start = body.sweep.at(0),
                           .can_stop = bodies.is_dynamic(body.body),
                           .is_held = bodies.records[body.body].first_joint != null_index,
                           .is_fast = true});
    }

    find_candidates({bodies, shapes, joints, contacts, rules, dt}, broad_phase);
    list_pairs_of_movers();
    for (std::uint32_t pair = 0; pair < pairs_.size(); ++pair) seek_impact(pair, 0, bodies, shapes);
    resolve_impacts(bodies, shapes);
    place_bodies(bodies, shapes, broad_phase, way_ahead);
    find_crossings(bodies, shapes);
    for (const Mover& mover : movers_) mover_of_body_[mover.body] = null_index;
    keep_headroom(movers_);
    keep_headroom(pairs_);
    keep_headroom(pairs_of_mover_);
    keep_headroom(sensor_pairs_);
    keep_headroom(impacts_);
    keep_headroom(near_);
    keep_headroom(crossings_);
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
            for (const ProxyIndex other : near_) add_candidate(mover, shape, other, near);
        }
    }
}

/// Whether a pair that its filters allow to meet does not do so now.
bool ContinuousCollision::may_pass(std::uint32_t mover, std::uint32_t shape, std::uint32_t other, const Surroundings& near) const
{
    const Contact* contact = find_contact(near.bodies, near.contacts, movers_[mover].body, shape, other);
    if (contact && (contact->is_passing || contact->is_disabled)) return true;
    if (!contact && near.rules.hooks != nullptr)
    {
        const auto id_of = [&](std::uint32_t s) { return ShapeId{s, near.shapes.slots.generation(s), near.rules.world}; };
        if (!near.rules.hooks->should_collide(id_of(std::min(shape, other)), id_of(std::max(shape, other)))) return true;
    }
    const std::uint32_t body = near.shapes.records[other].body;
    const std::uint32_t other_mover = mover_of_body_[body];
    const Transform other_start = other_mover == null_index ? near.bodies.poses[body].transform : movers_[other_mover].start;
    return comes_from_behind(near.shapes, shape, other, relative(movers_[mover].start, other_start));
}

void ContinuousCollision::add_candidate(std::uint32_t mover, std::uint32_t shape, std::uint32_t other, const Surroundings& near)
{
    const std::uint32_t body = near.shapes.records[other].body;
    const PairVerdict verdict = judge_pair(near.shapes, near.bodies, near.joints, {std::min(shape, other), std::max(shape, other)});
    if (!verdict.makes_contact) return;
    if (!verdict.is_sensor && are_parts_of_one(near.bodies, near.shapes.records[shape].body, body)) return;
    std::uint32_t other_mover = mover_of_body_[body];
    if (other_mover != null_index && movers_[other_mover].is_fast && other < shape) return; // it finds this one
    if (verdict.is_sensor)
    {
        sensor_pairs_.push_back({mover, other_mover, shape, other});
        return;
    }
    if (may_pass(mover, shape, other, near)) return;
    const bool is_free = near.bodies.is_dynamic(body) && near.bodies.records[body].first_joint == null_index;
    if (other_mover == null_index && (!movers_[mover].can_stop || (movers_[mover].is_held && is_free)))
    {
        // It runs into one that hardly moves.
        other_mover = mover_of_body_[body] = static_cast<std::uint32_t>(movers_.size());
        const Sweep sweep = slow_way(near.bodies, body, near.dt);
        movers_.push_back({.body = body, .sweep = sweep, .start = sweep.at(0), .can_stop = true, .is_held = !is_free, .is_fast = false});
    }
    pairs_.push_back({mover, other_mover, shape, other});
}

/// For each mover the pairs that it is in, counted first and then filled in.
void ContinuousCollision::list_pairs_of_movers()
{
    for (Mover& mover : movers_) mover.end_pair = 0;
    for (const Pair& pair : pairs_)
    {
        ++movers_[pair.mover_a].end_pair;
        if (pair.mover_b != null_index) ++movers_[pair.mover_b].end_pair;
    }
    std::uint32_t sum = 0;
    for (Mover& mover : movers_)
    {
        const std::uint32_t count = mover.end_pair;
        mover.first_pair = mover.end_pair = sum;
        sum += count;
    }
    pairs_of_mover_.resize(sum);
    for (std::uint32_t i = 0; i < pairs_.size(); ++i)
    {
        pairs_of_mover_[movers_[pairs_[i].mover_a].end_pair++] = i;
        if (pairs_[i].mover_b != null_index) pairs_of_mover_[movers_[pairs_[i].mover_b].end_pair++] = i;
    }
}

Sweep ContinuousCollision::rest_of_way(std::uint32_t mover, std::uint32_t shape, float after, const BodyStore& bodies,
                                       const ShapeStore& shapes) const
{
    if (mover == null_index) return at_rest(bodies.poses[shapes.records[shape].body]);
    const Mover& m = movers_[mover];
    return m.since < 1 ? rest(m.sweep, (after - m.since) / (1 - m.since)) : rest(m.sweep, 1);
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
void ContinuousCollision::seek_impact(std::uint32_t index, float after, const BodyStore& bodies, const ShapeStore& shapes)
{
    const Pair& pair = pairs_[index];
    if (after >= 1 || (!can_be_stopped(pair.mover_a) && !can_be_stopped(pair.mover_b))) return;

    const Geometry& geometry = shapes.geometry[pair.shape_a];
    const bool gives_way = bodies.is_dynamic(shapes.records[pair.shape_a].body) && bodies.is_dynamic(shapes.records[pair.shape_b].body);
    const ConvexPoints other = convex_points(shapes.geometry[pair.shape_b]);
    const Sweep way_a = rest_of_way(pair.mover_a, pair.shape_a, after, bodies, shapes);
    const Sweep way_b = rest_of_way(pair.mover_b, pair.shape_b, after, bodies, shapes);
    // What overlaps already is a matter for the contact; but what the contact does not hold must still not come out on the other side.
    std::optional<float> inside;
    for (const float share : {gives_way ? grazing_share : sliding_share, 0.5f, 0.75f, 0.95f})
    {
        inside = time_of_impact(core_of(geometry, share * inner_radius(geometry)), way_a, other, way_b, impact_distance);
        if (!inside || *inside > 0) break;
    }
    if (!inside || *inside <= 0) return;
    const std::optional<float> touch = time_of_impact(convex_points(geometry), way_a, other, way_b, impact_distance);
    const float time = after + (1 - after) * (touch && *touch > 0 ? *touch : *inside);
    impacts_.push_back({time, index, version_of(pair)});
    const auto comes_later = [](const Impact& l, const Impact& r) { return l.time != r.time ? l.time > r.time : l.pair > r.pair; };
    std::push_heap(impacts_.begin(), impacts_.end(), comes_later);
}

void ContinuousCollision::resolve_impacts(const BodyStore& bodies, const ShapeStore& shapes)
{
    const auto comes_later = [](const Impact& l, const Impact& r) { return l.time != r.time ? l.time > r.time : l.pair > r.pair; };
    while (!impacts_.empty())
    {
        std::pop_heap(impacts_.begin(), impacts_.end(), comes_later);
        const Impact impact = impacts_.back();
        impacts_.pop_back();
        const Pair pair = pairs_[impact.pair];
        if (impact.version != version_of(pair)) continue; // one of them has been stopped since, and the pair was judged anew
        const bool a_goes_on = !can_be_stopped(pair.mover_a) || carries(pair.mover_a, pair.mover_b);
        const bool b_goes_on = !can_be_stopped(pair.mover_b) || carries(pair.mover_b, pair.mover_a);
        if (!a_goes_on) stop(pair.mover_a, impact.time, pair.mover_b);
        if (!b_goes_on) stop(pair.mover_b, impact.time, pair.mover_a);
        for (const std::uint32_t mover : {pair.mover_a, pair.mover_b})
        {
            if (mover == null_index) continue;
            for (std::uint32_t p = movers_[mover].first_pair; p < movers_[mover].end_pair; ++p)
                if (pairs_of_mover_[p] != impact.pair) seek_impact(pairs_of_mover_[p], impact.time, bodies, shapes);
        }
    }
}

/// Stands still from a time on; or, when it was met by one that goes on, goes on with that.
void ContinuousCollision::stop(std::uint32_t index, float time, std::uint32_t by)
{
    Mover& mover = movers_[index];
    const auto part_of = [time](const Mover& m) { return m.since < 1 ? (time - m.since) / (1 - m.since) : 1.0f; };
    const bool was_carried = mover.version > 0;
    const Sweep left = rest(mover.sweep, part_of(mover));
    mover.sweep = {left.local_center, left.center_start, left.center_start, left.q_start, 0};
    mover.since = time;
    ++mover.version;
    const bool is_carried = carries(by, index) && !was_carried;
    mover.is_stopped = !is_carried;
    if (!is_carried) return;
    const Sweep carrier = rest(movers_[by].sweep, part_of(movers_[by]));
    const Transform from = carrier.at(0);
    const Transform to = carrier.at(1);
    mover.sweep.center_end = to * inverse_transform(from, left.center_start);
    mover.sweep.turn = carrier.turn;
}

void ContinuousCollision::place_bodies(BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float way_ahead)
{
    for (const Mover& mover : movers_)
    {
        // At the ends of float a way has no middle: then the body stays where the step took it.
        const Transform end = mover.sweep.at(1);
        const bool is_sound = is_finite(end.p) && is_finite(mover.sweep.center_end) && is_finite(Vec2{end.q.c, end.q.s});
        if (mover.version > 0 && is_sound)
        {
            BodyPose& pose = bodies.poses[mover.body];
            pose.transform = end;
            pose.transform.q = normalize(pose.transform.q);
            pose.center = mover.sweep.center_end;
        }
        const Vec2 ahead = way_ahead * bodies.velocity(mover.body);
        for (std::uint32_t s = bodies.records[mover.body].first_shape; s != null_index; s = shapes.records[s].next_of_body)
        {
            ShapeBounds& bounds = shapes.bounds[s];
            bounds.tight = aabb_of(shapes.geometry[s], bodies.poses[mover.body].transform);
            bounds.fat = fattened(bounds.tight, ahead);
            broad_phase.update(s, bounds.fat);
            shapes.mark_moved(s);
        }
    }
}

void ContinuousCollision::find_crossings(const BodyStore& bodies, const ShapeStore& shapes)
{
    for (const Pair& pair : sensor_pairs_)
    {
        const Geometry& a = shapes.geometry[pair.shape_a];
        const Geometry& b = shapes.geometry[pair.shape_b];
        const BodyPose& pose_b = bodies.poses[shapes.records[pair.shape_b].body];
        const Transform start_b = pair.mover_b == null_index ? pose_b.transform : movers_[pair.mover_b].start;
        const BodyPose& pose_a = bodies.poses[shapes.records[pair.shape_a].body];
        const Transform& start_a = movers_[pair.mover_a].start;
        if (overlap(a, b, relative(start_a, start_b)) || overlap(a, b, relative(pose_a.transform, pose_b.transform))) continue;

        const auto whole_way = [](const BodyPose& pose, const Transform& start)
        { return Sweep{pose.local_center, start * pose.local_center, pose.center, start.q, angle(relative(start.q, pose.transform.q))}; };
        const Sweep way_a = whole_way(pose_a, start_a);
        const Sweep way_b = whole_way(pose_b, start_b);
        constexpr float touch = 5e-4f; // [m]
        const std::optional<float> time = time_of_impact(convex_points(a), way_a, convex_points(b), way_b, touch);
        if (!time) continue;
        // From just outside, it goes through when its core does.
        const bool is_through =
            *time > 0 || time_of_impact(core_of(a, sliding_share * inner_radius(a)), way_a, convex_points(b), way_b, touch);
        if (is_through) crossings_.push_back({std::min(pair.shape_a, pair.shape_b), std::max(pair.shape_a, pair.shape_b)});
    }
    std::sort(crossings_.begin(), crossings_.end());
}

} // namespace carom::detail
