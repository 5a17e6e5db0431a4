// Goes down the tree with a stack on the machine's own, so that queries neither allocate nor share anything.
#include "broadphase/tree_query.hpp"

#include <array>
#include <bit>
#include <cassert>

namespace carom::detail
{
namespace
{

/// Nodes that wait at one time: three siblings on each level. A tree has at most 140 levels that set large boxes apart (see
/// box_tree_split.cpp) and 16 that cut a count of at most 2^32 in four.
constexpr std::size_t most_nodes = 3 * (140 + 16) + 4;

template <class T>
class Stack
{
public:
    bool is_empty() const { return size_ == 0; }
    void push(T item)
    {
        assert(size_ < most_nodes);
        items_[size_++] = item;
    }
    T pop() { return items_[--size_]; }

private:
    std::array<T, most_nodes> items_; // left as it is: filling it would cost more than most queries
    std::size_t size_ = 0;
};

/// Calls action(lane) for each bit.
template <class Action>
void for_each_lane(unsigned bits, Action action)
{
    for (; bits != 0; bits &= bits - 1) action(static_cast<unsigned>(std::countr_zero(bits)));
}

struct WaitingNode
{
    std::uint32_t node;
    float fraction; ///< at which the sweep comes to it
};

/// Pushes the children that the sweep meets, the farthest first.
void push_by_distance(const TreeNode& node, unsigned bits, Float4 fractions, Stack<WaitingNode>& stack)
{
    std::array<WaitingNode, 4> met;
    std::size_t count = 0;
    for_each_lane(bits, [&](unsigned lane)
    {
        const WaitingNode child = {node.child[lane], fractions[lane]};
        std::size_t at = count++;
        for (; at > 0 && met[at - 1].fraction < child.fraction; --at) met[at] = met[at - 1];
        met[at] = child;
    });
    for (std::size_t i = 0; i < count; ++i) stack.push(met[i]);
}

} // namespace

bool query_tree(const BoxTree& tree, const Aabb& box, BoxVisitor& visitor)
{
    for (const BoxTree::Entry& entry : tree.waiting())
        if (overlaps(entry.box, box) && !visitor.visit(entry.proxy)) return false;
    if (tree.is_empty()) return true;

    Stack<std::uint32_t> stack;
    stack.push(0);
    while (!stack.is_empty())
    {
        const std::uint32_t index = stack.pop();
        const TreeNode& node = tree.node(index);
        bool goes_on = true;
        for_each_lane(overlap_bits(box, tree.boxes(index)), [&](unsigned lane)
        {
            if (!node.is_leaf)
                stack.push(node.child[lane]);
            else
                goes_on = goes_on && visitor.visit(node.child[lane]);
        });
        if (!goes_on) return false;
    }
    return true;
}

float query_tree(const BoxTree& tree, const BoxSweep& sweep, float most, SweepVisitor& visitor)
{
    for (const BoxTree::Entry& entry : tree.waiting())
    {
        if (sweep.meets(entry.box, most).is_met) most = visitor.visit(entry.proxy);
        if (most < 0) return most;
    }
    if (tree.is_empty()) return most;

    Stack<WaitingNode> stack;
    stack.push({0, 0});
    while (!stack.is_empty() && most >= 0)
    {
        const WaitingNode top = stack.pop();
        if (top.fraction > most) continue;
        const TreeNode& node = tree.node(top.node);
        Float4 fractions;
        const unsigned bits = sweep.meets(tree.boxes(top.node), most, fractions);
        if (!node.is_leaf)
        {
            push_by_distance(node, bits, fractions, stack);
            continue;
        }
        for_each_lane(bits, [&](unsigned lane)
        {
            if (fractions[lane] <= most) most = visitor.visit(node.child[lane]);
        });
    }
    return most;
}

} // namespace carom::detail
