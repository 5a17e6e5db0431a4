// How a program that runs a scene file for the laboratory times its steps and chooses those after which it writes where the bodies are.
#pragma once

#include <chrono>
#include <cstdint>

namespace carom::lab
{

/// Whether the bodies are written after a step: `samples` times at equal distances, the last time after the last step, but never twice.
/// @param step  counted from 0, < steps
inline bool is_sampled(int step, int steps, int samples)
{
    const std::int64_t n = samples < steps ? samples : steps;
    return (step + std::int64_t{1}) * n / steps > step * n / steps;
}

/// What a call takes [ms].
template <class Work>
double timed_ms(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace carom::lab
