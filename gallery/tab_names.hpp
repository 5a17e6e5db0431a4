// The tabs of the panel on the right.
#pragma once

#include <array>

namespace carom::gallery
{

inline constexpr std::array tab_names = {"Look", "Times", "Broad phase", "Memory", "Body"};

} // namespace carom::gallery
