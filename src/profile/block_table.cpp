// Linear probing; a block that goes pulls those after it back, so that there are no tombstones.
#include "profile/block_table.hpp"

#include <bit>

namespace carom::profile
{

/// Multiplicative hashing: the high bits of a product with a large odd number.
std::size_t BlockTable::home_of(const void* pointer) const
{
    constexpr std::uint64_t odd = 0x9e3779b97f4a7c15; // 2^64 over the golden ratio
    const auto address = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(pointer));
    return static_cast<std::size_t>((address * odd) >> (64 - std::countr_zero(capacity_)));
}

void BlockTable::put(const Block& block)
{
    std::size_t place = home_of(block.pointer);
    while (at(place).pointer) place = after(place);
    at(place) = block;
    ++size_;
}

bool BlockTable::grow()
{
    const std::size_t capacity = capacity_ > 0 ? 2 * capacity_ : 1024;
    Places places(static_cast<Block*>(std::calloc(capacity, sizeof(Block))));
    if (!places) return false;
    const std::size_t old_capacity = capacity_;
    places_.swap(places);
    capacity_ = capacity;
    size_ = 0;
    for (std::size_t i = 0; i < old_capacity; ++i)
    {
        if (places.get()[i].pointer) put(places.get()[i]);
    }
    return true;
}

bool BlockTable::insert(const Block& block)
{
    if (4 * (size_ + 1) > 3 * capacity_ && !grow()) return false;
    put(block);
    return true;
}

std::optional<BlockTable::Block> BlockTable::remove(const void* pointer)
{
    if (size_ == 0 || !pointer) return std::nullopt;
    std::size_t hole = home_of(pointer);
    while (at(hole).pointer != pointer)
    {
        if (!at(hole).pointer) return std::nullopt;
        hole = after(hole);
    }
    const Block removed = at(hole);
    for (std::size_t place = after(hole); at(place).pointer; place = after(place))
    {
        // A block may move back to the hole unless that lies before its home.
        const std::size_t distance = (place - home_of(at(place).pointer)) & (capacity_ - 1);
        if (distance < ((place - hole) & (capacity_ - 1))) continue;
        at(hole) = at(place);
        hole = place;
    }
    at(hole) = {};
    --size_;
    return removed;
}

} // namespace carom::profile
