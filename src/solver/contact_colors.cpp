// Picks and frees colours by the bodies' masks.
#include "solver/contact_colors.hpp"

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

} // namespace

void ContactColors::add(std::uint32_t contact, ContactStore& contacts, BodyStore& bodies)
{
    Contact& pair = contacts.contacts[contact];
    const bool is_dynamic_a = bodies.is_dynamic(pair.body_a);
    const bool is_dynamic_b = bodies.is_dynamic(pair.body_b);
    std::uint32_t& mask_a = bodies.records[pair.body_a].color_mask;
    std::uint32_t& mask_b = bodies.records[pair.body_b].color_mask;

    const std::uint8_t color = pick_color(is_dynamic_a, is_dynamic_b, (is_dynamic_a ? mask_a : 0) | (is_dynamic_b ? mask_b : 0));
    std::pmr::vector<std::uint32_t>& list = colors_[color];
    list.push_back(contact); // may throw: nothing has changed before
    pair.index_in_color = static_cast<std::uint32_t>(list.size() - 1);
    pair.color = color;
    if (pair.color != overflow_color)
    {
        if (is_dynamic_a) mask_a |= std::uint32_t{1} << pair.color;
        if (is_dynamic_b) mask_b |= std::uint32_t{1} << pair.color;
    }
}

void ContactColors::remove(std::uint32_t contact, ContactStore& contacts, BodyStore& bodies)
{
    Contact& pair = contacts.contacts[contact];
    if (pair.color == no_color) return;
    if (pair.color != overflow_color)
    {
        const std::uint32_t keep = ~(std::uint32_t{1} << pair.color);
        if (bodies.is_dynamic(pair.body_a)) bodies.records[pair.body_a].color_mask &= keep;
        if (bodies.is_dynamic(pair.body_b)) bodies.records[pair.body_b].color_mask &= keep;
    }
    std::pmr::vector<std::uint32_t>& list = colors_[pair.color];
    const std::uint32_t last = list.back();
    list[pair.index_in_color] = last;
    contacts.contacts[last].index_in_color = pair.index_in_color;
    list.pop_back();
    pair.color = no_color;
}

int ContactColors::used_colors() const
{
    int used = 0;
    for (int color = 0; color < overflow_color; ++color) used += contacts_of(color).empty() ? 0 : 1;
    return used;
}

} // namespace carom::detail
