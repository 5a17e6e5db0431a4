// A box on its way along a line, or a ray, tested against boxes: which of them it may meet, and from what fraction of the way on.
#pragma once

#include "broadphase/box4.hpp"

#include <algorithm>
#include <cmath>

namespace carom::detail
{

/// Where a sweep comes to a box.
struct SweepEntry
{
    float fraction = 0; ///< of the sweep, >= 0
    bool is_met = false;
};

/// The test of slabs. It errs only towards meeting: the swept box is taken a little larger, by more than all rounding can add up to. And it is
/// monotone: what meets a box meets every box around it at the same fraction or before, bit by bit, so that every tree lets the same
/// boxes through.
class BoxSweep
{
public:
    /// @param box at the start of the sweep; of a ray, a point
    BoxSweep(const Aabb& box, Vec2 sweep)
    {
        const float longest = std::max(std::abs(sweep.x), std::abs(sweep.y));
        const float farthest = std::max({std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x), std::abs(box.max.y)});
        const Aabb larger = expanded(box, 1e-6f * longest + 5e-7f * farthest);
        x_ = Axis(larger.min.x, larger.max.x, sweep.x);
        y_ = Axis(larger.min.y, larger.max.y, sweep.y);
    }

    /// @param most the fraction of the sweep that matters
    SweepEntry meets(const Aabb& box, float most) const
    {
        float enter = 0;
        float leave = most;
        const bool may_meet = x_.clip(box.min.x, box.max.x, enter, leave) && y_.clip(box.min.y, box.max.y, enter, leave);
        return {enter, may_meet && enter <= leave};
    }

    /// The same for four boxes. @return bit j where box j is met
    unsigned meets(const Box4& boxes, float most, Float4& fractions) const
    {
        Float4 enter = splat4(0);
        Float4 leave = splat4(most);
        const Int4 may_meet = x_.clip(boxes.min_x, boxes.max_x, enter, leave) & y_.clip(boxes.min_y, boxes.max_y, enter, leave);
        fractions = enter;
        return lane_bits(may_meet & (enter <= leave));
    }

private:
    /// One coordinate. Along an axis on which nothing moves, boxes meet from the start to the end or not at all.
    class Axis
    {
    public:
        Axis() = default;
        Axis(float low, float high, float sweep) : low_(low), high_(high), is_still_(std::abs(sweep) < 1e-30f)
        {
            is_forward_ = sweep >= 0;
            inverse_ = is_still_ ? 0 : 1 / sweep;
        }

        bool clip(float min, float max, float& enter, float& leave) const
        {
            if (is_still_) return min <= high_ && max >= low_;
            const float near_side = is_forward_ ? min - high_ : max - low_;
            const float far_side = is_forward_ ? max - low_ : min - high_;
            enter = std::max(enter, near_side * inverse_);
            leave = std::min(leave, far_side * inverse_);
            return true;
        }

        Int4 clip(const float (&min)[4], const float (&max)[4], Float4& enter, Float4& leave) const
        {
            if (is_still_) return (load4(min) <= high_) & (load4(max) >= low_);
            const Float4 to_min = (load4(min) - high_) * inverse_;
            const Float4 to_max = (load4(max) - low_) * inverse_;
            enter = max4(is_forward_ ? to_min : to_max, enter);
            leave = min4(is_forward_ ? to_max : to_min, leave);
            return Int4{-1, -1, -1, -1};
        }

    private:
        float low_ = 0;
        float high_ = 0;
        float inverse_ = 0;
        bool is_still_ = true;
        bool is_forward_ = true;
    };

    Axis x_;
    Axis y_;
};

} // namespace carom::detail
