// The flat quadtree with the hash set that it no longer needs: the step between the naive quadtree and the last one.
#pragma once

#include "broadphase/pair_hash.hpp"
#include "broadphase/quadtree.hpp"

#include <unordered_set>

namespace carom::detail
{

/// Kept for the laboratory. A shape that lies in one node alone can't make a pair twice, so the set drops nothing, and the distance from here to
/// `Quadtree` is what the set costs. The set makes a cell for each pair, taken from the world's memory one by one, as a standard container does.
class QuadtreeWithSet final : public Quadtree
{
public:
    QuadtreeWithSet(const BroadPhaseOptions& options, std::pmr::memory_resource& memory) : Quadtree(options, memory), found_(&memory) {}

    BroadPhaseType type() const override { return BroadPhaseType::QuadtreeWithSet; }

private:
    void search_pairs(std::span<const ProxyIndex> moved, PairList& pairs) override;
    std::pmr::unordered_set<ProxyPair, PairHash> found_;
};

} // namespace carom::detail
