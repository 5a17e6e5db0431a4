// The passes over all bodies that move, once for each instruction set.
#pragma once

#include <cstddef>

namespace carom::detail
{

/// Bodies by motion index. The first stands for the ground, and is left alone.
struct MotionArrays
{
    float* motions;      ///< see motion_floats
    const float* masses; ///< see mass_floats
    const float* drives; ///< see drive_floats
    std::size_t count;
};

/// How far bodies are pushed in a substep.
struct Pull
{
    float gravity_x; ///< [m/s^2]
    float gravity_y;
    float h; ///< substep [s]
};

struct BodyPasses
{
    void (*integrate_velocities)(const MotionArrays& bodies, const Pull& pull);
    void (*integrate_positions)(float* motions, std::size_t count, float h);
};

} // namespace carom::detail
