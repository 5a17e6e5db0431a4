// Picks and frees colours by the bodies' masks.
#include "solver/graph_colors.hpp"

#include <bit>

namespace carom::detail
{

namespace
{

constexpr std::uint32_t all_colors = (std::uint32_t{1} << overflow_color) - 1;

/// Small lists grow and shrink by chance: room for that from the start, so that a pile that was warm stays warm.
constexpr std::size_t least_capacity = 64;

std::uint8_t pick_color(bool is_dynamic_a, bool is_dynamic_b, std::uint32_t used)
{
    const std::uint32_t free = ~used & all_colors;
    if (free == 0) return overflow_color;
    const bool both = is_dynamic_a && is_dynamic_b;
    return static_cast<std::uint8_t>(both ? std::countr_zero(free) : 31 - std::countl_zero(free));
}

/// The world itself counts as a body that is not dynamic.
bool is_dynamic(const BodyStore& bodies, std::uint32_t body) { return body != null_index && bodies.is_dynamic(body); }

} // namespace

template <class Kind>
void GraphColors<Kind>::add(std::uint32_t constraint, Store& store, BodyStore& bodies)
{
    auto& pair = Kind::constraints(store)[constraint];
    const bool is_dynamic_a = is_dynamic(bodies, pair.body_a);
    const bool is_dynamic_b = is_dynamic(bodies, pair.body_b);
    const std::uint32_t used = (is_dynamic_a ? Kind::mask(bodies.records[pair.body_a]) : 0) | //
                               (is_dynamic_b ? Kind::mask(bodies.records[pair.body_b]) : 0);

    const std::uint8_t color = pick_color(is_dynamic_a, is_dynamic_b, used);
    std::pmr::vector<std::uint32_t>& list = colors_[color];
    if (list.capacity() == 0) list.reserve(least_capacity);
    list.push_back(constraint); // may throw: nothing has changed before
    pair.index_in_color = static_cast<std::uint32_t>(list.size() - 1);
    pair.color = color;
    if (color == overflow_color) return;
    if (is_dynamic_a) Kind::mask(bodies.records[pair.body_a]) |= std::uint32_t{1} << color;
    if (is_dynamic_b) Kind::mask(bodies.records[pair.body_b]) |= std::uint32_t{1} << color;
}

template <class Kind>
void GraphColors<Kind>::remove(std::uint32_t constraint, Store& store, BodyStore& bodies)
{
    auto& constraints = Kind::constraints(store);
    auto& pair = constraints[constraint];
    if (pair.color == no_color) return;
    if (pair.color != overflow_color)
    {
        const std::uint32_t keep = ~(std::uint32_t{1} << pair.color);
        if (is_dynamic(bodies, pair.body_a)) Kind::mask(bodies.records[pair.body_a]) &= keep;
        if (is_dynamic(bodies, pair.body_b)) Kind::mask(bodies.records[pair.body_b]) &= keep;
    }
    std::pmr::vector<std::uint32_t>& list = colors_[pair.color];
    const std::uint32_t last = list.back();
    list[pair.index_in_color] = last;
    constraints[last].index_in_color = pair.index_in_color;
    list.pop_back();
    pair.color = no_color;
}

template <class Kind>
int GraphColors<Kind>::used_colors() const
{
    int used = 0;
    for (int color = 0; color < overflow_color; ++color) used += list(color).empty() ? 0 : 1;
    return used;
}

template class GraphColors<ContactColoring>;
template class GraphColors<JointColoring>;

} // namespace carom::detail
