// Cuts at the median of the longer axis, except that the few much larger boxes of a set are set apart first.
#include "broadphase/box_tree_split.hpp"

#include <algorithm>
#include <cstddef>

namespace carom::detail
{
namespace
{

/// A box is large beside another when it is more than this many times its size. Bodies of one scene often differ by a factor of two
/// or three, and setting those apart would cost more (two groups on the same ground) than it saves.
constexpr float large_ratio = 4;
/// Large boxes are set apart when they are as large as this share of the ground that the set covers: smaller ones spoil few nodes.
constexpr float large_share = 1.0f / 16;
/// ... and when at most one in this many is large; else they are the rule, and the median does.
constexpr std::size_t large_rarity = 4;
/// Sets up to this size are not worth it.
constexpr std::size_t smallest_mixed_set = 16;

struct Spread
{
    Vec2 extent; ///< of the centres
    float largest = 0;
};

Spread spread_of(std::span<const BuildItem> items)
{
    Vec2 low = items[0].center;
    Vec2 high = items[0].center;
    float largest = 0;
    for (const BuildItem& item : items)
    {
        low = min(low, item.center);
        high = max(high, item.center);
        largest = std::max(largest, item.size);
    }
    return {high - low, largest}; // may overflow to infinity, which compares as it should
}

/// Puts the large boxes first. @return how many, 0 when the set shall stay together
///
/// A large box among small ones stretches its node, that node's parent and so on: everything near meets them all. Each time
/// that this divides, the largest size of the rest falls fourfold, so it happens at most 140 times on the way down.
std::size_t set_large_apart(std::span<BuildItem> items, const Spread& spread)
{
    const float ground = std::max(spread.extent.x, spread.extent.y);
    if (items.size() < smallest_mixed_set || !(spread.largest > large_share * ground)) return 0;
    const float limit = spread.largest / large_ratio;
    const auto is_large = [limit](const BuildItem& item) { return item.size > limit; };
    const auto count = static_cast<std::size_t>(std::count_if(items.begin(), items.end(), is_large));
    if (count * large_rarity > items.size()) return 0;
    std::partition(items.begin(), items.end(), is_large);
    return count;
}

/// The largest power of four below the count: as many as a full child of this node holds.
std::size_t full_child(std::size_t count)
{
    std::size_t unit = 4;
    while (unit * 4 < count) unit *= 4;
    return unit;
}

/// Cuts near the middle, at a whole number of full children, so that the lowest nodes, which are most of the tree, come out full.
std::size_t split_at_median(std::span<BuildItem> items, const Spread& spread, std::size_t unit)
{
    const std::size_t units = (items.size() + unit - 1) / unit;
    const std::size_t middle = std::min((units + 1) / 2 * unit, items.size() - 1);
    const auto by_x = [](const BuildItem& a, const BuildItem& b) { return a.center.x < b.center.x; };
    const auto by_y = [](const BuildItem& a, const BuildItem& b) { return a.center.y < b.center.y; };
    const auto at = items.begin() + static_cast<std::ptrdiff_t>(middle);
    if (spread.extent.x >= spread.extent.y)
        std::nth_element(items.begin(), at, items.end(), by_x);
    else
        std::nth_element(items.begin(), at, items.end(), by_y);
    return middle;
}

std::size_t split(std::span<BuildItem> items, std::size_t unit)
{
    const Spread spread = spread_of(items);
    const std::size_t large = set_large_apart(items, spread);
    return large > 0 ? large : split_at_median(items, spread, unit);
}

} // namespace

BuildItem build_item(const Aabb& box, std::uint32_t source)
{
    // Halves first: the sum of two huge coordinates would overflow.
    const Vec2 low = 0.5f * box.min;
    const Vec2 high = 0.5f * box.max;
    return {low + high, std::max(high.x - low.x, high.y - low.y), source};
}

BuildGroups divide(std::span<BuildItem> items)
{
    const std::size_t unit = full_child(items.size());
    BuildGroups groups;
    groups.group[groups.count++] = items;
    while (groups.count < 4)
    {
        // By count, not by area: it bounds the depth whatever the boxes are.
        unsigned widest = 0;
        for (unsigned i = 1; i < groups.count; ++i)
            if (groups.group[i].size() > groups.group[widest].size()) widest = i;
        const std::span<BuildItem> whole = groups.group[widest];
        if (whole.size() <= unit) break;
        const std::size_t at = split(whole, unit);
        groups.group[widest] = whole.first(at);
        groups.group[groups.count++] = whole.subspan(at);
    }
    return groups;
}

} // namespace carom::detail
