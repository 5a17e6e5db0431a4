// Every pair: the reference that the other broad phases are measured against.
#pragma once

#include "broadphase/proxy_table.hpp"

namespace carom::detail
{

class BruteForce final : public BroadPhase
{
public:
    BruteForce(const BroadPhaseOptions&, std::pmr::memory_resource& memory) : table_(memory) {}

    BroadPhaseType type() const override { return BroadPhaseType::BruteForce; }
    void insert(ProxyIndex proxy, const Aabb& box, ProxyKind kind) override { table_.insert(proxy, box, kind); }
    void remove(ProxyIndex proxy) override { table_.remove(proxy); }
    void update(ProxyIndex proxy, const Aabb& box) override { table_.update(proxy, box); }
    void list_nodes(std::vector<BroadPhaseNode>&) const override {}

private:
    void search_pairs(std::span<const ProxyIndex> moved, PairList& pairs) override;
    void prepare_queries() override {}
    void visit_boxes(const Aabb& box, BoxVisitor& visitor) const override { visit_all(table_, box, visitor); }
    void visit_sweep(const BoxSweep& sweep, SweepVisitor& visitor) const override { visit_all(table_, sweep, visitor); }

    ProxyTable table_;
};

} // namespace carom::detail
