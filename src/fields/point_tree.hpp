// A quadtree over points with buckets as leaves, in depth-first order.
#pragma once

#include "broadphase/radix_sort.hpp"

#include <carom/math.hpp>

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// The cells are those of the broad phase's quadtree (`quadtree_layout.hpp`: Morton codes, quadrants), but nodes are not at 4i+1..4i+4.
/// Bodies under gravity clump over many orders of magnitude, and a flat array has room for 10 levels where a cluster may need 40. So
/// only nodes in use are stored, each before its descendants, with a link past them: a walk is one loop without a stack.
///
/// Points are sorted by Morton code once, to 15 levels. A cell of the 15th level that is still too full gets a grid of its own over the
/// box around its points. A node with a single child is never made, so there are fewer inner nodes than leaves, however points lie.
class PointTree
{
public:
    struct Node
    {
        Aabb bounds;         ///< around its points, within its cell
        std::uint32_t begin; ///< its points: order()[begin..end)
        std::uint32_t end;
        std::uint32_t next; ///< the first node after its descendants
        bool is_leaf;
    };

    explicit PointTree(std::pmr::memory_resource& memory) : nodes_(&memory), keys_(&memory), scratch_(&memory) {}

    /// @param points      finite
    /// @param bucket_size points that a node holds before it divides; points at one place never divide
    void build(std::span<const Vec2> points, std::uint32_t bucket_size);

    /// Puts the bounds around points that have moved a little since the tree was built, which then holds as it is.
    /// @param points as many as then
    void refit(std::span<const Vec2> points);

    std::span<const Node> nodes() const { return nodes_; }
    /// Points in depth-first order.
    std::uint32_t point_at(std::size_t place) const { return keys_[place].index; }

private:
    static constexpr int no_grid = -1;

    std::uint32_t add_node(std::span<const Vec2> points, std::uint32_t bucket_size, std::uint32_t begin, std::uint32_t end, int depth);
    Aabb bounds_of(std::span<const Vec2> points, std::uint32_t begin, std::uint32_t end) const;
    bool lay_grid(std::span<const Vec2> points, std::uint32_t begin, std::uint32_t end);

    std::pmr::vector<Node> nodes_;
    std::pmr::vector<SortKey> keys_; ///< Morton code in the innermost grid, point
    std::pmr::vector<SortKey> scratch_;
};

} // namespace carom::detail
