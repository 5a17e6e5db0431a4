// Compares each moved proxy with every other one.
#include "broadphase/brute_force.hpp"

namespace carom::detail
{

void BruteForce::search_pairs(std::span<const ProxyIndex> moved, PairList& pairs)
{
    stats_ = {};
    table_.set_moved(moved, true);
    const std::span<const ProxyTable::Entry> entries = table_.entries();
    for (const ProxyIndex proxy : moved)
    {
        if (pairs.is_full()) break;
        const std::uint32_t place = table_.place_of(proxy);
        const ProxyTable::Entry& self = entries[place];
        for (std::uint32_t i = 0; i < entries.size(); ++i)
        {
            const ProxyTable::Entry& other = entries[i];
            const bool is_seen_from_other = other.is_moved && i <= place; // itself, too
            if (is_seen_from_other || !is_candidate(self, other)) continue;
            ++stats_.pairs_tested;
            if (overlaps_branchless(self.box, other.box)) pairs.add(ordered_pair(self.proxy, other.proxy));
        }
    }
    table_.set_moved(moved, false);
}

} // namespace carom::detail
