// What every broad phase does: keep the boxes of shapes, find the pairs that came to overlap, and answer queries.
#pragma once

#include "broadphase/box_sweep.hpp"
#include "broadphase/pair_list.hpp"
#include "broadphase/query_gate.hpp"

#include <carom/broad_phase.hpp>
#include <carom/math.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// Shapes that never move are kept apart from those that do: two Static proxies are never a pair.
enum class ProxyKind : std::uint8_t
{
    Static,
    Moving
};

/// A node, for drawing.
struct BroadPhaseNode
{
    Aabb bounds;
    int depth = 0; ///< the root has 0
};

/// Sees the boxes that a query meets, in an order that is the implementation's own.
class BoxVisitor
{
public:
    /// @return false to end the query
    virtual bool visit(ProxyIndex proxy) = 0;

protected:
    ~BoxVisitor() = default;
};

/// Sees the boxes that a sweep may meet, roughly from the near to the far.
class SweepVisitor
{
public:
    /// @return the fraction of the sweep up to which boxes still matter, not more than before; negative to end the query
    virtual float visit(ProxyIndex proxy) = 0;

protected:
    ~SweepVisitor() = default;
};

/// Keeps the (fattened) boxes of proxies. The boxes are any finite ones: huge, empty of area, all negative.
/// After its arrays have grown to the size of the work, no call allocates, but those of QuadtreeNaive and
/// QuadtreeWithSet, whose sets make a cell for each pair.
class BroadPhase
{
public:
    virtual ~BroadPhase() = default;

    virtual BroadPhaseType type() const = 0;

    /// Room for so many proxies, so that fewer do not make it grow; not all implementations know how.
    virtual void reserve(std::size_t /*proxies*/) {}

    /// @param proxy not in yet
    virtual void insert(ProxyIndex proxy, const Aabb& box, ProxyKind kind) = 0;
    virtual void remove(ProxyIndex proxy) = 0;
    /// Gives a proxy a new box.
    virtual void update(ProxyIndex proxy, const Aabb& box) = 0;

    /// Adds every pair of overlapping boxes of which at least one is among `moved` and at least one is Moving. Each pair comes
    /// once. The order is the implementation's own: the caller sorts what it keeps. Ends early when the list is full.
    /// @param moved   in any order, without repetition, all of them in; may hold Static ones (they were inserted or teleported)
    void find_pairs(std::span<const ProxyIndex> moved, PairList& pairs)
    {
        const std::size_t found_before = pairs.found();
        search_pairs(moved, pairs);
        stats_.pairs_found = pairs.found() - found_before;
    }
    /// All of them.
    void find_pairs(std::span<const ProxyIndex> moved, std::pmr::vector<ProxyPair>& pairs)
    {
        PairList list(pairs);
        find_pairs(moved, list);
    }

    /// The same outside of the search of a step, whose counts of pairs stand.
    void find_more_pairs(std::span<const ProxyIndex> moved, PairList& pairs)
    {
        const BroadPhaseStats kept = stats_;
        search_pairs(moved, pairs);
        stats_ = {kept.pairs_tested, kept.pairs_found, stats_.nodes};
    }

    // Queries see the boxes as they are at the moment, whether or not find_pairs was called since. Several threads may query at once, while
    // nobody changes anything. They are not const because the first one after a change brings the structure up to date; it costs no
    // more than what changed, and what is new is built in when it has become much. Only that may allocate, and a query that runs out of memory there has
    // changed nothing.

    /// Visits every proxy whose box shares at least a point with the given one, each once.
    void query(const Aabb& box, BoxVisitor& visitor)
    {
        gate_.pass([this] { prepare_queries(); });
        visit_boxes(box, visitor);
    }

    /// Visits every proxy whose box the sweep meets (`sweep.meets`) up to the fraction that still matters, each once.
    void query(const BoxSweep& sweep, SweepVisitor& visitor)
    {
        gate_.pass([this] { prepare_queries(); });
        visit_sweep(sweep, visitor);
    }

    /// Appends the nodes as they are after the last find_pairs; nothing when there are none to show.
    virtual void list_nodes(std::vector<BroadPhaseNode>& nodes) const = 0;

    /// Counters of the last find_pairs.
    BroadPhaseStats stats() const { return stats_; }
    /// In place of a find_pairs without a moved proxy: the nodes stay as they are.
    void skip_search() { stats_.pairs_tested = stats_.pairs_found = 0; }

protected:
    /// Called by everything that changes a box.
    void close_queries() { gate_.close(); }

    BroadPhaseStats stats_;

private:
    /// Counts what it tests and its nodes in stats_.
    virtual void search_pairs(std::span<const ProxyIndex> moved, PairList& pairs) = 0;
    virtual void prepare_queries() = 0;
    virtual void visit_boxes(const Aabb& box, BoxVisitor& visitor) const = 0;
    virtual void visit_sweep(const BoxSweep& sweep, SweepVisitor& visitor) const = 0;

    QueryGate gate_;
};

/// Makes one; it takes all its memory from `memory`, itself included.
struct BroadPhaseDelete
{
    std::pmr::memory_resource* memory = nullptr;
    std::size_t size = 0;
    std::size_t alignment = 0;
    void operator()(BroadPhase* broad_phase) const;
};
using BroadPhasePtr = std::unique_ptr<BroadPhase, BroadPhaseDelete>;

BroadPhasePtr make_broad_phase(BroadPhaseType type, const BroadPhaseOptions& options, std::pmr::memory_resource& memory);

} // namespace carom::detail
