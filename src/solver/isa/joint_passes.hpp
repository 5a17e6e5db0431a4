// The passes over joints, once for each instruction set: over rows that are solved one by one, and over mechanisms.
#pragma once

#include "solver/kernels/mechanism.hpp"

namespace carom::detail
{

/// A pass over rows that are solved one by one.
/// @param rows    JointRow<F>s, F with the lanes of the table
/// @param offsets where each begins [bytes], as many as `count`
/// @param motions see motion_floats
using JointRowPass = void (*)(char* rows, const std::uint32_t* offsets, std::size_t count, float* motions,
                              const JointConstants<float>& constants);

/// A pass over mechanisms that lie side by side.
using MechanismPass = void (*)(const MechanismGroup& group, float* motions, const JointConstants<float>& constants);

struct JointRowPasses
{
    JointRowPass prepare; ///< linearises before anything has moved; writes no motion
    JointRowPass warm_start;
    JointRowPass solve;
    JointRowPass relax;    ///< linearises anew where the bodies have come to, and takes back what the bias pushed
    JointRowPass conclude; ///< finds the angle of each joint where the bodies are
};

struct MechanismPasses
{
    MechanismPass prepare;
    MechanismPass warm_start;
    MechanismPass solve;
    MechanismPass relax;
    MechanismPass conclude;
};

/// The passes of an instruction set.
struct JointPasses
{
    JointRowPasses rows;
    MechanismPasses mechanisms[most_rigid]; ///< by the rows of their blocks, less one
};

} // namespace carom::detail
