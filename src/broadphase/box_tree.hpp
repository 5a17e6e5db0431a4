// A tree of boxes with four children a node: the store that the default broad phase walks.
#pragma once

#include "broadphase/box4.hpp"
#include "broadphase/box_tree_split.hpp"
#include "broadphase/broad_phase.hpp"

namespace carom::detail
{

/// What a node is beside its boxes.
struct alignas(32) TreeNode
{
    std::uint32_t child[4]; ///< nodes; in a leaf node proxies; `BoxTree::none` where absent
    std::uint32_t parent;   ///< 4 * node + lane; of the root `BoxTree::none`
    float built_perimeter;  ///< when the node was made [m]
    std::uint8_t moved;     ///< bit i: child i is, or has below it, a moved proxy
    bool is_leaf;           ///< its children are proxies
    bool is_degraded;       ///< grown well past built_perimeter
};

/// Boxes of proxies in a packed tree.
///
///     node 0      the root; child 0 is the old part, child 1 the young part
///     1 ..        the old part, depth first
///     young ..    the young part, depth first: what was inserted since the old part was built
///
/// A child always has a higher index than its parent, so one pass from the back brings every box up to date. New proxies wait aside until
/// `settle`, which rebuilds the young part alone while that is small, and everything when it is not, when many were removed, or
/// when boxes have drifted so far that nodes overlap (`is_degraded`). All levels but the topmost few are full, so depth is logarithmic
/// in the count, whatever the boxes are.
class BoxTree
{
public:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    explicit BoxTree(std::pmr::memory_resource& memory);

    bool holds(ProxyIndex proxy) const { return proxy < place_of_.size() && place_of_[proxy] != none; }
    void reserve(std::size_t proxies);
    void insert(ProxyIndex proxy, const Aabb& box);
    void remove(ProxyIndex proxy);
    void update(ProxyIndex proxy, const Aabb& box);

    /// Takes in what was inserted. Forgets who moved. Should memory run out, everything waits that was to be built, and the tree is sound.
    void settle();
    /// Marks one as moved. All must be settled.
    void mark_moved(ProxyIndex proxy);
    /// Brings the nodes above changed and moved proxies up to date.
    void refit();
    /// Asks for a rebuild: after refit, when too many nodes have grown.
    bool is_degraded() const;
    void rebuild();
    /// Nobody moved any more.
    void clear_moved();

    /// Nodes that are or have below them moved proxies: after refit, last first.
    std::span<const std::uint32_t> moved_nodes() const { return moved_nodes_; }
    bool is_empty() const { return nodes_.empty(); }
    std::size_t proxy_count() const { return proxy_count_; }
    std::size_t node_count() const { return nodes_.size(); }
    const Box4& boxes(std::uint32_t node) const { return boxes_[node]; }
    const TreeNode& node(std::uint32_t node) const { return nodes_[node]; }

    /// Inserted and not settled yet.
    struct Entry
    {
        Aabb box;
        ProxyIndex proxy;
    };
    std::span<const Entry> waiting() const { return waiting_; }

private:
    /// To be refit.
    void touch(std::uint32_t node) { touched_[node / 64] |= std::uint64_t{1} << node % 64; }
    void refit_node(std::uint32_t node);
    /// Lanes of leaf nodes that removals have emptied since their part was built.
    std::size_t gap_count() const { return old_count_ + young_count_ + waiting_.size() - proxy_count_; }
    void rebuild_young();
    void abandon(std::uint32_t first_node);
    void collect(std::uint32_t first_node);
    void build_part(unsigned root_lane);
    void forget_touched(std::uint32_t first_node);
    std::uint32_t add_node(std::uint32_t parent, bool is_leaf);
    void build_node(std::uint32_t parent, std::span<BuildItem> items);

    std::pmr::vector<Box4> boxes_;
    std::pmr::vector<TreeNode> nodes_;
    std::pmr::vector<std::uint64_t> touched_;     ///< a bit a node: changed, or with moved proxies
    std::pmr::vector<std::uint32_t> moved_nodes_; ///< those with a moved bit, after refit
    std::pmr::vector<std::uint32_t> place_of_;    ///< by proxy: 4 * node + lane, or where it waits
    std::pmr::vector<Entry> waiting_;             ///< inserted, not settled; input of a build
    std::pmr::vector<BuildItem> items_;           ///< scratch of a build
    std::uint32_t proxy_count_ = 0;               ///< in the nodes and waiting
    std::uint32_t young_begin_ = 0;
    std::uint32_t old_count_ = 0;   ///< proxies when the old part was built
    std::uint32_t young_count_ = 0; ///< proxies when the young part was built
    std::uint32_t degraded_count_ = 0;
};

} // namespace carom::detail
