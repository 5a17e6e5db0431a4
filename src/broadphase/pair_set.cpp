// Linear probing with backward-shift deletion.
#include "broadphase/pair_set.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace carom::detail
{
namespace
{

constexpr std::size_t smallest_capacity = 16;
static_assert(std::has_single_bit(smallest_capacity), "places are cut out of a hash by a mask");

/// Every bit of the key reaches every bit of the result: neighbouring pairs must not fall into neighbouring cells, or runs grow.
/// @source Pelle Evensen's and David Stafford's variants of the MurmurHash3 finaliser ("Mix13", as in SplitMix64)
std::uint64_t mix(std::uint64_t key)
{
    key = (key ^ key >> 30) * 0xbf58476d1ce4e5b9u;
    key = (key ^ key >> 27) * 0x94d049bb133111ebu;
    return key ^ key >> 31;
}

} // namespace

std::size_t PairSet::home_of(Cell cell) const { return static_cast<std::size_t>(mix(cell)) & (cells_.size() - 1); }

/// The place of a cell, or the empty place where it would go. There must be an empty place.
std::size_t PairSet::find(Cell cell) const
{
    std::size_t place = home_of(cell);
    while (cells_[place] != cell && cells_[place] != empty) place = (place + 1) & (cells_.size() - 1);
    return place;
}

bool PairSet::contains(ProxyPair pair) const { return !cells_.empty() && cells_[find(cell_of(pair))] != empty; }

bool PairSet::insert(ProxyPair pair)
{
    assert(pair.a < pair.b);
    if (2 * (size_ + 1) > cells_.size()) reserve(size_ + 1);
    const Cell cell = cell_of(pair);
    const std::size_t place = find(cell);
    if (cells_[place] == cell) return false;
    cells_[place] = cell;
    ++size_;
    return true;
}

bool PairSet::erase(ProxyPair pair)
{
    if (cells_.empty()) return false;
    std::size_t gap = find(cell_of(pair));
    if (cells_[gap] == empty) return false;

    // Pull back each later cell of the run that the gap would hide: one whose home is not between the gap (excluded) and itself,
    // that is, whose distance from home reaches back to the gap at least.
    const std::size_t mask = cells_.size() - 1;
    for (std::size_t next = (gap + 1) & mask; cells_[next] != empty; next = (next + 1) & mask)
    {
        const std::size_t distance_from_home = (next - home_of(cells_[next])) & mask;
        const std::size_t distance_from_gap = (next - gap) & mask;
        if (distance_from_home < distance_from_gap) continue;
        cells_[gap] = cells_[next];
        gap = next;
    }
    cells_[gap] = empty;
    --size_;
    return true;
}

void PairSet::reserve(std::size_t count)
{
    const std::size_t capacity = std::bit_ceil(2 * count < smallest_capacity ? smallest_capacity : 2 * count);
    if (capacity > cells_.size()) rehash(capacity);
}

void PairSet::shrink()
{
    if (size_ == 0)
        cells_ = std::pmr::vector<Cell>(cells_.get_allocator());
    else
        rehash(std::bit_ceil(std::max(smallest_capacity, 2 * size_)));
}

void PairSet::clear()
{
    std::fill(cells_.begin(), cells_.end(), empty);
    size_ = 0;
}

void PairSet::rehash(std::size_t capacity)
{
    std::pmr::vector<Cell> old(capacity, empty, cells_.get_allocator());
    old.swap(cells_);
    for (const Cell cell : old)
        if (cell != empty) cells_[find(cell)] = cell;
}

} // namespace carom::detail
