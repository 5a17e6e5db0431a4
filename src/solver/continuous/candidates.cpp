// Which shapes may meet on their ways. Each pair of near shapes of which one is fast is a candidate, and comparisons of numbers that lie side by side
// tell most of them apart; filters, joints and exact ways are looked at last.
//
// A shape that is still within the fat bounds of the last search for pairs is near only those that it has contacts with. So candidates are the contacts,
// and for shapes that have left these bounds a search of the broad phase. Pairs that come to nothing are not kept: when the way of a body
// changes, its pairs are looked up again.
#include "solver/continuous/continuous.hpp"
#include "solver/continuous/stays_apart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <variant>

namespace carom::detail
{

namespace
{

/// Looking at so many contacts takes as long as searching the broad phase for one shape.
constexpr std::size_t contacts_of_a_search = 256;

/// Sums that are taken in another order may come out smaller by less.
constexpr float rounding_share = 0.9999f;

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

Vec2 center_way(const Sweep& way) { return way.center_end - way.center_start; }

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

} // namespace

/// Takes the candidates out of the pairs that a search finds, and drops the pairs.
class ContinuousCollision::NearFast final : public PairFilter
{
public:
    NearFast(ContinuousCollision& collision, const Surroundings& near) : collision_(collision), near_(near) {}

