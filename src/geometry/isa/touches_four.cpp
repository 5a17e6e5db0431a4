// Four lanes, which every machine has: SSE2, NEON or WASM.
#include "math/wide_records.hpp"

#include "geometry/isa/touch_passes_impl.hpp"

namespace carom::detail
{

const TouchPasses& four_lane_touch_passes() { return touch_passes<Lanes<4>>; }

} // namespace carom::detail
