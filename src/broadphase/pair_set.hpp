// A hash set of proxy pairs: answers "is there a contact for this pair already?".
#pragma once

#include "broadphase/broad_phase.hpp"

namespace carom::detail
{

/// Open addressing with linear probing in one array; at most half full, so a look-up usually touches one cache line. Removal closes
/// the gap that it leaves, so the set does not age. It can't be iterated: its order depends on the hash and must never show.
class PairSet
{
public:
    explicit PairSet(std::pmr::memory_resource& memory) : cells_(&memory) {}

    /// @return false when the pair is in already
    bool insert(ProxyPair pair);
    /// @return false when the pair is not in
    bool erase(ProxyPair pair);
    bool contains(ProxyPair pair) const;

    std::size_t size() const { return size_; }
    /// Makes room for `count` pairs, so that inserting up to that many allocates nothing.
    void reserve(std::size_t count);
    /// Gives back the memory that the pairs do not need.
    void shrink();
    /// Forgets the pairs, keeps the memory.
    void clear();

private:
    using Cell = std::uint64_t; ///< a in the upper half, b in the lower

    /// No pair: both halves would be the largest index, and a < b.
    static constexpr Cell empty = ~Cell{0};

    static Cell cell_of(ProxyPair pair) { return Cell{pair.a} << 32 | pair.b; }
    std::size_t home_of(Cell cell) const;
    std::size_t find(Cell cell) const;
    void rehash(std::size_t capacity);

    std::pmr::vector<Cell> cells_; ///< as many as a power of two, or none
    std::size_t size_ = 0;
};

} // namespace carom::detail
