// Asking the set of each pair whether it is new. The set is never walked, so its order does not show.
#include "broadphase/quadtree_with_set.hpp"

#include "broadphase/quadtree_search.hpp"

namespace carom::detail
{

void QuadtreeWithSet::search_pairs(std::span<const ProxyIndex> moved, PairList& pairs)
{
    found_.clear();
    search(moved, pairs, [this, &pairs](ProxyPair pair)
    {
        if (found_.insert(pair).second) pairs.add(pair);
    });
}

} // namespace carom::detail
