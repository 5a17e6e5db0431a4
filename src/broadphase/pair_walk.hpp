// Finds overlapping boxes by walking trees of boxes against each other.
#pragma once

#include "broadphase/box_tree.hpp"

namespace carom::detail
{

/// A query from the root for each moved proxy goes down the same upper nodes again and again. Walking pairs of nodes shares that work
/// among all the proxies below them, and four boxes meet four boxes at a time. A pair of nodes without a moved proxy is never entered.
class PairWalk
{
public:
    explicit PairWalk(std::pmr::memory_resource& memory) : stack_(&memory) {}
    void reserve() { stack_.reserve(256); } ///< deep enough for any tree

    /// Appends each pair of proxies of the tree that overlap and of which at least one moved.
    void within(const BoxTree& tree, PairList& pairs);
    /// The same with one proxy from each tree.
    void between(const BoxTree& tree_a, const BoxTree& tree_b, PairList& pairs);

    /// The same, by looking up each moved proxy. Better when few have moved: then the pairs of nodes share little.
    void queries_within(const BoxTree& tree, PairList& pairs);
    void queries_between(const BoxTree& tree_a, const BoxTree& tree_b, PairList& pairs);

    std::size_t pairs_tested = 0;

private:
    struct NodePair
    {
        std::uint32_t a;
        std::uint32_t b; ///< the same node as a: the pairs inside it
    };

    /// Which child of one node meets which of another: bit 4 i + j for child i of the first and j of the second.
    using Meetings = unsigned;

    template <class IsReported>
    void query_each_moved(const BoxTree& from, const BoxTree& in, PairList& pairs, IsReported is_reported);
    template <class Report>
    void query(const BoxTree& tree, const Aabb& box, Report report);
    void push(const TreeNode& a, const TreeNode& b, Meetings meetings);
    void visit_node(const BoxTree& tree, std::uint32_t node, PairList& pairs);
    void visit_pair(const BoxTree& tree_a, const BoxTree& tree_b, NodePair nodes, PairList& pairs);

    std::pmr::vector<NodePair> stack_;
};

} // namespace carom::detail
