// Where to divide a set of boxes, for building a tree of boxes from the top.
#pragma once

#include <carom/math.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace carom::detail
{

/// A box as the builder sees it.
struct BuildItem
{
    Vec2 center;
    float size;           ///< half of the longer side
    std::uint32_t source; ///< which box it is, for the caller
};

BuildItem build_item(const Aabb& box, std::uint32_t source);

/// Up to four parts of a set, the children of one node.
struct BuildGroups
{
    std::array<std::span<BuildItem>, 4> group;
    unsigned count = 0;
};

/// Reorders the items and cuts them into two to four groups, none empty and each smaller than the whole.
/// @param items more than four
BuildGroups divide(std::span<BuildItem> items);

} // namespace carom::detail
