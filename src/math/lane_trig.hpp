// The arctangent of a lane, for kernels that are compiled for one instruction set.
#pragma once

#include "math/lanes.hpp"

#include <carom/math.hpp>

namespace carom::detail
{

inline float lane_atan2(float y, float x) { return carom::atan2(y, x); }

} // namespace carom::detail
