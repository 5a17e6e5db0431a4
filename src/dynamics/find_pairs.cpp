// The cheap reasons against a pair come first; the set of known pairs is asked last.
#include "dynamics/find_pairs.hpp"

#include "dynamics/ids.hpp"
#include "dynamics/mix_materials.hpp"
#include "dynamics/walks.hpp"

#include <algorithm>
#include <span>

namespace carom::detail
{

namespace
{

/// Whether a joint keeps two bodies from touching each other.
bool are_held_apart(const BodyStore& bodies, const JointStore& joints, std::uint32_t a, std::uint32_t b)
{
    if (bodies.records[b].first_joint == null_index) return false;
    for (const Tie joint : joints_of(bodies, joints, a))
        if (joint.other == b && !joints.joints[joint.slot].collide_connected) return true;
    return false;
}

/// However many shapes there are, so many pairs are allowed when the user sets no limit. Beyond, a step takes seconds and the world half a gigabyte.
constexpr std::size_t least_most_pairs = std::size_t{1} << 19;

/// Pairs allowed for each shape when the user sets no limit. Packed discs have 3, boxes 4; rubble of mixed sizes, with its fat bounds, up to 10.
constexpr std::size_t most_pairs_of_a_shape = 64;

/// Drops pairs that may not meet, and those that are contacts already. Most have been near each other since the last search: four comparisons
/// tell, and neither the records of the shapes nor the set of known pairs are read.
class NewsFilter final : public PairFilter
{
public:
    /// @param asks_hooks pairs that a hook has refused are asked about again
    NewsFilter(const ShapeStore& shapes, const BodyStore& bodies, const JointStore& joints, const PairSet& known, bool asks_hooks)
        : shapes_(shapes),
          bodies_(bodies),
          joints_(joints),
          known_(known),
          asks_hooks_(asks_hooks)
    {
    }

    void filter(std::pmr::vector<ProxyPair>& pairs, std::size_t first) override
    {
        const auto is_no_news = [this](ProxyPair pair)
        {
            if (!asks_hooks_ && overlaps(shapes_.searched[pair.a], shapes_.searched[pair.b])) return true;
            return !judge_pair(shapes_, bodies_, joints_, pair).makes_contact || known_.contains(pair);
        };
        pairs.erase(std::remove_if(pairs.begin() + static_cast<std::ptrdiff_t>(first), pairs.end(), is_no_news), pairs.end());
    }

private:
    const ShapeStore& shapes_;
    const BodyStore& bodies_;
    const JointStore& joints_;
    const PairSet& known_;
    bool asks_hooks_;
};

/// Looks for the crowd among the contacts and the new pairs. A shape of the ground has many pairs in good order, so only dynamic bodies count.
PairSearch over_limit(const ShapeStore& shapes, const BodyStore& bodies, const ContactStore& contacts, std::span<const ProxyPair> found,
                      std::pmr::memory_resource& scratch)
{
    std::pmr::vector<std::uint32_t> counts(shapes.records.size(), 0, &scratch);
    const auto count = [&](std::uint32_t shape)
    {
        if (bodies.is_dynamic(shapes.records[shape].body)) ++counts[shape];
    };
    for (const Contact& contact : contacts.contacts)
    {
        if (!contact.is_live) continue;
        count(contact.shape_a);
        count(contact.shape_b);
    }
    for (const ProxyPair pair : found)
    {
        count(pair.a);
        count(pair.b);
    }
    const auto most = std::max_element(counts.begin(), counts.end());
    return {.is_over_limit = true, .crowded_shape = static_cast<std::uint32_t>(most - counts.begin()), .crowd = *most};
}

} // namespace

PairVerdict judge_pair(const ShapeStore& shapes, const BodyStore& bodies, const JointStore& joints, ProxyPair pair)
{
    const ShapeRecord& a = shapes.records[pair.a];
    const ShapeRecord& b = shapes.records[pair.b];
    if (a.body == b.body || !should_collide(a.filter, b.filter)) return {};
    if (a.is_sensor || b.is_sensor) return {.makes_contact = a.sensor_events && b.sensor_events, .is_sensor = true};
    const bool can_push = bodies.is_dynamic(a.body) || bodies.is_dynamic(b.body);
    return {.makes_contact = can_push && !are_held_apart(bodies, joints, a.body, b.body), .is_sensor = false};
}

std::size_t most_pairs(const ContactRules& rules, const ShapeStore& shapes)
{
    if (rules.max_pairs > 0) return static_cast<std::size_t>(rules.max_pairs);
    const auto count = static_cast<std::size_t>(shapes.slots.live_count());
    return std::max(least_most_pairs, most_pairs_of_a_shape * count);
}

PairSearch find_pairs(BroadPhase& broad_phase, ShapeStore& shapes, BodyStore& bodies, const JointStore& joints, ContactStore& contacts,
                      PairSet& known, const ContactRules& rules, std::pmr::memory_resource& scratch)
{
    contacts.begin_search();
    const bool has_nodes = broad_phase.stats().nodes > 0; // one that is new to the world has yet to make them
    if (shapes.moved.empty() && has_nodes)
    {
        broad_phase.skip_search();
        return {};
    }
    std::pmr::vector<ProxyPair> found(&scratch);
    NewsFilter filter(shapes, bodies, joints, known, rules.hooks != nullptr);
    const std::size_t most = most_pairs(rules, shapes);
    PairList list(found, filter, most - std::min(most, known.size()));
    broad_phase.find_pairs(shapes.moved, list);
    list.finish();
    if (list.is_full()) return over_limit(shapes, bodies, contacts, found, scratch);
    std::sort(found.begin(), found.end());
    if (rules.hooks != nullptr) // in the order of the shapes
    {
        const auto id = [&](ProxyIndex shape) { return id_of<ShapeId>(shapes, shape, rules.world); };
        const auto is_refused = [&](ProxyPair pair) { return !rules.hooks->should_collide(id(pair.a), id(pair.b)); };
        std::size_t kept = 0; // std::remove_if may call in any order
        for (const ProxyPair pair : found)
            if (!is_refused(pair)) found[kept++] = pair;
        found.resize(kept);
    }

    known.reserve(known.size() + found.size());
    bool any_idle = false;
    for (const ProxyPair pair : found)
    {
        Contact contact = {
            .shape_a = pair.a, .shape_b = pair.b, .body_a = shapes.records[pair.a].body, .body_b = shapes.records[pair.b].body};
        contact.is_sensor = judge_pair(shapes, bodies, joints, pair).is_sensor;
        refresh_wishes(contact, shapes);
        const ContactSurface surface = mix_materials(contact, shapes, rules);
        ContactManifold& manifold = contacts.manifolds[contacts.create(contact, bodies)];
        manifold.surface = surface;
        set_roundings(manifold, contact, shapes);
        known.insert(pair);
        any_idle = any_idle || (!bodies.is_active(contact.body_a) && !bodies.is_active(contact.body_b));
    }
    shapes.end_search(rules.hooks == nullptr); // last: if memory runs out above, the next step looks for the pairs again
    return {.has_idle = any_idle};
}

} // namespace carom::detail
