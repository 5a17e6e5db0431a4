// What one writes first: nodes divide, a shape is in every leaf that it touches, and a hash set drops the pairs found twice.
#pragma once

#include "broadphase/pair_hash.hpp"
#include "broadphase/proxy_table.hpp"

#include <unordered_set>

namespace carom::detail
{

/// Kept for the laboratory: the distance from here to `QuadtreeWithSet` is what layout and "a shape once" are worth. Its nodes stand only for the
/// time of a search for pairs; queries look at every box. The set makes a cell for each pair, taken from the world's memory one by one.
class QuadtreeNaive final : public BroadPhase
{
public:
    QuadtreeNaive(const BroadPhaseOptions& options, std::pmr::memory_resource& memory);

    BroadPhaseType type() const override { return BroadPhaseType::QuadtreeNaive; }
    void insert(ProxyIndex proxy, const Aabb& box, ProxyKind kind) override { table_.insert(proxy, box, kind); }
    void remove(ProxyIndex proxy) override { table_.remove(proxy); }
    void update(ProxyIndex proxy, const Aabb& box) override { table_.update(proxy, box); }
    void list_nodes(std::vector<BroadPhaseNode>& nodes) const override;

private:
    void search_pairs(std::span<const ProxyIndex> moved, PairList& pairs) override;
    void prepare_queries() override {}
    void visit_boxes(const Aabb& box, BoxVisitor& visitor) const override { visit_all(table_, box, visitor); }
    void visit_sweep(const BoxSweep& sweep, SweepVisitor& visitor) const override { visit_all(table_, sweep, visitor); }

    struct Node
    {
        explicit Node(const std::pmr::polymorphic_allocator<>& allocator) : shapes(allocator) {}

        Aabb bounds;
        int depth = 0;
        std::uint32_t first_child = 0;          ///< of four; 0 in a leaf
        std::pmr::vector<std::uint32_t> shapes; ///< places in the table; of a leaf only
    };

    std::uint32_t add_node(const Aabb& bounds, int depth);
    void insert_below(std::uint32_t node, std::uint32_t shape);
    void divide(std::uint32_t node);
    bool is_worth_dividing(const Node& node) const;

    int max_depth_;
    std::size_t node_capacity_;
    ProxyTable table_;
    std::pmr::unsynchronized_pool_resource pool_; ///< keeps the blocks of nodes from step to step
    std::pmr::vector<Node> nodes_;                ///< only the first node_count_ are in use; the rest keep their memory
    std::size_t node_count_ = 0;
    std::pmr::unordered_set<ProxyPair, PairHash> found_;
};

} // namespace carom::detail
