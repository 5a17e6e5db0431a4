// Colours of the graph of contacts: those of one colour share no dynamic body, so they can be solved in any order, or together.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"

#include <array>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// Colours, the last of which holds what found no free colour: its contacts are solved one by one.
inline constexpr int color_count = 32;
inline constexpr int overflow_color = color_count - 1;

/// Gives a contact a colour, which it keeps for as long as the solver works on it. Each body holds a mask of the colours of its contacts, so a free
/// colour is one bit operation away. Only dynamic bodies count: nothing is written to others. Contacts between two dynamic bodies take the lowest free
/// colour, those with the ground the highest: they are solved last of a pass, so that a pile sinks into its neighbours rather than into the ground.
void give_color(std::uint32_t contact, ContactStore& contacts, BodyStore& bodies);
/// Does nothing to a contact without a colour.
void take_color(std::uint32_t contact, ContactStore& contacts, BodyStore& bodies);

static_assert(2 * color_count == bucket_count);

/// The contacts of a step, colour by colour: those of one point and then those of two, both in the order of the store's own list.
class ColorLists
{
public:
    /// Contacts that are awake and have a colour.
    ColorLists(const ContactStore& contacts, std::pmr::memory_resource& memory);

    std::span<const std::uint32_t> list(int color) const { return part(color, 0, 2); }
    std::span<const std::uint32_t> singles(int color) const { return part(color, 0, 1); }
    std::span<const std::uint32_t> doubles(int color) const { return part(color, 1, 2); }
    int used_colors() const; ///< without the overflow
    std::size_t size() const { return begin_[bucket_count]; }

private:
    std::span<const std::uint32_t> part(int color, std::size_t from, std::size_t to) const;

    std::array<std::uint32_t, bucket_count + 2> begin_ = {}; ///< of each bucket, of what has none, and the end
    std::pmr::vector<std::uint32_t> contacts_;
};

} // namespace carom::detail
