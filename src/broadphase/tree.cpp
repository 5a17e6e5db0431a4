// One step of the default broad phase: settle, refit, rebuild when worn, walk.
#include "broadphase/tree.hpp"

#include "broadphase/tree_query.hpp"

#include <algorithm>

namespace carom::detail
{
namespace
{

/// With fewer than one in so many moved, looking each up beats walking the tree against itself: it takes 0.6 of the time when 2% moved,
/// as long at 10%, 1.6 times as long at 30% and three times at 100% (piles and clouds of 1,000 to 10,000 shapes).
constexpr std::size_t few_moved = 12;

/// Queries look at the new proxies one by one while there are no more than this: a thing that is made and then asked about costs no building.
constexpr std::size_t most_waiting = 64;

/// A child always comes after its parent, so depths are known in one pass.
void append_nodes(const BoxTree& tree, std::vector<BroadPhaseNode>& nodes)
{
    const std::size_t first = nodes.size();
    for (std::uint32_t i = 0; i < tree.node_count(); ++i)
    {
        const std::uint32_t parent = tree.node(i).parent;
        const int depth = parent == BoxTree::none ? 0 : nodes[first + parent / 4].depth + 1;
        nodes.push_back({merge4(tree.boxes(i)), depth});
    }
    const auto is_empty = [](const BroadPhaseNode& node) { return node.bounds.min.x > node.bounds.max.x; };
    nodes.erase(std::remove_if(nodes.begin() + static_cast<std::ptrdiff_t>(first), nodes.end(), is_empty), nodes.end());
}

} // namespace

void Tree::reserve(std::size_t proxies)
{
    moving_.reserve(proxies);
    static_.reserve(proxies);
    walk_.reserve();
}

void Tree::insert(ProxyIndex proxy, const Aabb& box, ProxyKind kind)
{
    (kind == ProxyKind::Moving ? moving_ : static_).insert(proxy, box);
    close_queries();
}

void Tree::remove(ProxyIndex proxy)
{
    tree_of(proxy).remove(proxy);
    close_queries();
}

void Tree::update(ProxyIndex proxy, const Aabb& box)
{
    tree_of(proxy).update(proxy, box);
    close_queries();
}

/// Nobody has moved at this time: marks stand only while pairs are searched. So refitting now takes nothing from the next search but work.
void Tree::prepare_queries()
{
    for (BoxTree* tree : {&moving_, &static_})
    {
        if (tree->waiting().size() > most_waiting) tree->settle();
        tree->refit();
    }
}

void Tree::visit_boxes(const Aabb& box, BoxVisitor& visitor) const
{
    if (query_tree(moving_, box, visitor)) query_tree(static_, box, visitor);
}

void Tree::visit_sweep(const BoxSweep& sweep, SweepVisitor& visitor) const
{
    // What stands still first: it is more often the large things that end a sweep.
    const float most = query_tree(static_, sweep, 1, visitor);
    if (most >= 0) query_tree(moving_, sweep, most, visitor);
}

void Tree::mark_and_refit(std::span<const ProxyIndex> moved)
{
    for (const ProxyIndex proxy : moved) tree_of(proxy).mark_moved(proxy);
    moving_.refit();
    static_.refit();
}

void Tree::search_pairs(std::span<const ProxyIndex> moved, PairList& pairs)
{
    moving_.settle();
    static_.settle();
    mark_and_refit(moved);
    if (moving_.is_degraded() || static_.is_degraded())
    {
        if (moving_.is_degraded()) moving_.rebuild();
        if (static_.is_degraded()) static_.rebuild();
        mark_and_refit(moved);
    }

    walk_.pairs_tested = 0;
    if (moved.size() * few_moved < moving_.proxy_count())
    {
        walk_.queries_within(moving_, pairs);
        walk_.queries_between(moving_, static_, pairs);
    }
    else
    {
        walk_.within(moving_, pairs);
        walk_.between(moving_, static_, pairs);
    }
    moving_.clear_moved();
    static_.clear_moved();
    stats_ = {walk_.pairs_tested, 0, moving_.node_count() + static_.node_count()};
}

void Tree::list_nodes(std::vector<BroadPhaseNode>& nodes) const
{
    append_nodes(moving_, nodes);
    append_nodes(static_, nodes);
}

} // namespace carom::detail
