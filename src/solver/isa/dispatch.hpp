// From the choice of an instruction set to its passes.
#pragma once

#include "solver/isa/contact_passes.hpp"

#include <carom/simd.hpp>

namespace carom::detail
{

/// @param simd available, and not Best
const SolverPasses& passes_of(Simd simd);

} // namespace carom::detail
