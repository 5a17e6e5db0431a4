// One lane: the reference.
#include "solver/isa/solver_passes_impl.hpp"

namespace carom::detail
{

const SolverPasses& scalar_passes() { return solver_passes<float>; }

} // namespace carom::detail
