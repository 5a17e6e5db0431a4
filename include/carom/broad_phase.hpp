// Which broad phase a world uses to find the shapes that are near each other. All find the same pairs.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace carom
{

enum class BroadPhaseType
{
    BruteForce,      ///< every pair: the reference
    QuadtreeNaive,   ///< a shape in every leaf that it touches, pairs in a hash set: what one writes first. A step allocates
    QuadtreeWithSet, ///< a flat quadtree, a shape once in the deepest node that holds it, pairs still in a hash set. A step allocates
    Quadtree,        ///< the same without the set
    Tree             ///< a wide tree of bounding boxes: the default and the fastest
};

/// From the simplest to the fastest.
inline constexpr std::array all_broad_phases = {BroadPhaseType::BruteForce, BroadPhaseType::QuadtreeNaive, BroadPhaseType::QuadtreeWithSet,
                                                BroadPhaseType::Quadtree, BroadPhaseType::Tree};

/// "BruteForce", "QuadtreeNaive", "QuadtreeWithSet", "Quadtree", "Tree".
std::string_view name_of(BroadPhaseType type);
/// The one that name_of gives this name; empty when there is none.
std::optional<BroadPhaseType> broad_phase_named(std::string_view name);

/// Options of the three quadtrees; the others do not read them.
struct BroadPhaseOptions
{
    int quadtree_max_depth = 5;     ///< levels below the root, 0 to 10
    int quadtree_node_capacity = 8; ///< shapes in a node before it divides, >= 1

    friend bool operator==(const BroadPhaseOptions&, const BroadPhaseOptions&) = default;
};

/// What the search for pairs of one step did.
struct BroadPhaseStats
{
    std::size_t pairs_tested =
        0; ///< fattened bounds compared with those of shapes, by the tree four at a time; 0 when no shape has left its bounds
    std::size_t pairs_found =
        0;                 ///< of those, pairs that overlap and of which at least one shape has left its bounds: new ones and known ones
    std::size_t nodes = 0; ///< nodes in use after the last search; 0 where there are none

    friend bool operator==(const BroadPhaseStats&, const BroadPhaseStats&) = default;
};

} // namespace carom
