// Builds the tree by sorting points along the Morton curve and cutting the sorted range at quadrants.
#include "fields/point_tree.hpp"

#include "broadphase/quadtree_layout.hpp"

#include <algorithm>

namespace carom::detail
{

void PointTree::build(std::span<const Vec2> points, std::uint32_t bucket_size)
{
    nodes_.clear();
    nodes_.reserve(8 * points.size() / bucket_size + 16); // several times what points spread evenly need, so that they rarely ask for more
    keys_.clear();
    scratch_.resize(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) keys_.push_back({0, i});
    if (!points.empty()) add_node(points, bucket_size, 0, static_cast<std::uint32_t>(points.size()), no_grid);
}

void PointTree::refit(std::span<const Vec2> points)
{
    for (std::size_t n = nodes_.size(); n-- > 0;) // descendants first
    {
        Node& node = nodes_[n];
        if (node.is_leaf)
            node.bounds = bounds_of(points, node.begin, node.end);
        else
        {
            node.bounds = nodes_[n + 1].bounds;
            for (std::size_t child = nodes_[n + 1].next; child < node.next; child = nodes_[child].next)
                node.bounds = merge(node.bounds, nodes_[child].bounds);
        }
    }
}

Aabb PointTree::bounds_of(std::span<const Vec2> points, std::uint32_t begin, std::uint32_t end) const
{
    Aabb bounds{points[keys_[begin].index], points[keys_[begin].index]};
    for (std::uint32_t i = begin; i < end; ++i) bounds = {min(bounds.min, points[keys_[i].index]), max(bounds.max, points[keys_[i].index])};
    return bounds;
}

/// Makes the node of a range of points, with its descendants.
/// @param depth of the node's cell in the innermost grid
///
/// Recursion is bounded: a grid has 15 levels, and the next one starts on a cell 2^15 times smaller, which the range of floats allows
/// less than 20 times.
std::uint32_t PointTree::add_node(std::span<const Vec2> points, std::uint32_t bucket_size, std::uint32_t begin, std::uint32_t end,
                                  int depth)
{
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({{}, begin, end, 0, true});
    Aabb bounds{points[keys_[begin].index], points[keys_[begin].index]};

    bool is_leaf = end - begin <= bucket_size;
    if (!is_leaf)
    {
        // Down to the depth where the points part; in a new grid when the old one does not tell them apart.
        if (depth != no_grid) depth = quadtree::common_depth(keys_[begin].key, keys_[end - 1].key, quadtree::deepest);
        if (depth == no_grid || depth == quadtree::deepest)
        {
            is_leaf = !lay_grid(points, begin, end);
            depth = 0;
        }
    }
    if (is_leaf)
        bounds = bounds_of(points, begin, end);
    else
    {
        const auto quadrant_of_point = [this, depth](std::uint32_t i)
        { return quadtree::quadrant_at(keys_[i].key, quadtree::deepest, depth); };
        for (std::uint32_t child_begin = begin; child_begin < end;)
        {
            std::uint32_t child_end = child_begin + 1;
            while (child_end < end && quadrant_of_point(child_end) == quadrant_of_point(child_begin)) ++child_end;
            // The child may sort its range anew, but within the range.
            bounds = merge(bounds, nodes_[add_node(points, bucket_size, child_begin, child_end, depth + 1)].bounds);
            child_begin = child_end;
        }
    }
    nodes_[place] = {bounds, begin, end, static_cast<std::uint32_t>(nodes_.size()), is_leaf};
    return place;
}

/// Sorts a range of points by their cells in a square grid around them. @return false when they are all at one place, or when one of them
/// is at none: a body whose state is not finite any more is looked at until the step ends
bool PointTree::lay_grid(std::span<const Vec2> points, std::uint32_t begin, std::uint32_t end)
{
    const std::span<SortKey> keys = std::span<SortKey>(keys_).subspan(begin, end - begin);
    Aabb bounds{points[keys[0].index], points[keys[0].index]};
    bool are_finite = true;
    for (const SortKey& key : keys)
    {
        are_finite &= is_finite(points[key.index]);
        bounds = {min(bounds.min, points[key.index]), max(bounds.max, points[key.index])};
    }
    if (!are_finite || bounds.min == bounds.max) return false;

    const double side = std::max(quadtree::extent(bounds.min.x, bounds.max.x), quadtree::extent(bounds.min.y, bounds.max.y));
    const quadtree::Grid grid(bounds.min, side, side, quadtree::deepest);
    for (SortKey& key : keys) key.key = grid.code(points[key.index]);
    radix_sort(keys, scratch_, 2 * quadtree::deepest);
    return true;
}

} // namespace carom::detail
