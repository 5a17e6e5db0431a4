// How the bounds of shapes lie to each other, as templates over the lane type.
#pragma once

#include "math/lane_vec.hpp"

namespace carom::detail
{

template <class F>
struct LaneBox
{
    LaneVec<F> min;
    LaneVec<F> max;
};

/// Whether two boxes are farther apart than `margin`, along x or along y.
template <class F>
MaskOf<F> are_apart(const LaneBox<F>& a, const LaneBox<F>& b, const F& margin)
{
    const MaskOf<F> along_x = (a.min.x - margin > b.max.x) | (b.min.x > a.max.x + margin);
    const MaskOf<F> along_y = (a.min.y - margin > b.max.y) | (b.min.y > a.max.y + margin);
    return along_x | along_y;
}

} // namespace carom::detail
