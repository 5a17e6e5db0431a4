// The tree by itself: what it holds, and when it is built anew.
#include "broadphase/box_tree.hpp"

#include <gtest/gtest.h>

#include <memory_resource>
#include <random>
#include <set>

namespace carom::detail
{
namespace
{

Aabb box_of(ProxyIndex proxy)
{
    const auto x = static_cast<float>(proxy);
    return {{x, 0}, {x + 0.5f, 1}};
}

/// Proxies below the nodes, read by walking them.
std::multiset<ProxyIndex> proxies_in_nodes(const BoxTree& tree)
{
    std::multiset<ProxyIndex> found;
    for (std::uint32_t i = 0; i < tree.node_count(); ++i)
        if (tree.node(i).is_leaf)
            for (const std::uint32_t child : tree.node(i).child)
                if (child != BoxTree::none) found.insert(child);
    return found;
}

} // namespace

/// Settling rebuilds the young part, everything, or nothing, by how much came and went.
TEST(BoxTree, CountsWhatItHoldsWhicheverPartIsBuiltAnew)
{
    BoxTree tree(*std::pmr::get_default_resource());
    std::set<ProxyIndex> held;
    std::mt19937 engine(1);
    for (int round = 0; round < 400; ++round)
    {
        // Long stretches of growing and of shrinking: removals fall into both parts.
        const auto changes = static_cast<int>(engine() % (round % 100 < 50 ? 12 : 30));
        for (int i = 0; i < changes; ++i)
        {
            const auto proxy = static_cast<ProxyIndex>(engine() % 600);
            const bool grows = round % 100 < 50;
            if (grows && held.insert(proxy).second) tree.insert(proxy, box_of(proxy));
            if (!grows && held.erase(proxy) == 1) tree.remove(proxy);
        }
        EXPECT_EQ(tree.proxy_count(), held.size());
        tree.settle();
        tree.refit();
        ASSERT_EQ(tree.proxy_count(), held.size()) << round;
        ASSERT_EQ(proxies_in_nodes(tree).size() + tree.waiting().size(), held.size()) << round;
    }
}

/// Gaps in the lanes cost as much as boxes: after removing most, few nodes are left.
TEST(BoxTree, ShrinksAfterRemovals)
{
    BoxTree tree(*std::pmr::get_default_resource());
    for (ProxyIndex i = 0; i < 1000; ++i) tree.insert(i, box_of(i));
    tree.settle();
    const std::size_t full = tree.node_count();
    for (ProxyIndex i = 0; i < 900; ++i)
    {
        tree.remove(i);
        tree.settle();
    }
    EXPECT_LT(tree.node_count(), full / 5);
    EXPECT_EQ(proxies_in_nodes(tree).size(), 100u);
}

} // namespace carom::detail
