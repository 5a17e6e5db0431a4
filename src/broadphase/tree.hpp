// The default broad phase: one wide tree of boxes for what moves, one for what does not.
#pragma once

#include "broadphase/box_tree.hpp"
#include "broadphase/pair_walk.hpp"

namespace carom::detail
{

/// Two trees, because static shapes stay as they are for long: theirs is not refit while nothing in it changes, and is only ever met by
/// the tree of what moves.
class Tree final : public BroadPhase
{
public:
    Tree(const BroadPhaseOptions&, std::pmr::memory_resource& memory) : moving_(memory), static_(memory), walk_(memory) {}

    BroadPhaseType type() const override { return BroadPhaseType::Tree; }
    void reserve(std::size_t proxies) override;
    void insert(ProxyIndex proxy, const Aabb& box, ProxyKind kind) override;
    void remove(ProxyIndex proxy) override;
    void update(ProxyIndex proxy, const Aabb& box) override;
    void list_nodes(std::vector<BroadPhaseNode>& nodes) const override;

private:
    void search_pairs(std::span<const ProxyIndex> moved, PairList& pairs) override;
    void prepare_queries() override;
    void visit_boxes(const Aabb& box, BoxVisitor& visitor) const override;
    void visit_sweep(const BoxSweep& sweep, SweepVisitor& visitor) const override;

    BoxTree& tree_of(ProxyIndex proxy) { return moving_.holds(proxy) ? moving_ : static_; }
    void mark_and_refit(std::span<const ProxyIndex> moved);

    BoxTree moving_;
    BoxTree static_;
    PairWalk walk_;
};

} // namespace carom::detail
