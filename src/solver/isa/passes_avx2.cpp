// Eight lanes. Compiled for AVX2.
#include "math/wide_records.hpp"
#include "solver/isa/wide_bodies.hpp"

#include "solver/isa/solver_passes_impl.hpp"

#if defined(__x86_64__)

namespace carom::detail
{

const SolverPasses& avx2_passes() { return solver_passes<Lanes<8>>; }

} // namespace carom::detail

#endif
