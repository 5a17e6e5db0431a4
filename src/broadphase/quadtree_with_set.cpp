// Asking the set of each pair whether it is new. The set is never walked, so its order does not show.
#include "broadphase/quadtree_with_set.hpp"

#include "broadphase/quadtree_search.hpp"

namespace carom::detail
{

void QuadtreeWithSet::find_pairs(std::span<const ProxyIndex> moved, std::pmr::vector<ProxyPair>& pairs)
{
    found_.clear();
    search(moved, [this, &pairs](ProxyPair pair)
    {
        if (found_.insert(pair).second) pairs.push_back(pair);
    });
    stats_.pairs_found = found_.size();
}

} // namespace carom::detail
