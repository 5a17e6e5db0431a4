// Colours of the graph of constraints: those of one colour share no dynamic body, so they can be solved in any order, or together.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/joint_store.hpp"

#include <array>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// Colours, the last of which holds what found no free colour: its constraints are solved one by one.
inline constexpr int color_count = 32;
inline constexpr int overflow_color = color_count - 1;

/// Gives a constraint a colour, which it keeps for as long as the solver works on it. Each body holds a mask of the colours of its contacts, and one of
/// those of its joints, so a free colour is one bit operation away. Only dynamic bodies count: nothing is written to others. Constraints
/// between two dynamic bodies take the lowest free colour, those with the ground the highest: they are solved last of a pass, so that a pile sinks into
/// its neighbours rather than into the ground.
void give_color(std::uint32_t contact, ContactStore& contacts, BodyStore& bodies);
void give_color(std::uint32_t joint, JointStore& joints, BodyStore& bodies);
/// Does nothing to a constraint without a colour.
void take_color(std::uint32_t contact, ContactStore& contacts, BodyStore& bodies);
void take_color(std::uint32_t joint, JointStore& joints, BodyStore& bodies);

/// The constraints of a step, colour by colour, each list in the order of the store's own list.
class ColorLists
{
public:
    /// Contacts that are awake and have a colour.
    ColorLists(const ContactStore& contacts, std::pmr::memory_resource& memory);
    /// Joints that are active.
    ColorLists(const JointStore& joints, std::pmr::memory_resource& memory);

    std::span<const std::uint32_t> list(int color) const;
    int used_colors() const; ///< without the overflow
    std::size_t size() const { return constraints_.size(); }

private:
    template <class ColorOf>
    void sort(std::span<const std::uint32_t> constraints, const ColorOf& color_of);

    std::array<std::uint32_t, color_count + 1> begin_ = {};
    std::pmr::vector<std::uint32_t> constraints_;
};

} // namespace carom::detail
