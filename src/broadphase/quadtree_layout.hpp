// The arithmetic of a quadtree in a flat array: which node is whose child, where it lies, and which cell a point falls into.
//
//     depth 0: node 0              quadrants of a node:   2 | 3      (bit 0: right half,
//     depth 1: nodes 1..4                                 --+--       bit 1: upper half)
//     depth 2: nodes 5..20                                0 | 1
//     children of node i: 4i + 1 .. 4i + 4
//
// Within a depth the nodes lie in Morton order, the order of their interleaved cell coordinates: node = first_node(depth) + morton.
#pragma once

#include <carom/math.hpp>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>

namespace carom::detail::quadtree
{

/// Deeper than any tree here goes; cell coordinates have this many bits.
inline constexpr int deepest = 15;

constexpr std::uint32_t child_of(std::uint32_t node, unsigned quadrant) { return 4 * node + 1 + quadrant; }
constexpr std::uint32_t parent_of(std::uint32_t node) { return (node - 1) / 4; }
constexpr unsigned quadrant_of(std::uint32_t node) { return (node - 1) % 4; }

/// The number of nodes above a depth: 1 + 4 + ... + 4^(depth - 1) = (4^depth - 1) / 3.
constexpr std::uint32_t first_node(int depth) { return ((std::uint32_t{1} << 2 * depth) - 1) / 3; }
constexpr std::uint32_t node_count(int max_depth) { return first_node(max_depth + 1); }

constexpr int depth_of(std::uint32_t node)
{
    int depth = 0;
    while (first_node(depth + 1) <= node) ++depth;
    return depth;
}

/// A quarter of a box. The four share their edges, so together they cover it whatever the rounding.
constexpr Aabb quarter(const Aabb& box, unsigned quadrant)
{
    const Vec2 middle{0.5f * box.min.x + 0.5f * box.max.x, 0.5f * box.min.y + 0.5f * box.max.y}; // the sum could overflow
    const bool is_right = quadrant & 1;
    const bool is_upper = quadrant & 2;
    return {{is_right ? middle.x : box.min.x, is_upper ? middle.y : box.min.y},
            {is_right ? box.max.x : middle.x, is_upper ? box.max.y : middle.y}};
}

/// The bounds of a node of the tree whose root has these.
constexpr Aabb bounds_of(const Aabb& root, std::uint32_t node)
{
    return node == 0 ? root : quarter(bounds_of(root, parent_of(node)), quadrant_of(node));
}

/// Moves bit i to bit 2i, for 16 bits.
constexpr std::uint32_t spread_bits(std::uint32_t v)
{
    v = (v | v << 8) & 0x00ff00ffu;
    v = (v | v << 4) & 0x0f0f0f0fu;
    v = (v | v << 2) & 0x33333333u;
    return (v | v << 1) & 0x55555555u;
}

/// The Morton code of a cell: the quadrant at depth 1 in the highest bits, down to the last one in the lowest.
constexpr std::uint32_t morton(std::uint32_t x, std::uint32_t y) { return spread_bits(x) | spread_bits(y) << 1; }

/// The quadrant that the way to a cell at `cell_depth` takes below a node at `depth`.
constexpr unsigned quadrant_at(std::uint32_t code, int cell_depth, int depth) { return code >> 2 * (cell_depth - depth - 1) & 3; }

/// The depth of the deepest node that holds both cells, which lie at `cell_depth`: as many quadrants as their codes have in common.
constexpr int common_depth(std::uint32_t code_a, std::uint32_t code_b, int cell_depth)
{
    return cell_depth - (static_cast<int>(std::bit_width(code_a ^ code_b)) + 1) / 2;
}

/// The distance of two floats, which may be no finite float.
constexpr double extent(float min, float max) { return static_cast<double>(max) - static_cast<double>(min); }

/// The cells of one depth. Coordinates outside the root count as being on its edge.
class Grid
{
public:
    /// @param min    of the root
    /// @param extent of the root [m], >= 0
    Grid(Vec2 min, double extent_x, double extent_y, int depth)
        : min_x_(min.x),
          min_y_(min.y),
          scale_x_(scale(extent_x, depth)),
          scale_y_(scale(extent_y, depth)),
          last_cell_(static_cast<double>((1 << depth) - 1))
    {
        assert(depth <= deepest);
    }

    /// The box cut into cells of its own proportions.
    Grid(const Aabb& root, int depth) : Grid(root.min, extent(root.min.x, root.max.x), extent(root.min.y, root.max.y), depth) {}

    /// Monotone in both coordinates: if boxes overlap, the ranges of their cells do.
    std::uint32_t code(Vec2 p) const
    {
        return morton(cell((static_cast<double>(p.x) - min_x_) * scale_x_), cell((static_cast<double>(p.y) - min_y_) * scale_y_));
    }

private:
    static double scale(double extent, int depth) { return extent > 0 ? static_cast<double>(1 << depth) / extent : 0; }

    std::uint32_t cell(double at) const { return static_cast<std::uint32_t>(std::clamp(at, 0.0, last_cell_)); }

    double min_x_;
    double min_y_;
    double scale_x_;
    double scale_y_;
    double last_cell_;
};

} // namespace carom::detail::quadtree
