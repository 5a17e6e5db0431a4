// Colours of the graph of constraints: those of one colour share no dynamic body, so they can be solved in any order, or together.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/joint_store.hpp"

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// Colours, the last of which holds what found no free colour: its constraints are solved one by one.
inline constexpr int color_count = 32;
inline constexpr int overflow_color = color_count - 1;

/// Keeps the colour of every constraint that the solver works on; it keeps it as long as the solver does. Each body holds a mask of the
/// colours of its constraints, so a free colour is one bit operation away. Only dynamic bodies count: nothing is written to others.
/// @tparam Kind tells where the constraints and the masks are; contacts and joints are coloured apart
template <class Kind>
class GraphColors
{
public:
    using Store = typename Kind::Store;

    explicit GraphColors(std::pmr::memory_resource& memory) : colors_(&memory) { colors_.resize(color_count); }

    /// Constraints between two dynamic bodies take the lowest free colour, those with the ground the highest: they are solved last
    /// of a pass, so that a pile sinks into its neighbours rather than into the ground.
    void add(std::uint32_t constraint, Store& store, BodyStore& bodies);
    /// Does nothing to a constraint without a colour.
    void remove(std::uint32_t constraint, Store& store, BodyStore& bodies);

    std::span<const std::uint32_t> list(int color) const { return colors_[static_cast<std::size_t>(color)]; }
    int used_colors() const;

private:
    std::pmr::vector<std::pmr::vector<std::uint32_t>> colors_;
};

struct ContactColoring
{
    using Store = ContactStore;
    static auto& constraints(Store& store) { return store.contacts; }
    static std::uint32_t& mask(BodyRecord& body) { return body.color_mask; }
};

struct JointColoring
{
    using Store = JointStore;
    static auto& constraints(Store& store) { return store.joints; }
    static std::uint32_t& mask(BodyRecord& body) { return body.joint_color_mask; }
};

using ContactColors = GraphColors<ContactColoring>;
using JointColors = GraphColors<JointColoring>;

extern template class GraphColors<ContactColoring>;
extern template class GraphColors<JointColoring>;

} // namespace carom::detail
