// Four lanes, which every machine has: SSE2, NEON or WASM.
#include "math/wide_records.hpp"
#include "solver/isa/wide_bodies.hpp"

#include "solver/isa/solver_passes_impl.hpp"

namespace carom::detail
{

const SolverPasses& four_lane_passes() { return solver_passes<Lanes<4>>; }

} // namespace carom::detail
