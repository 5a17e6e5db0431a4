// The cheap reasons against a pair come first; the set of known pairs is asked last.
#include "dynamics/find_pairs.hpp"

#include "dynamics/narrow_phase.hpp"

#include <algorithm>

namespace carom::detail
{

PairVerdict judge_pair(const ShapeStore& shapes, const BodyStore& bodies, ProxyPair pair)
{
    const ShapeRecord& a = shapes.records[pair.a];
    const ShapeRecord& b = shapes.records[pair.b];
    if (a.body == b.body || !should_collide(a.filter, b.filter)) return {};
    if (a.is_sensor || b.is_sensor) return {.makes_contact = a.sensor_events && b.sensor_events, .is_sensor = true};
    return {.makes_contact = bodies.is_dynamic(a.body) || bodies.is_dynamic(b.body), .is_sensor = false};
}

void find_pairs(BroadPhase& broad_phase, ShapeStore& shapes, BodyStore& bodies, ContactStore& contacts, PairSet& known,
                std::pmr::vector<ProxyPair>& found)
{
    found.clear();
    if (shapes.moved.empty()) return;
    broad_phase.find_pairs(shapes.moved, found);

    const auto is_no_news = [&](ProxyPair pair) { return !judge_pair(shapes, bodies, pair).makes_contact || known.contains(pair); };
    found.erase(std::remove_if(found.begin(), found.end(), is_no_news), found.end());
    std::sort(found.begin(), found.end());

    known.reserve(known.size() + found.size());
    for (const ProxyPair pair : found)
    {
        Contact contact = {
            .shape_a = pair.a, .shape_b = pair.b, .body_a = shapes.records[pair.a].body, .body_b = shapes.records[pair.b].body};
        contact.is_sensor = judge_pair(shapes, bodies, pair).is_sensor;
        mix_materials(contact, shapes);
        contacts.create(contact, bodies);
        known.insert(pair);
    }
    shapes.clear_moved(); // last: if memory runs out above, the next step looks for the pairs again
}

} // namespace carom::detail
