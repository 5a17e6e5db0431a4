// Sixteen lanes. Compiled for AVX-512 with its F, DQ and VL parts.
#include "math/wide_records.hpp"
#include "solver/isa/wide_bodies.hpp"

#include "solver/isa/solver_passes_impl.hpp"

#if defined(__x86_64__)

namespace carom::detail
{

const SolverPasses& avx512_passes() { return solver_passes<Lanes<16>>; }

} // namespace carom::detail

#endif
