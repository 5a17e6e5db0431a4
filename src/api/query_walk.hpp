// What all queries share: which shapes the filter lets through, and visiting shapes in the order of their indices.
#pragma once

#include "state/world_state.hpp"

#include <carom/queries.hpp>

#include <algorithm>
#include <array>

namespace carom::detail
{

BodyId body_id(const WorldState& world, std::uint32_t body);

/// The cheap reasons first, the user's own last.
bool is_seen(const WorldState& world, std::uint32_t shape, const QueryFilter& filter);

inline const Transform& transform_of(const WorldState& world, std::uint32_t shape)
{
    return world.bodies.poses[world.shapes.records[shape].body].transform;
}

/// Keeps the lowest few indices of those it is shown, above a floor. So a query of any size can be answered in order and without memory of its
/// own: it is asked again for each batch.
class LowestShapes final : public BoxVisitor
{
public:
    bool visit(ProxyIndex shape) override
    {
        if (shape < floor_) return true;
        if (count_ < most)
        {
            shapes_[count_++] = shape;
            std::push_heap(shapes_.begin(), shapes_.begin() + count_);
            return true;
        }
        is_complete_ = false;
        if (shape >= shapes_.front()) return true;
        std::pop_heap(shapes_.begin(), shapes_.end());
        shapes_.back() = shape;
        std::push_heap(shapes_.begin(), shapes_.end());
        return true;
    }

    /// Begins anew with what comes after the last batch.
    void next_batch()
    {
        if (count_ > 0) floor_ = shapes_[count_ - 1] + 1; // sorted
        count_ = 0;
        is_complete_ = true;
    }
    std::span<const ProxyIndex> sorted()
    {
        std::sort(shapes_.begin(), shapes_.begin() + count_);
        return {shapes_.data(), count_};
    }
    bool is_complete() const { return is_complete_; } ///< nothing is left above the batch

private:
    static constexpr std::size_t most = 256;
    std::array<ProxyIndex, most> shapes_;
    std::size_t count_ = 0;
    ProxyIndex floor_ = 0;
    bool is_complete_ = true;
};

/// Calls visit(shape slot) for each shape that is seen and whose fat bounds overlap the box, ordered by slot, until it returns false.
template <class Visit>
void for_each_near(WorldState& world, const Aabb& box, const QueryFilter& filter, Visit&& visit)
{
    LowestShapes batch;
    do
    {
        batch.next_batch();
        world.broad_phase->query(box, batch);
        for (const ProxyIndex shape : batch.sorted())
            if (is_seen(world, shape, filter) && !visit(shape)) return;
    } while (!batch.is_complete());
}

} // namespace carom::detail
