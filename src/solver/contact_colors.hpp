// Colours of the contact graph: contacts of one colour share no dynamic body, so they can be solved in any order, or together.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// Colours, the last of which holds what found no free colour: its contacts are solved one by one.
inline constexpr int color_count = 32;
inline constexpr int overflow_color = color_count - 1;

/// Keeps the colour of every contact that the solver works on; a contact keeps its colour as long as it has points. Each body
/// holds a mask of the colours of its contacts, so a free colour is one bit operation away. Only dynamic bodies count: nothing
/// is written to others.
class ContactColors
{
public:
    explicit ContactColors(std::pmr::memory_resource& memory) : colors_(&memory) { colors_.resize(color_count); }

    /// Contacts between two dynamic bodies take the lowest free colour, those with the ground the highest: they are solved last
    /// of a pass, so that a pile sinks into its neighbours rather than into the ground.
    void add(std::uint32_t contact, ContactStore& contacts, BodyStore& bodies);
    /// Does nothing to a contact without a colour.
    void remove(std::uint32_t contact, ContactStore& contacts, BodyStore& bodies);

    std::span<const std::uint32_t> contacts_of(int color) const { return colors_[static_cast<std::size_t>(color)]; }
    int used_colors() const;

private:
    std::pmr::vector<std::pmr::vector<std::uint32_t>> colors_;
};

} // namespace carom::detail
