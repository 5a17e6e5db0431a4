// Inserting each shape from the root, then comparing all the shapes of each leaf.
#include "broadphase/quadtree_naive.hpp"

#include "broadphase/quadtree_layout.hpp"

namespace carom::detail
{

QuadtreeNaive::QuadtreeNaive(const BroadPhaseOptions& options, std::pmr::memory_resource& memory)
    : max_depth_(std::clamp(options.quadtree_max_depth, 0, 10)),
      node_capacity_(static_cast<std::size_t>(std::max(options.quadtree_node_capacity, 1))),
      table_(memory),
      pool_(&memory),
      nodes_(&pool_),
      found_(&memory)
{
}

void QuadtreeNaive::search_pairs(std::span<const ProxyIndex> moved, PairList& pairs)
{
    stats_ = {};
    node_count_ = 0;
    const std::span<const ProxyTable::Entry> entries = table_.entries();
    if (entries.empty()) return;

    table_.set_moved(moved, true);
    Aabb bounds = entries[0].box;
    for (const ProxyTable::Entry& entry : entries) bounds = merge(bounds, entry.box);
    add_node(bounds, 0);
    for (std::uint32_t i = 0; i < entries.size(); ++i) insert_below(0, i);

    found_.clear();
    for (std::size_t n = 0; n < node_count_ && !pairs.is_full(); ++n)
    {
        const std::pmr::vector<std::uint32_t>& shapes = nodes_[n].shapes;
        for (std::size_t i = 0; i < shapes.size() && !pairs.is_full(); ++i)
        {
            const ProxyTable::Entry& self = entries[shapes[i]];
            for (std::size_t j = i + 1; j < shapes.size(); ++j)
            {
                const ProxyTable::Entry& other = entries[shapes[j]];
                if (!is_candidate(self, other)) continue;
                ++stats_.pairs_tested;
                if (!overlaps(self.box, other.box)) continue;
                const ProxyPair pair = ordered_pair(self.proxy, other.proxy);
                if (found_.insert(pair).second) pairs.add(pair);
            }
        }
    }
    table_.set_moved(moved, false);
    stats_.nodes = node_count_;
}

std::uint32_t QuadtreeNaive::add_node(const Aabb& bounds, int depth)
{
    if (node_count_ == nodes_.size()) nodes_.emplace_back(nodes_.get_allocator());
    Node& node = nodes_[node_count_];
    node.bounds = bounds;
    node.depth = depth;
    node.first_child = 0;
    node.shapes.clear();
    return static_cast<std::uint32_t>(node_count_++);
}

/// Recursion ends at depth 10.
void QuadtreeNaive::insert_below(std::uint32_t index, std::uint32_t shape)
{
    if (!overlaps(nodes_[index].bounds, table_.entries()[shape].box)) return;
    if (nodes_[index].first_child == 0)
    {
        nodes_[index].shapes.push_back(shape);
        if (is_worth_dividing(nodes_[index])) divide(index);
        return;
    }
    for (unsigned quadrant = 0; quadrant < 4; ++quadrant) insert_below(nodes_[index].first_child + quadrant, shape);
}

/// A shape that covers the whole node would be in all four children, so a node that is full of such ones can't be helped by dividing.
/// Without this, nine shapes as large as the world would fill a tree of depth 10 with a million leaves.
bool QuadtreeNaive::is_worth_dividing(const Node& node) const
{
    if (node.shapes.size() <= node_capacity_ || node.depth == max_depth_) return false;
    std::size_t covering = 0;
    for (const std::uint32_t shape : node.shapes) covering += contains(table_.entries()[shape].box, node.bounds);
    return covering < node_capacity_;
}

void QuadtreeNaive::divide(std::uint32_t index)
{
    const Aabb bounds = nodes_[index].bounds;
    const int depth = nodes_[index].depth;
    std::uint32_t first_child = 0;
    for (unsigned quadrant = 0; quadrant < 4; ++quadrant)
    {
        const std::uint32_t child = add_node(quadtree::quarter(bounds, quadrant), depth + 1);
        if (quadrant == 0) first_child = child;
    }
    nodes_[index].first_child = first_child;
    for (std::size_t i = 0; i < nodes_[index].shapes.size(); ++i) // by index: dividing deeper may move the nodes
        for (unsigned quadrant = 0; quadrant < 4; ++quadrant) insert_below(first_child + quadrant, nodes_[index].shapes[i]);
    nodes_[index].shapes.clear();
}

void QuadtreeNaive::list_nodes(std::vector<BroadPhaseNode>& nodes) const
{
    for (std::size_t i = 0; i < node_count_; ++i) nodes.push_back({nodes_[i].bounds, nodes_[i].depth});
}

} // namespace carom::detail
