// Values that many tests use.
#pragma once

#include <carom/carom.hpp> // before these names, which parameters of its calls would shadow

#include <limits>

namespace carom
{

inline constexpr float dt = 1 / 60.0f; ///< of a step [s]
inline constexpr float inf = std::numeric_limits<float>::infinity();
inline constexpr float nan = std::numeric_limits<float>::quiet_NaN();

} // namespace carom
