// Building the flat quadtree by sorting, and queries that walk it.
#include "broadphase/quadtree.hpp"

#include "broadphase/quadtree_layout.hpp"
#include "broadphase/quadtree_search.hpp"

#include <algorithm>
#include <array>

namespace carom::detail
{

Quadtree::Quadtree(const BroadPhaseOptions& options, std::pmr::memory_resource& memory)
    : max_depth_(std::clamp(options.quadtree_max_depth, 0, 10)),
      node_capacity_(static_cast<std::uint32_t>(std::max(options.quadtree_node_capacity, 1))),
      table_(memory),
      keys_(&memory),
      keys_scratch_(&memory),
      sorted_(&memory),
      nodes_(&memory),
      directory_(&memory),
      changed_(memory)
{
}

void Quadtree::search_pairs(std::span<const ProxyIndex> moved, PairList& pairs)
{
    search(moved, pairs, [&pairs](ProxyPair pair) { pairs.add(pair); });
}

void Quadtree::insert(ProxyIndex proxy, const Aabb& box, ProxyKind kind)
{
    changed_.reserve(proxy);
    table_.insert(proxy, box, kind);
    note_change(proxy);
}

void Quadtree::remove(ProxyIndex proxy)
{
    table_.remove(proxy);
    note_change(proxy);
}

void Quadtree::update(ProxyIndex proxy, const Aabb& box)
{
    table_.update(proxy, box);
    note_change(proxy);
}

void Quadtree::note_change(ProxyIndex proxy)
{
    changed_.note(proxy);
    close_queries();
}

void Quadtree::build_all()
{
    // Should memory run out below, an empty tree in which everything has changed stands.
    for (const Node& node : nodes_)
        if (node.index < directory_.size()) directory_[node.index] = absent;
    nodes_.clear();
    for (const Entry& entry : table_.entries()) changed_.note(entry.proxy);
    sort_by_node();
    build();
    changed_.clear();
}

/// Two shapes overlap only if their ranges of cells share one; the nodes that hold the ranges both hold that cell, so one of them is the
/// other's ancestor, or they are the same. This holds for the cells as integers, whatever the rounding of bounds.
void Quadtree::sort_by_node()
{
    const std::span<const Entry> entries = table_.entries();
    keys_.clear();
    sorted_.clear();
    if (entries.empty()) return;

    root_bounds_ = entries[0].box;
    for (const Entry& entry : entries) root_bounds_ = merge(root_bounds_, entry.box);
    const quadtree::Grid grid(root_bounds_, max_depth_);
    for (std::uint32_t i = 0; i < entries.size(); ++i)
    {
        const std::uint32_t low = grid.code(entries[i].box.min);
        const int depth = quadtree::common_depth(low, grid.code(entries[i].box.max), max_depth_);
        const int bits_below = 2 * (max_depth_ - depth);
        const std::uint32_t first_cell = low >> bits_below << bits_below;
        keys_.push_back({first_cell << depth_bits | static_cast<std::uint32_t>(depth), i});
    }
    keys_scratch_.resize(keys_.size());
    radix_sort(keys_, keys_scratch_, 2 * max_depth_ + depth_bits);
    for (const SortKey& key : keys_) sorted_.push_back(entries[key.index]);
}

void Quadtree::build()
{
    if (!sorted_.empty()) build_node(0, 0, 0, static_cast<std::uint32_t>(sorted_.size()));
}

/// A node whose subtree has more shapes than its capacity divides: the same tree as inserting one shape after the other gives.
/// Recursion ends at depth 10.
std::uint32_t Quadtree::build_node(std::uint32_t index, int depth, std::uint32_t begin, std::uint32_t end)
{
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({sorted_[begin].box, index, begin, end, end, false});
    enlist(index, place);
    Node node = nodes_.back();
    if (end - begin > node_capacity_ && depth < max_depth_)
    {
        // First come the shapes that no child holds, then those of each child's subtree.
        const auto depth_at = [this](std::uint32_t i) { return static_cast<int>(keys_[i].key & ((1u << depth_bits) - 1)); };
        const auto quadrant_at = [this, depth](std::uint32_t i)
        { return quadtree::quadrant_at(keys_[i].key >> depth_bits, max_depth_, depth); };
        node.own_end = begin;
        while (node.own_end < end && depth_at(node.own_end) == depth) ++node.own_end;
        for (std::uint32_t child_begin = node.own_end; child_begin < end;)
        {
            const unsigned quadrant = quadrant_at(child_begin);
            std::uint32_t child_end = child_begin + 1;
            while (child_end < end && quadrant_at(child_end) == quadrant) ++child_end;
            const Node& child = nodes_[build_node(quadtree::child_of(index, quadrant), depth + 1, child_begin, child_end)];
            node.bounds = merge(node.bounds, child.bounds);
            node.has_moved |= child.has_moved;
            child_begin = child_end;
        }
    }
    for (std::uint32_t i = begin; i < node.own_end; ++i)
    {
        node.bounds = merge(node.bounds, sorted_[i].box);
        node.has_moved |= sorted_[i].is_moved;
    }
    nodes_[place] = node;
    return place;
}

void Quadtree::enlist(std::uint32_t index, std::uint32_t place)
{
    if (index >= directory_.size()) directory_.resize(quadtree::node_count(quadtree::depth_of(index)), absent);
    directory_[index] = place;
}

/// Each change costs a look at one more box; from some point on, building all anew is cheaper.
void Quadtree::prepare_queries()
{
    constexpr std::size_t few = 64;
    constexpr std::size_t share = 16;
    if (changed_.list().size() > std::max(few, table_.entries().size() / share)) build_all();
}

/// @param may_hold by a node's bounds, whether anything below it is to be visited
/// @param visit    an entry of the tree; returns false to end
template <class MayHold, class Visit>
void Quadtree::walk(MayHold may_hold, Visit visit) const
{
    if (nodes_.empty()) return;
    std::array<std::uint32_t, 4 * quadtree::deepest> stack; // at most three siblings wait at each depth
    std::size_t stack_size = 0;
    stack[stack_size++] = 0; // the root is the first node
    while (stack_size > 0)
    {
        const Node& node = nodes_[stack[--stack_size]];
        if (!may_hold(node.bounds)) continue;
        for (std::uint32_t i = node.begin; i < node.own_end; ++i)
            if (!changed_.holds(sorted_[i].proxy) && !visit(sorted_[i])) return;
        if (node.own_end == node.end) continue;
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
        {
            const std::uint32_t place = place_of(quadtree::child_of(node.index, quadrant));
            if (place != absent) stack[stack_size++] = place;
        }
    }
}

void Quadtree::visit_boxes(const Aabb& box, BoxVisitor& visitor) const
{
    const auto visit = [&](const Entry& entry) { return !overlaps(entry.box, box) || visitor.visit(entry.proxy); };
    for (const ProxyIndex proxy : changed_.list())
        if (table_.holds(proxy) && !visit(table_.entry_of(proxy))) return;
    walk([&box](const Aabb& bounds) { return overlaps(bounds, box); }, visit);
}

void Quadtree::visit_sweep(const BoxSweep& sweep, SweepVisitor& visitor) const
{
    float most = 1;
    const auto visit = [&](const Entry& entry)
    {
        if (sweep.meets(entry.box, most).is_met) most = visitor.visit(entry.proxy);
        return most >= 0;
    };
    for (const ProxyIndex proxy : changed_.list())
        if (table_.holds(proxy) && !visit(table_.entry_of(proxy))) return;
    walk([&](const Aabb& bounds) { return sweep.meets(bounds, most).is_met; }, visit);
}

void Quadtree::list_nodes(std::vector<BroadPhaseNode>& nodes) const
{
    for (const Node& node : nodes_) nodes.push_back({quadtree::bounds_of(root_bounds_, node.index), quadtree::depth_of(node.index)});
}

} // namespace carom::detail
