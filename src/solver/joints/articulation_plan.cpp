// The plan: in which order joints are eliminated, and which blocks of A that fills.
#include "solver/joints/articulation.hpp"

#include <algorithm>
#include <limits>

namespace carom::detail
{

namespace
{

/// A larger front is not eliminated: its cost grows with the square of this, and a net of n joints has fronts of sqrt(n).
constexpr std::size_t max_front = 16;

} // namespace

Articulation::Articulation(std::pmr::memory_resource& memory)
    : joints(&memory),
      signature_(&memory),
      columns_(&memory),
      front_(&memory),
      targets_(&memory),
      couplings_(&memory),
      place_(&memory),
      diagonal_(&memory),
      wanted_(&memory),
      blocks_(&memory),
      front_places_(&memory),
      values_(&memory),
      parent_(&memory),
      first_(&memory),
      last_(&memory),
      count_(&memory),
      next_(&memory),
      mark_(&memory),
      gathered_(&memory),
      heap_(&memory),
      is_left_(&memory),
      was_in_(&memory),
      component_(&memory),
      has_loop_(&memory),
      is_held_(&memory),
      softness_(&memory),
      lightest_(&memory),
      heaviest_(&memory)
{
}

bool Articulation::is_planned() const
{
    return std::equal(joints.begin(), joints.end(), signature_.begin(), signature_.end(),
                      [](const ArticulatedJoint& j, const Signature& s) { return s == Signature{j.body_a, j.body_b, j.count}; });
}

void Articulation::plan()
{
    if (!is_planned())
    {
        signature_.clear();
        rows_ = 0;
        for (const ArticulatedJoint& j : joints)
        {
            signature_.push_back({j.body_a, j.body_b, j.count});
            rows_ = std::max(rows_, j.count);
        }
        columns_.clear();
        front_.clear();
        start_lists();
        order_all();
        finish_columns();
        find_couplings();
        was_in_.clear();
        component_.clear();
        for (const ArticulatedJoint& j : joints)
        {
            was_in_.push_back(j.is_in);
            component_.push_back(root_of(j.body_a != 0 ? j.body_a : j.body_b));
        }
        find_loops();
    }
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        joints[i].is_in = was_in_[i];
        joints[i].component = component_[i];
    }
    weigh();
}

/// Softness and mass ratio of each component, from the masses of this step.
void Articulation::weigh()
{
    const std::size_t count = has_loop_.size();
    softness_.resize(count);
    for (std::size_t c = 0; c < count; ++c) softness_[c] = has_loop_[c] ? loop_softness : tree_softness;
    lightest_.assign(count, 0); // inverse masses
    heaviest_.assign(count, std::numeric_limits<float>::infinity());
    const auto add = [this](std::uint32_t component, std::uint32_t body, Vec2 inv_mass, float inv_inertia)
    {
        if (body == 0) return;
        // A body that can't move in every way takes rows away: those that are left may say the same twice without a loop.
        if (!(inv_mass.x > 0 && inv_mass.y > 0 && inv_inertia > 0)) softness_[component] = loop_softness;
        const float most = std::max(inv_mass.x, inv_mass.y);
        if (!(most > 0)) return;
        lightest_[component] = std::max(lightest_[component], most);
        heaviest_[component] = std::min(heaviest_[component], most);
    };
    for (const ArticulatedJoint& joint : joints)
    {
        add(joint.component, joint.body_a, joint.inv_mass_a, joint.inv_inertia_a);
        add(joint.component, joint.body_b, joint.inv_mass_b, joint.inv_inertia_b);
    }
}

bool Articulation::bears_a_load(std::uint32_t component) const { return lightest_[component] > heavy_load * heaviest_[component]; }

