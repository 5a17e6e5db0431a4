// A flat quadtree: children of node i at 4i+1..4i+4, a shape once in the deepest node that holds it.
#pragma once

#include "broadphase/changed_proxies.hpp"
#include "broadphase/proxy_table.hpp"
#include "broadphase/radix_sort.hpp"

namespace carom::detail
{

/// Built anew each time, without inserting anything one by one: a shape's node follows from the cells of its two corners, sorting the
/// shapes by node in depth-first order makes every node's shapes, and every subtree's, one contiguous range.
class Quadtree : public BroadPhase
{
public:
    Quadtree(const BroadPhaseOptions& options, std::pmr::memory_resource& memory);

    BroadPhaseType type() const override { return BroadPhaseType::Quadtree; }
    void insert(ProxyIndex proxy, const Aabb& box, ProxyKind kind) override;
    void remove(ProxyIndex proxy) override;
    void update(ProxyIndex proxy, const Aabb& box) override;
    void list_nodes(std::vector<BroadPhaseNode>& nodes) const override;

protected:
    /// Builds the tree and finds the pairs, each once; all of `stats_` but pairs_found. Defined in quadtree_search.hpp.
    /// @param found is called with each pair, in the order of the tree
    template <class Found>
    void search(std::span<const ProxyIndex> moved, const PairList& pairs, Found found);

private:
    using Entry = ProxyTable::Entry;

    /// A node in use: the ranges of its own shapes and of its subtree's, which follow them, in `sorted_`.
    struct Node
    {
        Aabb bounds;         ///< of the shapes in the subtree, mostly tighter than the cell
        std::uint32_t index; ///< in the flat tree
        std::uint32_t begin;
        std::uint32_t own_end;
        std::uint32_t end;
        bool has_moved; ///< in the subtree
    };

    void search_pairs(std::span<const ProxyIndex> moved, PairList& pairs) override;
    void prepare_queries() override;
    void visit_boxes(const Aabb& box, BoxVisitor& visitor) const override;
    void visit_sweep(const BoxSweep& sweep, SweepVisitor& visitor) const override;
    void note_change(ProxyIndex proxy);
    template <class MayHold, class Visit>
    void walk(MayHold may_hold, Visit visit) const;

    void build_all();
    void sort_by_node();
    void build();
    std::uint32_t build_node(std::uint32_t index, int depth, std::uint32_t begin, std::uint32_t end);
    void enlist(std::uint32_t index, std::uint32_t place);
    template <class Found>
    void pair_within(const Node& node, const PairList& pairs, Found found);
    template <class Found>
    void pair_below(const Node& node, const Entry& self, Found found);
    std::uint32_t place_of(std::uint32_t index) const { return index < directory_.size() ? directory_[index] : absent; }

    static constexpr std::uint32_t absent = 0; ///< the root is nobody's child
    static constexpr int depth_bits = 4;       ///< of a key

    int max_depth_;
    std::uint32_t node_capacity_;
    ProxyTable table_;
    Aabb root_bounds_;
    std::pmr::vector<SortKey> keys_; ///< of a shape: its node in depth-first order, that is, the node's first cell, then its depth
    std::pmr::vector<SortKey> keys_scratch_;
    std::pmr::vector<Entry> sorted_;
    std::pmr::vector<Node> nodes_; ///< those in use, depth first
    /// The flat tree: for each node its place in `nodes_`. Only as long as the deepest node that was ever in use asks for, and four bytes
    /// a node: with depth 10 there are 1.4 million.
    std::pmr::vector<std::uint32_t> directory_;
    ChangedProxies changed_; ///< since the tree was built
};

} // namespace carom::detail
