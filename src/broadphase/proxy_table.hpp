// The proxies of a broad phase in one dense array: what the implementations that look at all of them every time are built on.
#pragma once

#include "broadphase/broad_phase.hpp"

#include <cassert>

namespace carom::detail
{

/// Entries lie in no particular order; removal moves the last one into the gap.
class ProxyTable
{
public:
    struct Entry
    {
        Aabb box;
        ProxyIndex proxy;
        ProxyKind kind;
        bool is_moved; ///< among those that find_pairs was asked for
    };

    explicit ProxyTable(std::pmr::memory_resource& memory) : entries_(&memory), place_of_(&memory) {}

    void insert(ProxyIndex proxy, const Aabb& box, ProxyKind kind)
    {
        if (proxy >= place_of_.size()) place_of_.resize(proxy + std::size_t{1}, absent);
        assert(place_of_[proxy] == absent);
        entries_.push_back({box, proxy, kind, false}); // may throw: nothing points to it yet
        place_of_[proxy] = static_cast<std::uint32_t>(entries_.size() - 1);
    }

    void remove(ProxyIndex proxy)
    {
        const std::uint32_t place = place_of_[proxy];
        assert(place != absent);
        entries_[place] = entries_.back();
        place_of_[entries_[place].proxy] = place;
        place_of_[proxy] = absent;
        entries_.pop_back();
    }

    void update(ProxyIndex proxy, const Aabb& box) { entries_[place_of_[proxy]].box = box; }

    void set_moved(std::span<const ProxyIndex> proxies, bool is_moved)
    {
        for (const ProxyIndex proxy : proxies) entries_[place_of_[proxy]].is_moved = is_moved;
    }

    bool holds(ProxyIndex proxy) const { return proxy < place_of_.size() && place_of_[proxy] != absent; }
    const Entry& entry_of(ProxyIndex proxy) const { return entries_[place_of_[proxy]]; }
    std::span<const Entry> entries() const { return entries_; }
    std::uint32_t place_of(ProxyIndex proxy) const { return place_of_[proxy]; }

private:
    static constexpr std::uint32_t absent = ~std::uint32_t{0};

    std::pmr::vector<Entry> entries_;
    std::pmr::vector<std::uint32_t> place_of_; ///< by proxy
};

/// Queries that look at every box.
inline void visit_all(const ProxyTable& table, const Aabb& box, BoxVisitor& visitor)
{
    for (const ProxyTable::Entry& entry : table.entries())
        if (overlaps(entry.box, box) && !visitor.visit(entry.proxy)) return;
}

inline void visit_all(const ProxyTable& table, const BoxSweep& sweep, SweepVisitor& visitor)
{
    float most = 1;
    for (const ProxyTable::Entry& entry : table.entries())
    {
        if (sweep.meets(entry.box, most).is_met) most = visitor.visit(entry.proxy);
        if (most < 0) return;
    }
}

/// True when the two may be reported as a pair, were their boxes to overlap.
inline bool is_candidate(const ProxyTable::Entry& a, const ProxyTable::Entry& b)
{
    return (a.is_moved | b.is_moved) & ((a.kind == ProxyKind::Moving) | (b.kind == ProxyKind::Moving));
}

inline ProxyPair ordered_pair(ProxyIndex a, ProxyIndex b) { return a < b ? ProxyPair{a, b} : ProxyPair{b, a}; }

/// overlaps() without short-circuits: in a loop over mixed candidates four compares cost less than a mispredicted branch.
inline bool overlaps_branchless(const Aabb& a, const Aabb& b)
{
    return (a.min.x <= b.max.x) & (b.min.x <= a.max.x) & (a.min.y <= b.max.y) & (b.min.y <= a.max.y);
}

} // namespace carom::detail
