// From the choice of an instruction set to its passes.
#pragma once

#include "solver/isa/solver_passes.hpp"

#include <carom/simd.hpp>

#include <string_view>

namespace carom::detail
{

/// What is to be used where `simd` is asked for: Best is what CAROM_SIMD in the environment names, or best_simd().
/// @throws UsageError when this machine does not have it
Simd chosen_simd(Simd simd, std::string_view function);

/// @param simd available, and not Best
const SolverPasses& passes_of(Simd simd);

} // namespace carom::detail
