// Picks and frees colours by the bodies' masks, and sorts constraints by colour.
#include "solver/rows/graph_colors.hpp"

#include <bit>

namespace carom::detail
{

namespace
{

constexpr std::uint32_t all_colors = (std::uint32_t{1} << overflow_color) - 1;

std::uint8_t pick_color(bool is_dynamic_a, bool is_dynamic_b, std::uint32_t used)
{
    const std::uint32_t free = ~used & all_colors;
    if (free == 0) return overflow_color;
    const bool both = is_dynamic_a && is_dynamic_b;
    return static_cast<std::uint8_t>(both ? std::countr_zero(free) : 31 - std::countl_zero(free));
}

/// The world itself counts as a body that is not dynamic.
bool is_dynamic(const BodyStore& bodies, std::uint32_t body) { return body != null_index && bodies.is_dynamic(body); }

/// @param mask where a body holds the colours of such constraints
template <class Constraint>
void give(Constraint& constraint, BodyStore& bodies, std::uint32_t BodyRecord::* mask)
{
    const bool is_dynamic_a = is_dynamic(bodies, constraint.body_a);
    const bool is_dynamic_b = is_dynamic(bodies, constraint.body_b);
    const std::uint32_t used = (is_dynamic_a ? bodies.records[constraint.body_a].*mask : 0) | //
                               (is_dynamic_b ? bodies.records[constraint.body_b].*mask : 0);
    constraint.color = pick_color(is_dynamic_a, is_dynamic_b, used);
    if (constraint.color == overflow_color) return;
    if (is_dynamic_a) bodies.records[constraint.body_a].*mask |= std::uint32_t{1} << constraint.color;
    if (is_dynamic_b) bodies.records[constraint.body_b].*mask |= std::uint32_t{1} << constraint.color;
}

template <class Constraint>
void take(Constraint& constraint, BodyStore& bodies, std::uint32_t BodyRecord::* mask)
{
    if (constraint.color == no_color) return;
    if (constraint.color != overflow_color)
    {
        const std::uint32_t keep = ~(std::uint32_t{1} << constraint.color);
        if (is_dynamic(bodies, constraint.body_a)) bodies.records[constraint.body_a].*mask &= keep;
        if (is_dynamic(bodies, constraint.body_b)) bodies.records[constraint.body_b].*mask &= keep;
    }
    constraint.color = no_color;
}

} // namespace

void give_color(std::uint32_t contact, ContactStore& contacts, BodyStore& bodies)
{
    give(contacts.contacts[contact], bodies, &BodyRecord::color_mask);
}

void give_color(std::uint32_t joint, JointStore& joints, BodyStore& bodies)
{
    give(joints.joints[joint], bodies, &BodyRecord::joint_color_mask);
}

void take_color(std::uint32_t contact, ContactStore& contacts, BodyStore& bodies)
{
    take(contacts.contacts[contact], bodies, &BodyRecord::color_mask);
}

void take_color(std::uint32_t joint, JointStore& joints, BodyStore& bodies)
{
    take(joints.joints[joint], bodies, &BodyRecord::joint_color_mask);
}

ColorLists::ColorLists(const ContactStore& contacts, std::pmr::memory_resource& memory) : constraints_(&memory)
{
    sort(contacts.awake, [&](std::uint32_t contact) { return contacts.contacts[contact].color; });
}

ColorLists::ColorLists(const JointStore& joints, std::pmr::memory_resource& memory) : constraints_(&memory)
{
    sort(joints.active, [&](std::uint32_t joint) { return joints.joints[joint].color; });
}

/// By counting.
template <class ColorOf>
void ColorLists::sort(std::span<const std::uint32_t> constraints, const ColorOf& color_of)
{
    for (const std::uint32_t constraint : constraints)
        if (const std::uint8_t color = color_of(constraint); color != no_color) ++begin_[color + std::size_t{1}];
    for (std::size_t color = 0; color < color_count; ++color) begin_[color + 1] += begin_[color];
    constraints_.resize(begin_[color_count]);
    std::array<std::uint32_t, color_count + 1> next = begin_;
    for (const std::uint32_t constraint : constraints)
        if (const std::uint8_t color = color_of(constraint); color != no_color) constraints_[next[color]++] = constraint;
}

std::span<const std::uint32_t> ColorLists::list(int color) const
{
    const auto at = static_cast<std::size_t>(color);
    return std::span(constraints_).subspan(begin_[at], begin_[at + 1] - begin_[at]);
}

int ColorLists::used_colors() const
{
    int used = 0;
    for (int color = 0; color < overflow_color; ++color) used += list(color).empty() ? 0 : 1;
    return used;
}

} // namespace carom::detail
