// Four lanes, which every machine has: SSE2, NEON or WASM.
#include "math/wide_lanes.hpp"

#include "fields/isa/pull_passes_impl.hpp"

namespace carom::detail
{

const PullPasses& four_lane_pull_passes() { return pull_passes<Lanes<4>>; }

} // namespace carom::detail
