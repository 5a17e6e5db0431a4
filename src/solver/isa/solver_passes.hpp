// All passes of an instruction set.
#pragma once

#include "solver/isa/body_passes.hpp"
#include "solver/isa/contact_passes.hpp"
#include "solver/isa/joint_passes.hpp"

namespace carom::detail
{

/// The passes of an instruction set.
struct SolverPasses
{
    int lanes; ///< of a row: 1, 4, 8 or 16
    ContactPasses single;
    ContactPasses pairs;
    JointPasses joints;
    BodyPasses bodies;
};

const SolverPasses& scalar_passes();
const SolverPasses& four_lane_passes(); ///< SSE2, NEON or WASM
#if defined(__x86_64__)
const SolverPasses& avx2_passes();
const SolverPasses& avx512_passes();
#endif

} // namespace carom::detail
