// Picks and frees colours by the bodies' masks, and sorts contacts by colour.
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

} // namespace

void give_color(std::uint32_t slot, ContactStore& contacts, BodyStore& bodies)
{
    Contact& contact = contacts.contacts[slot];
    const bool is_dynamic_a = bodies.is_dynamic(contact.body_a);
    const bool is_dynamic_b = bodies.is_dynamic(contact.body_b);
    std::uint32_t& mask_a = bodies.records[contact.body_a].color_mask;
    std::uint32_t& mask_b = bodies.records[contact.body_b].color_mask;
    contact.color = pick_color(is_dynamic_a, is_dynamic_b, (is_dynamic_a ? mask_a : 0) | (is_dynamic_b ? mask_b : 0));
    contacts.refresh_bucket(slot);
    if (contact.color == overflow_color) return;
    if (is_dynamic_a) mask_a |= std::uint32_t{1} << contact.color;
    if (is_dynamic_b) mask_b |= std::uint32_t{1} << contact.color;
}

void take_color(std::uint32_t slot, ContactStore& contacts, BodyStore& bodies)
{
    Contact& contact = contacts.contacts[slot];
    if (contact.color == no_color) return;
    if (contact.color != overflow_color)
    {
        const std::uint32_t keep = ~(std::uint32_t{1} << contact.color);
        if (bodies.is_dynamic(contact.body_a)) bodies.records[contact.body_a].color_mask &= keep;
        if (bodies.is_dynamic(contact.body_b)) bodies.records[contact.body_b].color_mask &= keep;
    }
    contact.color = no_color;
    contacts.refresh_bucket(slot);
}

/// Sorted by counting, without a branch: what has no bucket comes last.
ColorLists::ColorLists(const ContactStore& store, std::pmr::memory_resource& memory) : contacts_(store.awake.size(), &memory)
{
    for (const AwakeState state : store.awake_states) ++begin_[state.bucket + std::size_t{1}];
    for (std::size_t bucket = 0; bucket <= bucket_count; ++bucket) begin_[bucket + 1] += begin_[bucket];
    std::array<std::uint32_t, bucket_count + 2> next = begin_;
    for (std::size_t place = 0; place < store.awake.size(); ++place)
        contacts_[next[store.awake_states[place].bucket]++] = store.awake[place];
}

std::span<const std::uint32_t> ColorLists::part(int color, std::size_t from, std::size_t to) const
{
    const std::size_t bucket = 2 * static_cast<std::size_t>(color);
    return std::span(contacts_).subspan(begin_[bucket + from], begin_[bucket + to] - begin_[bucket + from]);
}

int ColorLists::used_colors() const
{
    int used = 0;
    for (int color = 0; color < overflow_color; ++color) used += list(color).empty() ? 0 : 1;
    return used;
}

} // namespace carom::detail
