// Walking pairs of nodes with a stack of our own.
#include "broadphase/pair_walk.hpp"

#include <bit>

namespace carom::detail
{
namespace
{

using Meetings = unsigned;

constexpr unsigned all_lanes = 15;

/// Calls do_with(i, j) for each meeting. One loop over 16 bits, because each end of a loop is a branch that the processor guesses wrong.
template <class Do>
void for_each_meeting(Meetings meetings, Do do_with)
{
    for (; meetings != 0; meetings &= meetings - 1)
    {
        const auto bit = static_cast<unsigned>(std::countr_zero(meetings));
        do_with(bit / 4, bit % 4);
    }
}

/// The lanes of a node that may form a pair with lane `lane` of another: all, when that one has moved; else those that have.
unsigned partners(unsigned moved_here, unsigned lane, unsigned moved_there) { return moved_here >> lane & 1 ? all_lanes : moved_there; }

Meetings meetings_of(const BoxTree& tree_a, std::uint32_t a, const BoxTree& tree_b, std::uint32_t b)
{
    const unsigned moved_a = tree_a.node(a).moved;
    const unsigned moved_b = tree_b.node(b).moved;
    Meetings meetings = 0;
    for (unsigned i = 0; i < 4; ++i)
        meetings |= (overlap_bits(get_box(tree_a.boxes(a), i), tree_b.boxes(b)) & partners(moved_a, i, moved_b)) << 4 * i;
    return meetings;
}

void emit(const TreeNode& a, const TreeNode& b, Meetings meetings, PairList& pairs)
{
    for_each_meeting(meetings,
                     [&](unsigned i, unsigned j) { pairs.add({std::min(a.child[i], b.child[j]), std::max(a.child[i], b.child[j])}); });
}

} // namespace

void PairWalk::within(const BoxTree& tree, PairList& pairs)
{
    if (tree.is_empty()) return;
    stack_.push_back({0, 0});
    while (!stack_.empty() && !pairs.is_full())
    {
        const NodePair top = stack_.back();
        stack_.pop_back();
        if (top.a == top.b)
            visit_node(tree, top.a, pairs);
        else
            visit_pair(tree, tree, top, pairs);
    }
    stack_.clear();
}

void PairWalk::between(const BoxTree& tree_a, const BoxTree& tree_b, PairList& pairs)
{
    if (tree_a.is_empty() || tree_b.is_empty()) return;
    stack_.push_back({0, 0});
    while (!stack_.empty() && !pairs.is_full())
    {
        const NodePair top = stack_.back();
        stack_.pop_back();
        visit_pair(tree_a, tree_b, top, pairs);
    }
    stack_.clear();
}

void PairWalk::queries_within(const BoxTree& tree, PairList& pairs)
{
    // Two that moved find each other twice: the lower one reports.
    const auto is_reported = [](ProxyIndex self, ProxyIndex other, bool has_other_moved) { return !has_other_moved || self < other; };
    query_each_moved(tree, tree, pairs, is_reported);
}

void PairWalk::queries_between(const BoxTree& tree_a, const BoxTree& tree_b, PairList& pairs)
{
    query_each_moved(tree_a, tree_b, pairs, [](ProxyIndex, ProxyIndex, bool) { return true; });
    query_each_moved(tree_b, tree_a, pairs, [](ProxyIndex, ProxyIndex, bool has_other_moved) { return !has_other_moved; });
}

/// Looks up the moved proxies of one tree in another, in the order of their leaves, so that one query finds the nodes of the one before
/// in the cache.
template <class IsReported>
void PairWalk::query_each_moved(const BoxTree& from, const BoxTree& in, PairList& pairs, IsReported is_reported)
{
    if (in.is_empty()) return;
    for (const std::uint32_t index : from.moved_nodes())
    {
        const TreeNode& leaf = from.node(index);
        if (pairs.is_full()) return;
        if (!leaf.is_leaf) continue;
        for (unsigned lane = 0; lane < 4; ++lane)
        {
            if (!(leaf.moved >> lane & 1)) continue;
            const ProxyIndex self = leaf.child[lane];
            const auto report = [&](ProxyIndex other, bool has_other_moved)
            {
                if (other != self && is_reported(self, other, has_other_moved)) pairs.add({std::min(self, other), std::max(self, other)});
            };
            query(in, get_box(from.boxes(index), lane), report);
        }
    }
}

template <class Report>
void PairWalk::query(const BoxTree& tree, const Aabb& box, Report report)
{
    stack_.push_back({0, 0});
    while (!stack_.empty())
    {
        const std::uint32_t index = stack_.back().a;
        stack_.pop_back();
        const TreeNode& node = tree.node(index);
        unsigned bits = overlap_bits(box, tree.boxes(index));
        if (node.is_leaf) pairs_tested += 4;
        for (; bits != 0; bits &= bits - 1)
        {
            const auto lane = static_cast<unsigned>(std::countr_zero(bits));
            if (node.is_leaf)
                report(node.child[lane], node.moved >> lane & 1);
            else
                stack_.push_back({node.child[lane], 0});
        }
    }
}

/// The pairs inside one node: each child with the later ones, and, below, with itself.
void PairWalk::visit_node(const BoxTree& tree, std::uint32_t index, PairList& pairs)
{
    constexpr Meetings with_later = 0b0000'1000'1100'1110;
    constexpr Meetings with_itself = 0b1000'0100'0010'0001;
    const TreeNode& node = tree.node(index);
    const Meetings meetings = meetings_of(tree, index, tree, index);
    if (node.is_leaf)
    {
        pairs_tested += 6;
        emit(node, node, meetings & with_later, pairs);
    }
    else
    {
        push(node, node, meetings & (with_later | with_itself));
    }
}

/// The pairs of one child of node a with one of node b.
void PairWalk::visit_pair(const BoxTree& tree_a, const BoxTree& tree_b, NodePair nodes, PairList& pairs)
{
    const TreeNode& a = tree_a.node(nodes.a);
    const TreeNode& b = tree_b.node(nodes.b);
    const Meetings meetings = meetings_of(tree_a, nodes.a, tree_b, nodes.b);
    if (a.is_leaf && b.is_leaf)
    {
        pairs_tested += 16;
        emit(a, b, meetings, pairs);
    }
    else if (a.is_leaf)
    {
        for (unsigned j = 0; j < 4; ++j)
            if (meetings & 0x1111u << j) stack_.push_back({nodes.a, b.child[j]});
    }
    else if (b.is_leaf)
    {
        for (unsigned i = 0; i < 4; ++i)
            if (meetings & 0xfu << 4 * i) stack_.push_back({a.child[i], nodes.b});
    }
    else
    {
        push(a, b, meetings);
    }
}

void PairWalk::push(const TreeNode& a, const TreeNode& b, Meetings meetings)
{
    for_each_meeting(meetings, [&](unsigned i, unsigned j) { stack_.push_back({a.child[i], b.child[j]}); });
}

} // namespace carom::detail
