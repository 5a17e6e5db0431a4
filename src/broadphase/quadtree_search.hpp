// Finding the pairs along the branches of the flat quadtree, for whatever the versions of it do with them.
#pragma once

#include "broadphase/quadtree.hpp"
#include "broadphase/quadtree_layout.hpp"

#include <array>

namespace carom::detail
{

template <class Found>
void Quadtree::search(std::span<const ProxyIndex> moved, const PairList& pairs, Found found)
{
    stats_ = {};
    table_.set_moved(moved, true);
    build_all();
    for (const Node& node : nodes_)
    {
        if (pairs.is_full()) break;
        if (!node.has_moved) continue;
        pair_within(node, pairs, found);
        if (node.own_end == node.end) continue;
        for (std::uint32_t i = node.begin; i < node.own_end && !pairs.is_full(); ++i) pair_below(node, sorted_[i], found);
    }
    table_.set_moved(moved, false);
    stats_.nodes = nodes_.size();
}

/// Pairs among the node's own shapes.
template <class Found>
void Quadtree::pair_within(const Node& node, const PairList& pairs, Found found)
{
    for (std::uint32_t i = node.begin; i < node.own_end; ++i)
    {
        const Entry& self = sorted_[i];
        if (pairs.is_full()) return;
        if (!self.is_moved) continue;
        for (std::uint32_t j = node.begin; j < node.own_end; ++j)
        {
            const Entry& other = sorted_[j];
            const bool is_seen_from_other = other.is_moved && j <= i; // itself, too
            if (is_seen_from_other || !is_candidate(self, other)) continue;
            ++stats_.pairs_tested;
            if (overlaps_branchless(self.box, other.box)) found(ordered_pair(self.proxy, other.proxy));
        }
    }
}

/// Pairs of one of the node's own shapes with those below the node.
template <class Found>
void Quadtree::pair_below(const Node& node, const Entry& self, Found found)
{
    std::array<std::uint32_t, 4 * quadtree::deepest> stack; // at most three siblings wait at each depth
    std::size_t stack_size = 0;
    const auto push_children = [&](std::uint32_t index)
    {
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
        {
            const std::uint32_t place = place_of(quadtree::child_of(index, quadrant));
            if (place == absent || !(self.is_moved | nodes_[place].has_moved)) continue;
            if (overlaps(nodes_[place].bounds, self.box)) stack[stack_size++] = place;
        }
    };

    push_children(node.index);
    while (stack_size > 0)
    {
        const Node& below = nodes_[stack[--stack_size]];
        for (std::uint32_t i = below.begin; i < below.own_end; ++i)
        {
            if (!is_candidate(self, sorted_[i])) continue;
            ++stats_.pairs_tested;
            if (overlaps_branchless(self.box, sorted_[i].box)) found(ordered_pair(self.proxy, sorted_[i].proxy));
        }
        if (below.own_end < below.end) push_children(below.index);
    }
}

} // namespace carom::detail