/// A component is a tree when it has one joint less than bodies, beside at most one that holds it to what does not move.
void Articulation::find_loops()
{
    std::pmr::vector<std::uint32_t>& spare = count_; // by component: bodies that no joint has been counted for yet
    std::fill(spare.begin(), spare.end(), 0);
    for (std::uint32_t body = 1; body < parent_.size(); ++body) ++spare[root_of(body)];
    has_loop_.assign(parent_.size(), false);
    is_held_.assign(parent_.size(), false);
    for (std::size_t i = 0; i < joints.size(); ++i)
    {
        if (!joints[i].is_in) continue;
        const std::uint32_t component = component_[i];
        const bool is_hold = joints[i].body_a == 0 || joints[i].body_b == 0;
        if (is_hold ? is_held_[component] : spare[component] == 1) has_loop_[component] = true;
        if (is_hold)
            is_held_[component] = true;
        else if (spare[component] > 1)
            --spare[component];
    }
}

/// Every body is by itself, with the list of its joints.
void Articulation::start_lists()
{
    std::uint32_t bodies = 1;
    for (const ArticulatedJoint& j : joints) bodies = std::max({bodies, j.body_a + 1, j.body_b + 1});
    parent_.resize(bodies);
    for (std::uint32_t b = 0; b < bodies; ++b) parent_[b] = b;
    first_.assign(bodies, null_index);
    last_.assign(bodies, null_index);
    count_.assign(bodies, 0);
    next_.assign(2 * joints.size(), null_index);
    mark_.assign(joints.size(), 0);
    is_left_.assign(joints.size(), false);
    stamp_ = 0;
    for (std::uint32_t i = 0; i < joints.size(); ++i)
    {
        joints[i].is_in = false;
        is_left_[i] = joints[i].count > 0;
        if (!is_left_[i]) continue;
        for (const std::uint32_t side : {0u, 1u})
        {
            const std::uint32_t body = side == 0 ? joints[i].body_a : joints[i].body_b;
            if (body == 0) continue;
            const std::uint32_t edge = 2 * i + side;
            (last_[body] == null_index ? first_[body] : next_[last_[body]]) = edge;
            last_[body] = edge;
            ++count_[body];
        }
    }
}

std::uint32_t Articulation::root_of(std::uint32_t body)
{
    while (parent_[body] != body) body = parent_[body] = parent_[parent_[body]];
    return body;
}

