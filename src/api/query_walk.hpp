// What all queries share: which shapes the filter lets through, and visiting shapes in the order of their indices.
#pragma once

#include "state/world_state.hpp"

#include <carom/queries.hpp>

#include <algorithm>
#include <array>
#include <bit>

namespace carom::detail
{

BodyId body_id(const WorldState& world, std::uint32_t body);

/// The cheap reasons first, the user's own last.
bool is_seen(const WorldState& world, std::uint32_t shape, const QueryFilter& filter);

inline const Transform& transform_of(const WorldState& world, std::uint32_t shape)
{
    return world.bodies.poses[world.shapes.records[shape].body].transform;
}

/// Marks the shapes that it is shown, within a window of indices, and gives them back in order. So a query of any size can be answered in order and
/// without memory of its own: it is asked again for each window that holds some. A word of marks is cleared when it is first used, so that an
/// empty window costs next to nothing.
class ShapeWindow final : public BoxVisitor
{
public:
    bool visit(ProxyIndex shape) override
    {
        if (shape < begin_) return true;
        const ProxyIndex place = shape - begin_;
        if (place >= width)
        {
            next_ = std::min(next_, shape);
            return true;
        }
        const ProxyIndex word = place / 64;
        const std::uint64_t word_bit = std::uint64_t{1} << word % 64;
        if (!(used_[word / 64] & word_bit))
        {
            used_[word / 64] |= word_bit;
            marks_[word] = 0;
        }
        marks_[word] |= std::uint64_t{1} << place % 64;
        return true;
    }

    /// Calls visit(shape) for each one that is marked, until it returns false.
    /// @return whether it never did
    template <class Visit>
    bool visit_marked(Visit&& visit) const
    {
        for (std::size_t u = 0; u < used_.size(); ++u)
        {
            for (std::uint64_t used = used_[u]; used != 0; used &= used - 1)
            {
                const std::size_t word = 64 * u + static_cast<std::size_t>(std::countr_zero(used));
                for (std::uint64_t marks = marks_[word]; marks != 0; marks &= marks - 1)
                    if (!visit(begin_ + static_cast<ProxyIndex>(64 * word + static_cast<std::size_t>(std::countr_zero(marks)))))
                        return false;
            }
        }
        return true;
    }

    /// Moves on to the lowest shape beyond the window. @return false when there was none
    bool move_on()
    {
        if (next_ == null_index) return false;
        begin_ = next_;
        next_ = null_index;
        used_ = {};
        return true;
    }

private:
    static constexpr ProxyIndex width = 1 << 15;
    std::array<std::uint64_t, width / 64 / 64> used_ = {}; ///< a bit for each word of marks
    std::array<std::uint64_t, width / 64> marks_;          ///< a bit for each shape, in words that are used
    ProxyIndex begin_ = 0;
    ProxyIndex next_ = null_index;
};

/// Calls visit(shape slot) for each shape that is seen and whose fat bounds overlap the box, ordered by slot, until it returns false.
template <class Visit>
void for_each_near(WorldState& world, const Aabb& box, const QueryFilter& filter, Visit&& visit)
{
    ShapeWindow window;
    do world.broad_phase->query(box, window);
    while (window.visit_marked([&](ProxyIndex shape) { return !is_seen(world, shape, filter) || visit(shape); }) && window.move_on());
}

} // namespace carom::detail
