// The arctangent of each lane, for kernels that are compiled for one instruction set. The bits of carom::atan2, which says how it goes.
#pragma once

#include "math/lanes.hpp"

namespace carom::detail
{

/// @return in [-pi, pi]; 0 where both are 0
template <class F>
F lane_atan2(F y, F x)
{
    using D = DoubleOf<F>;
    constexpr double tan_eighth_pi = 0.41421356237309503;
    constexpr double quarter_pi = 0.7853981633974483;
    const D zero(0.0);
    const D wide_x = to_double(x);
    const D wide_y = to_double(y);
    const D abs_x = select(wide_x < zero, -wide_x, wide_x);
    const D abs_y = select(wide_y < zero, -wide_y, wide_y);
    const auto is_steep = abs_x < abs_y;
    const D larger = select(is_steep, abs_y, abs_x);
    const D smaller = select(is_steep, abs_x, abs_y);

    const auto is_upper_half = smaller > D(tan_eighth_pi) * larger;
    const D t = select(is_upper_half, smaller - larger, smaller) / select(is_upper_half, smaller + larger, larger);
    const D u = t * t;
    const D high = D(0.11045093321038991) + u * (D(-0.08478404832147166) + u * D(0.047482721406790294));
    const D p = D(-0.3333333251460258) + u * (D(0.19999905186321693) + u * (D(-0.14282042058432648) + u * high));
    D result = (t + t * (u * p)) + select(is_upper_half, D(quarter_pi), zero);
    result = select(is_steep, D(2 * quarter_pi) - result, result);
    result = select(wide_x < zero, D(4 * quarter_pi) - result, result);
    result = select(wide_y < zero, -result, result);
    return to_single(select(larger < D(1e-300), zero, result)); // no float but 0 is as small
}

} // namespace carom::detail