/// Those left on the two bodies of a joint, itself not among them, by rising index. Takes what is gone out of the lists.
void Articulation::gather_front(std::uint32_t joint)
{
    ++stamp_;
    gathered_.clear();
    for (const std::uint32_t body : {joints[joint].body_a, joints[joint].body_b})
    {
        if (body == 0) continue;
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
void Articulation::eliminate(std::uint32_t joint)
{
    is_left_[joint] = false;
    joints[joint].is_in = true;
    const auto begin = static_cast<std::uint32_t>(front_.size());
    front_.insert(front_.end(), gathered_.begin(), gathered_.end());
    columns_.push_back({joint, begin, static_cast<std::uint32_t>(front_.size()), 0});

    const std::uint32_t a = joints[joint].body_a == 0 ? 0 : root_of(joints[joint].body_a);
    const std::uint32_t b = joints[joint].body_b == 0 ? 0 : root_of(joints[joint].body_b);
    const std::uint32_t root = a != 0 ? a : b;
    if (a != 0 && b != 0 && a != b)
    {
        parent_[b] = a;
        (last_[a] == null_index ? first_[a] : next_[last_[a]]) = first_[b];
        if (last_[b] != null_index) last_[a] = last_[b];
    }
    count_[root] = static_cast<std::uint32_t>(gathered_.size());
}

void Articulation::leave_out(std::uint32_t joint)
{
    is_left_[joint] = false;
    for (const std::uint32_t body : {joints[joint].body_a, joints[joint].body_b})
        if (body != 0) --count_[root_of(body)];
}

void Articulation::order_all()
{
    const auto size_of_front = [this](std::uint32_t joint)
    {
        const std::uint32_t a = joints[joint].body_a == 0 ? 0 : root_of(joints[joint].body_a);
        const std::uint32_t b = joints[joint].body_b == 0 ? 0 : root_of(joints[joint].body_b);
        return (a != 0 ? count_[a] : 0) + (b != 0 && b != a ? count_[b] : 0);
    };
    const auto push = [this](std::uint32_t size, std::uint32_t joint)
    {
        heap_.push_back(std::uint64_t{size} << 32 | joint);
        std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
    };
    heap_.clear();
    for (std::uint32_t i = 0; i < joints.size(); ++i)
        if (is_left_[i] && (joints[i].body_a != 0 || joints[i].body_b != 0)) push(size_of_front(i), i);
    while (!heap_.empty())
    {
        std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
        const auto joint = static_cast<std::uint32_t>(heap_.back());
        const auto size = static_cast<std::uint32_t>(heap_.back() >> 32);
        heap_.pop_back();
        if (const std::uint32_t now = size_of_front(joint); now > size)
        {
            push(now, joint);
            continue;
        }
        gather_front(joint);
        if (gathered_.size() <= max_front)
            eliminate(joint);
        else
            leave_out(joint);
    }
}

/// Puts each front in the order of elimination, and names the blocks that each pair of it changes.
void Articulation::finish_columns()
{
    place_.assign(joints.size(), null_index);
    for (std::uint32_t k = 0; k < columns_.size(); ++k) place_[columns_[k].joint] = k;
    // A joint of a front may have been left out later.
    std::uint32_t kept = 0;
    for (Column& column : columns_)
    {
        const std::uint32_t begin = kept;
        for (std::uint32_t f = column.front_begin; f < column.front_end; ++f)
            if (place_[front_[f]] != null_index) front_[kept++] = front_[f];
        column.front_begin = begin;
        column.front_end = kept;
        const auto by_place = [this](std::uint32_t l, std::uint32_t r) { return place_[l] < place_[r]; };
        std::sort(front_.begin() + begin, front_.begin() + kept, by_place);
    }
    front_.resize(kept);
    front_places_.clear();
    for (const std::uint32_t joint : front_) front_places_.push_back(place_[joint]);
    targets_.clear();
    for (Column& column : columns_)
    {
        column.targets_begin = static_cast<std::uint32_t>(targets_.size());
        for (std::uint32_t f = column.front_begin; f < column.front_end; ++f)
            for (std::uint32_t e = column.front_begin; e < f; ++e) targets_.push_back(block_of(front_[f], front_[e]));
    }
}

std::uint32_t Articulation::block_of(std::uint32_t row_joint, std::uint32_t column_joint) const
{
    const Column& column = columns_[place_[column_joint]];
    const auto by_place = [this](std::uint32_t l, std::uint32_t r) { return place_[l] < place_[r]; };
    const auto begin = front_.begin() + column.front_begin;
    const auto end = front_.begin() + column.front_end;
    return static_cast<std::uint32_t>(std::lower_bound(begin, end, row_joint, by_place) - front_.begin());
}

/// All pairs of joints that are in and share a body.
void Articulation::find_couplings()
{
    couplings_.clear();
    std::fill(first_.begin(), first_.end(), null_index);
    std::fill(next_.begin(), next_.end(), null_index);
    for (std::uint32_t i = 0; i < joints.size(); ++i)
    {
        if (!joints[i].is_in) continue;
        for (const std::uint32_t side : {0u, 1u})
        {
            const std::uint32_t body = side == 0 ? joints[i].body_a : joints[i].body_b;
            if (body == 0) continue;
            for (std::uint32_t edge = first_[body]; edge != null_index; edge = next_[edge])
            {
                const std::uint32_t other = edge / 2;
                if (other == i) continue;
                const bool is_later = place_[i] > place_[other];
                const std::uint32_t row = is_later ? i : other;
                const std::uint32_t column = is_later ? other : i;
                const bool side_b = side == 1;
                const bool other_b = edge % 2 == 1;
                couplings_.push_back({row, column, is_later ? side_b : other_b, is_later ? other_b : side_b, block_of(row, column)});
            }
            next_[2 * i + side] = first_[body];
            first_[body] = 2 * i + side;
        }
    }
}

} // namespace carom::detail
