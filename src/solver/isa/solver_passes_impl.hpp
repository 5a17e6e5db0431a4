// Definitions of all passes, for the one file of each instruction set. Every function here is a template over the lane type: the linker keeps one copy
// of an inline function, and must never take that of one instruction set for another. tests: isa_symbols
#pragma once

#include "solver/isa/body_passes_impl.hpp"
#include "solver/isa/contact_passes_impl.hpp"
#include "solver/isa/joint_passes_impl.hpp"
#include "solver/isa/solver_passes.hpp"

namespace carom::detail
{

template <class F>
inline constexpr SolverPasses solver_passes = {lane_width<F>, contact_passes<F, 1>, contact_passes<F, 2>, joint_passes<F>, body_passes<F>};

} // namespace carom::detail
