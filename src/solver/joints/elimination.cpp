// Orders eliminations, and names the blocks that each changes.
#include "solver/joints/elimination.hpp"

#include "dynamics/slot_pool.hpp"

#include <algorithm>
#include <functional>

namespace carom::detail
{

MechanismPlan EliminationPlan::view() const
{
    return {.ends = ends.data(),
            .joint_count = static_cast<std::uint32_t>(ends.size()),
            .body_count = body_count,
            .block_rows = static_cast<int>(block_rows),
            .columns = columns.data(),
            .front_count = static_cast<std::uint32_t>(front_columns.size()),
            .front_columns = front_columns.data(),
            .targets = targets.data(),
            .couplings = couplings.data(),
            .coupling_count = static_cast<std::uint32_t>(couplings.size())};
}

Eliminator::Eliminator(std::pmr::memory_resource& memory)
    : parent_(&memory),
      first_(&memory),
      last_(&memory),
      count_(&memory),
      next_(&memory),
      mark_(&memory),
      gathered_(&memory),
      front_(&memory),
      place_(&memory),
      heap_(&memory),
      is_left_(&memory)
{
}

EliminationPlan Eliminator::plan(std::span<const PlannedJoint> joints, std::span<const std::uint8_t> can_move,
                                 std::pmr::memory_resource& memory)
{
    joints_ = joints;
    can_move_ = can_move;
    EliminationPlan plan(memory);
    plan.body_count = static_cast<std::uint32_t>(can_move.size());
    start_lists();
    plan.is_net = !order_all(plan);
    if (plan.is_net) return plan;
    for (const PlannedJoint& joint : joints)
    {
        plan.ends.push_back(joint.ends);
        plan.block_rows = std::max(plan.block_rows, joint.rigid_count);
    }
    finish_columns(plan);
    find_couplings(plan);
    plan.has_loop = has_loop();
    return plan;
}

/// Joints that hang together are a tree when there is one less than bodies that can move, beside at most one that holds them to what does not.
bool Eliminator::has_loop() const
{
    const auto is_hold = [&](const PlannedJoint& j) { return !can_move(j.ends.a) || !can_move(j.ends.b); };
    const auto bodies = std::count(can_move_.begin(), can_move_.end(), std::uint8_t{1});
    const auto holds = std::count_if(joints_.begin(), joints_.end(), is_hold);
    return holds > 1 || static_cast<std::ptrdiff_t>(joints_.size()) - holds > bodies - 1;
}

/// Every body is by itself, with the list of its joints.
void Eliminator::start_lists()
{
    const std::size_t bodies = can_move_.size();
    parent_.resize(bodies);
    for (std::uint32_t b = 0; b < bodies; ++b) parent_[b] = b;
    first_.assign(bodies, null_index);
    last_.assign(bodies, null_index);
    count_.assign(bodies, 0);
    next_.assign(2 * joints_.size(), null_index);
    mark_.assign(joints_.size(), 0);
    is_left_.assign(joints_.size(), true);
    front_.clear();
    stamp_ = 0;
    for (std::uint32_t i = 0; i < joints_.size(); ++i)
    {
        for (const std::uint32_t side : {0u, 1u})
        {
            const std::uint32_t body = side == 0 ? joints_[i].ends.a : joints_[i].ends.b;
            if (!can_move(body)) continue;
            const std::uint32_t edge = 2 * i + side;
            (last_[body] == null_index ? first_[body] : next_[last_[body]]) = edge;
            last_[body] = edge;
            ++count_[body];
        }
    }
}

std::uint32_t Eliminator::root_of(std::uint32_t body)
{
    while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
    return body;
}

/// At least so many joints are left beside this one on its bodies.
std::size_t Eliminator::front_size(std::uint32_t joint)
{
    const auto [a, b] = joints_[joint].ends;
    if (!can_move(a)) return count_[root_of(b)];
    if (!can_move(b)) return count_[root_of(a)];
    const std::uint32_t root_a = root_of(a);
    const std::uint32_t root_b = root_of(b);
    return count_[root_a] + (root_a != root_b ? count_[root_b] : 0);
}

/// Those left on the two bodies of a joint, itself not among them. Takes what is gone out of the lists.
void Eliminator::gather_front(std::uint32_t joint)
{
    ++stamp_;
    gathered_.clear();
    for (const std::uint32_t body : {joints_[joint].ends.a, joints_[joint].ends.b})
    {
        if (!can_move(body)) continue;
        const std::uint32_t root = root_of(body);
        std::uint32_t* link = &first_[root];
        std::uint32_t last = null_index;
        while (*link != null_index)
        {
            const std::uint32_t edge = *link;
            if (!is_left_[edge / 2])
            {
                *link = next_[edge];
                continue;
            }
            if (edge / 2 != joint && mark_[edge / 2] != stamp_)
            {
                mark_[edge / 2] = stamp_;
                gathered_.push_back(edge / 2);
            }
            last = edge;
            link = &next_[edge];
        }
        last_[root] = last;
    }
}

/// Merges the joint's bodies; its front is what is left on them.
void Eliminator::eliminate(std::uint32_t joint, EliminationPlan& plan)
{
    is_left_[joint] = false;
    const auto begin = static_cast<std::uint32_t>(front_.size());
    front_.insert(front_.end(), gathered_.begin(), gathered_.end());
    plan.columns.push_back({joint, begin, static_cast<std::uint32_t>(front_.size()), 0});

    const auto [body_a, body_b] = joints_[joint].ends;
    const std::uint32_t a = can_move(body_a) ? root_of(body_a) : null_index;
    const std::uint32_t b = can_move(body_b) ? root_of(body_b) : null_index;
    if (a != null_index && b != null_index && a != b)
    {
        parent_[b] = a;
        (last_[a] == null_index ? first_[a] : next_[last_[a]]) = first_[b];
        if (last_[b] != null_index) last_[a] = last_[b];
    }
    count_[a != null_index ? a : b] = static_cast<std::uint32_t>(gathered_.size());
}

/// @return false as soon as a front is too large
bool Eliminator::order_all(EliminationPlan& plan)
{
    const auto push = [this](std::size_t size, std::uint32_t joint)
    {
        heap_.push_back(std::uint64_t{size} << 32 | joint);
        std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
    };
    heap_.clear();
    for (std::uint32_t i = 0; i < joints_.size(); ++i) push(front_size(i), i);
    while (!heap_.empty())
    {
        std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
        const auto joint = static_cast<std::uint32_t>(heap_.back());
        const std::size_t size = heap_.back() >> 32;
        heap_.pop_back();
        if (const std::size_t now = front_size(joint); now > size)
        {
            push(now, joint);
            continue;
        }
        gather_front(joint);
        if (gathered_.size() > max_front) return false;
        eliminate(joint, plan);
    }
    return true;
}

/// Puts each front in the order of elimination, and names the blocks that each pair of it changes.
void Eliminator::finish_columns(EliminationPlan& plan)
{
    place_.assign(joints_.size(), null_index);
    for (std::uint32_t k = 0; k < plan.columns.size(); ++k) place_[plan.columns[k].joint] = k;
    const auto by_place = [this](std::uint32_t l, std::uint32_t r) { return place_[l] < place_[r]; };
    for (const EliminationColumn& column : plan.columns)
        std::sort(front_.begin() + column.front_begin, front_.begin() + column.front_end, by_place);
    for (const std::uint32_t joint : front_) plan.front_columns.push_back(place_[joint]);
    for (EliminationColumn& column : plan.columns)
    {
        column.targets_begin = static_cast<std::uint32_t>(plan.targets.size());
        for (std::uint32_t f = column.front_begin; f < column.front_end; ++f)
            for (std::uint32_t e = column.front_begin; e < f; ++e) plan.targets.push_back(block_of(front_[f], front_[e], plan));
    }
}

std::uint32_t Eliminator::block_of(std::uint32_t row_joint, std::uint32_t column_joint, const EliminationPlan& plan) const
{
    const EliminationColumn& column = plan.columns[place_[column_joint]];
    const auto by_place = [this](std::uint32_t l, std::uint32_t r) { return place_[l] < place_[r]; };
    const auto begin = front_.begin() + column.front_begin;
    const auto end = front_.begin() + column.front_end;
    return static_cast<std::uint32_t>(std::lower_bound(begin, end, row_joint, by_place) - front_.begin());
}

/// All pairs of joints that share a body which can move.
void Eliminator::find_couplings(EliminationPlan& plan)
{
    std::fill(first_.begin(), first_.end(), null_index);
    std::fill(next_.begin(), next_.end(), null_index);
    for (std::uint32_t i = 0; i < joints_.size(); ++i)
    {
        for (const std::uint32_t side : {0u, 1u})
        {
            const std::uint32_t body = side == 0 ? joints_[i].ends.a : joints_[i].ends.b;
            if (!can_move(body)) continue;
            for (std::uint32_t edge = first_[body]; edge != null_index; edge = next_[edge])
            {
                const std::uint32_t other = edge / 2;
                if (other == i) continue;
                const bool is_later = place_[i] > place_[other];
                const std::uint32_t row = is_later ? i : other;
                const std::uint32_t column = is_later ? other : i;
                const bool side_b = side == 1;
                const bool other_b = edge % 2 == 1;
                plan.couplings.push_back(
                    {row, column, is_later ? side_b : other_b, is_later ? other_b : side_b, block_of(row, column, plan)});
            }
            next_[2 * i + side] = first_[body];
            first_[body] = 2 * i + side;
        }
    }
}

} // namespace carom::detail