    void filter(std::pmr::vector<ProxyPair>& pairs, std::size_t first) override
    {
        for (std::size_t i = first; i < pairs.size(); ++i) collision_.consider(pairs[i].a, pairs[i].b, near_);
        pairs.resize(first);
    }

private:
    ContinuousCollision& collision_;
    const Surroundings& near_;
};

/// By contacts and a search for what has strayed, or by a search for all that is fast: whichever is less work. Both find the same.
void ContinuousCollision::find_candidates(std::span<const std::uint32_t> strayed, const Surroundings& near, BroadPhase& broad_phase)
{
    if (ways_.size() <= strayed.size() + near.contacts.awake.size() / contacts_of_a_search)
    {
        std::pmr::vector<std::uint32_t> fast_shapes(ways_.get_allocator());
        fast_shapes.reserve(ways_.size());
        for (const ShapeWay& way : ways_) fast_shapes.push_back(way.shape);
        search(fast_shapes, near, broad_phase);
    }
    else
    {
        walk_contacts(strayed, near);
        search(strayed, near, broad_phase);
    }
}

void ContinuousCollision::search(std::span<const std::uint32_t> moved, const Surroundings& near, BroadPhase& broad_phase)
{
    if (moved.empty()) return;
    std::pmr::vector<ProxyPair> found(ways_.get_allocator());
    NearFast filter(*this, near);
    PairList list(found, filter, std::numeric_limits<std::size_t>::max());
    broad_phase.find_more_pairs(moved, list);
    list.finish();
}

/// The contacts of fast shapes where neither shape has strayed.
void ContinuousCollision::walk_contacts(std::span<const std::uint32_t> strayed, const Surroundings& near)
{
    constexpr std::uint8_t is_fast = 1;
    constexpr std::uint8_t has_strayed = 2;
    std::pmr::vector<std::uint8_t> marks(near.shapes.records.size(), 0, ways_.get_allocator());
    for (const ShapeWay& way : ways_) marks[way.shape] = is_fast;
    for (const std::uint32_t shape : strayed) marks[shape] |= has_strayed;
    for (const AwakePair& pair : near.contacts.awake_pairs) // all contacts of active bodies are among them
        if ((marks[pair.shape_a] | marks[pair.shape_b]) == is_fast) consider(pair.shape_a, pair.shape_b, near);
}

/// Makes a candidate of two shapes that may meet. But for what moves along, only what would come to nothing is held back: seek_impact asks two that are
/// fast for the same with less reach and a larger way, and takes what is slow and nobody's to carry along for a thing that stands still.
void ContinuousCollision::consider(std::uint32_t a, std::uint32_t b, const Surroundings& near)
{
    const std::uint32_t place_a = way_of_shape_[a];
    const std::uint32_t place_b = way_of_shape_[b];
    if (place_a != null_index && place_b != null_index)
    {
        const ShapeWay& way_a = ways_[place_a];
        const ShapeWay& way_b = ways_[place_b];
        if (way_a.mover == way_b.mover) return;
        const bool is_sensor = way_a.is_sensor | way_b.is_sensor;
        const float least_way = rounding_share * std::min(way_a.least_way, way_b.least_way);
        if (!is_sensor && moves_less(way_a.path, way_b.path, least_way)) return;
        if (!overlaps(way_a.bounds, way_b.bounds)) return;
        if (!is_sensor && !come_near(way_a.path, way_b.path, 0, near.shapes.tolerances.linear_slop)) return;
        candidates_.push_back(a < b ? Candidate{place_a, b} : Candidate{place_b, a});
        return;
    }
    if (place_a == null_index && place_b == null_index) return;
    const std::uint32_t place = place_a != null_index ? place_a : place_b;
    const std::uint32_t other = place_a != null_index ? b : a;
    const ShapeWay& way = ways_[place];
    const ShapeBounds& bounds = near.shapes.bounds[other];
    if (!overlaps(way.bounds, has_carriers_ ? bounds.fat : bounds.tight) || moves_along(way, other, near)) return;
    candidates_.push_back({place, other});
}

/// Whether a fast shape A moves no farther, as seen from a slow one B, than what their contact can take back. Seen from B, a point u of A moves by
///   d_a + T_a x (u - c_a) - d_b - T_b x (u - c_b) = D + (T_a - T_b) x (u - m)
/// with D at the middle m of A. What rides in a drum hardly moves against its wall.
bool ContinuousCollision::moves_along(const ShapeWay& way, std::uint32_t other, const Surroundings& near) const
{
    const ShapeRecord& record = near.shapes.records[other];
    if (way.is_sensor || record.is_sensor) return false;
    const Sweep& sweep = movers_[way.mover].whole_way;
    const Displacement& slow = near.displacements[near.bodies.motion_index[record.body]];
    const Vec2 slow_center = near.bodies.poses[record.body].center - slow.center;
    const Vec2 middle_way =
        way.path.way + cross(sweep.turn, way.path.from - sweep.center_start) - slow.center - cross(slow.turn, way.path.from - slow_center);
    const float inner = near.shapes.extents[other].inner;
    const float least_way = inner > 0 ? std::min(way.least_way, fast_way(inner, near.shapes.tolerances)) : way.least_way;
    const float left = least_way - std::abs(sweep.turn - slow.turn) * way.path.reach;
    return left > 0 && length_squared(middle_way) <= left * left;
}

ContinuousCollision::PairKey ContinuousCollision::key_of(std::uint32_t way, std::uint32_t other) const
{
    return PairKey{way} << 32 | other;
}

/// The way that decides which of two fast shapes is A: that does not change with impacts.
const Sweep& ContinuousCollision::way_for_order(std::uint32_t mover, PairKey key) const
{
    return key < first_late_key ? movers_[mover].whole_way : movers_[mover].sweep;
}

/// A pair of shapes of different bodies, of which it is not known whether they may meet at all.
ContinuousCollision::Pair ContinuousCollision::pair_of(std::uint32_t mover, std::uint32_t shape, std::uint32_t other, PairKey key,
                                                       const Surroundings& near) const
{
    const std::uint32_t way = way_of_shape_[other];
    const bool is_other_fast = way != null_index;
    std::uint32_t other_mover = is_other_fast ? ways_[way].mover : mover_of_body_[near.shapes.records[other].body];
    if (other_mover != null_index && !is_other_fast && key < movers_[other_mover].made_for) other_mover = null_index;
    // The core of A must not go into B. Of two fast bodies A is the thinner one, whichever was created first.
    if (is_other_fast && goes_first(near.shapes, other, way_for_order(other_mover, key), shape, way_for_order(mover, key)))
    {
        std::swap(mover, other_mover);
        std::swap(shape, other);
    }
    return {mover, other_mover, shape, other, key};
}

/// Whether filters, types and joints let the two meet.
PairVerdict ContinuousCollision::judge(const Pair& pair, const Surroundings& near) const
{
    const auto [first, second] = std::minmax(pair.shape_a, pair.shape_b);
    const PairVerdict verdict = judge_pair(near.shapes, near.bodies, near.joints, {first, second});
    if (!verdict.makes_contact || verdict.is_sensor) return verdict;
    const std::uint32_t body_a = near.shapes.records[pair.shape_a].body;
    const std::uint32_t body_b = near.shapes.records[pair.shape_b].body;
    return {.makes_contact = !are_parts_of_one(near.bodies, body_a, body_b), .is_sensor = false};
}

/// Whether A goes on when it meets B, which hardly moves: then B must have a way that can change.
bool ContinuousCollision::runs_into(const Pair& pair, const Surroundings& near) const
{
    if (pair.mover_b != null_index) return false;
    const std::uint32_t body = near.shapes.records[pair.shape_b].body;
    const bool is_free = near.bodies.is_dynamic(body) && near.bodies.records[body].first_joint == null_index;
    return !movers_[pair.mover_a].can_stop || (movers_[pair.mover_a].is_held && is_free);
}

/// Makes movers of the slow bodies that a kinematic body, or one that joints hold, may run into.
void ContinuousCollision::find_carried(const Surroundings& near)
{
    for (const Candidate& candidate : candidates_)
    {
        const ShapeWay& way = ways_[candidate.way];
        if (way_of_shape_[candidate.other] != null_index) continue;
        if (movers_[way.mover].can_stop && !movers_[way.mover].is_held) continue;
        const PairKey key = key_of(candidate.way, candidate.other);
        const Pair pair = pair_of(way.mover, way.shape, candidate.other, key, near);
        if (!runs_into(pair, near)) continue;
        const PairVerdict verdict = judge(pair, near);
        if (!verdict.makes_contact || verdict.is_sensor) continue;
        Mover& other = movers_[mover_of(near.shapes.records[candidate.other].body, key, near)];
        other.made_for = std::min(other.made_for, key);
    }
}

/// Of a shape that is fast and one that is not: what `consider` asks of two that are fast.
bool ContinuousCollision::may_meet(const ShapeWay& way, const Pair& pair, const Surroundings& near) const
{
    const ShapeStore& shapes = near.shapes;
    const Extent& extent = shapes.extents[pair.shape_b];
    const bool is_bullet = pair.mover_b != null_index && movers_[pair.mover_b].is_bullet;
    const float least_way = is_bullet ? 0 : rounding_share * std::min(way.least_way, fast_way(extent.inner, shapes.tolerances));
    const SweptPath path = path_of(extent, rest_of_way(pair.mover_b, pair.shape_b, 0, near));
    if (!may_pass_through(way.path, path, least_way, 0, shapes.tolerances.linear_slop)) return false;
    // The disc around a wall holds much that is nowhere near it.
    const auto* polygon = std::get_if<Polygon>(&shapes.geometry[pair.shape_b]);
    if (!polygon || pair.mover_b != null_index) return true;
    const Transform& place = near.bodies.poses[shapes.records[pair.shape_b].body].transform;
    const float apart = way.path.reach + polygon->radius + distance_apart(shapes.tolerances);
    return !stays_beyond_a_face(*polygon, place, way.path.from, way.path.from + way.path.way, apart);
}

void ContinuousCollision::judge_candidates(const Surroundings& near)
{
    if (has_carriers_) find_carried(near);
    if (near.rules.hooks != nullptr) // they are asked in the order of the pairs
        std::sort(candidates_.begin(), candidates_.end(),
                  [&](const Candidate& l, const Candidate& r) { return key_of(l.way, l.other) < key_of(r.way, r.other); });
    for (const Candidate& candidate : candidates_)
    {
        const ShapeWay& way = ways_[candidate.way];
        const std::uint32_t other_way = way_of_shape_[candidate.other];
        const bool is_other_fast = other_way != null_index;
        const Pair pair = pair_of(way.mover, way.shape, candidate.other, key_of(candidate.way, candidate.other), near);
        if (way.is_sensor || (is_other_fast ? ways_[other_way].is_sensor : near.shapes.records[candidate.other].is_sensor))
        {
            if (judge(pair, near).makes_contact) sensor_pairs_.push_back(pair);
        }
        else if (is_other_fast || may_meet(way, pair, near))
        {
            seek_impact(pair, 0, near);
        }
    }
}

void ContinuousCollision::list_near(const Aabb& box, BroadPhase& broad_phase)
{
    Collector collector(near_);
    broad_phase.query(box, collector);
    std::sort(near_.begin(), near_.end()); // the broad phase does not show
}

std::uint32_t ContinuousCollision::next_late(std::uint32_t late, std::uint32_t mover) const
{
    return late_pairs_[late].pair.mover_a == mover ? late_pairs_[late].next_of_a : late_pairs_[late].next_of_b;
}

/// Whether a pair of a mover is among those that for_each_pair sees.
bool ContinuousCollision::is_known(std::uint32_t mover, std::uint32_t shape, std::uint32_t other, const ShapeStore& shapes) const
{
    for (std::uint32_t p = movers_[mover].first_late; p != null_index; p = next_late(p, mover))
    {
        const Pair& pair = late_pairs_[p].pair;
        if ((pair.shape_a == shape && pair.shape_b == other) || (pair.shape_a == other && pair.shape_b == shape)) return true;
    }
    if (!overlaps(shapes.bounds[shape].fat, shapes.bounds[other].fat)) return false;
    if (movers_[mover].is_fast) return true;
    const std::uint32_t way = way_of_shape_[other];
    return way != null_index && key_of(way, shape) >= movers_[mover].made_for;
}

/// A pair that came to be when the mover left its own way.
void ContinuousCollision::add_late_pair(std::uint32_t mover, std::uint32_t shape, std::uint32_t other, const Surroundings& near)
{
    const PairKey key = first_late_key + late_pairs_.size();
    if (near.shapes.records[other].body == movers_[mover].body) return;
    Pair pair = pair_of(mover, shape, other, key, near);
    const PairVerdict verdict = judge(pair, near);
    if (!verdict.makes_contact) return;
    if (verdict.is_sensor) return sensor_pairs_.push_back(pair);
    if (runs_into(pair, near)) pair.mover_b = mover_of(near.shapes.records[pair.shape_b].body, key, near);
    const auto index = static_cast<std::uint32_t>(late_pairs_.size());
    late_pairs_.push_back({pair, null_index, null_index});
    late_pairs_[index].next_of_a = std::exchange(movers_[pair.mover_a].first_late, index);
    if (pair.mover_b != null_index) late_pairs_[index].next_of_b = std::exchange(movers_[pair.mover_b].first_late, index);
}

} // namespace carom::detail
