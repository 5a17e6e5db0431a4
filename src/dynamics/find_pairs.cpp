// The cheap reasons against a pair come first; the set of known pairs is asked last.
#include "dynamics/find_pairs.hpp"

#include "dynamics/mix_materials.hpp"

#include <algorithm>

namespace carom::detail
{

namespace
{

/// Whether a joint keeps two bodies from touching each other.
bool are_held_apart(const BodyStore& bodies, const JointStore& joints, std::uint32_t a, std::uint32_t b)
{
    if (bodies.records[b].first_joint == null_index) return false;
    for (std::uint32_t edge = bodies.records[a].first_joint; edge != null_index; edge = joints.joints[edge / 2].next[edge % 2])
    {
        const Joint& joint = joints.joints[edge / 2];
        if (!joint.collide_connected && (edge % 2 == 0 ? joint.body_b : joint.body_a) == b) return true;
    }
    return false;
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

bool find_pairs(BroadPhase& broad_phase, ShapeStore& shapes, BodyStore& bodies, const JointStore& joints, ContactStore& contacts,
                PairSet& known, const ContactRules& rules, std::pmr::memory_resource& scratch)
{
    contacts.begin_search();
    const bool has_nodes = broad_phase.stats().nodes > 0; // one that is new to the world has yet to make them
    if (shapes.moved.empty() && has_nodes)
    {
        broad_phase.skip_search();
        return false;
    }
    std::pmr::vector<ProxyPair> found(&scratch);
    broad_phase.find_pairs(shapes.moved, found);

    const auto is_no_news = [&](ProxyPair pair) { return !judge_pair(shapes, bodies, joints, pair).makes_contact || known.contains(pair); };
    found.erase(std::remove_if(found.begin(), found.end(), is_no_news), found.end());
    std::sort(found.begin(), found.end());
    if (rules.hooks != nullptr) // in the order of the shapes
    {
        const auto id_of = [&](ProxyIndex shape) { return ShapeId{shape, shapes.slots.generation(shape), rules.world}; };
        const auto is_refused = [&](ProxyPair pair) { return !rules.hooks->should_collide(id_of(pair.a), id_of(pair.b)); };
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
        mix_materials(contact, shapes, rules);
        contacts.create(contact, bodies);
        known.insert(pair);
        any_idle = any_idle || (!bodies.is_active(contact.body_a) && !bodies.is_active(contact.body_b));
    }
    shapes.clear_moved(); // last: if memory runs out above, the next step looks for the pairs again
    return any_idle;
}

} // namespace carom::detail
