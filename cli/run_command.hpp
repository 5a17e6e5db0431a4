// `carom run`: runs a scene without a window, measures it, and draws it when asked to.
#pragma once

#include "cli/program.hpp"

#include <carom/simd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carom::cli
{

/// What the command line says.
struct RunRequest
{
    std::string scene;
    std::vector<std::string> settings; ///< each NAME=VALUE
    std::optional<int> steps;          ///< by default as many as the scene is meant for, or 600
    std::optional<std::uint64_t> seed; ///< 1 by default
    std::optional<std::string> broad_phase;
    std::optional<Simd> simd;
    std::optional<std::string> input;
    std::optional<std::string> still;
    std::optional<std::string> animation;
    std::optional<std::string> trace;
    bool is_json = false;
};

inline constexpr int most_steps = 10'000'000; ///< a run keeps the time of each step

/// @throws BadUsage, Failure, or the scene's own errors
void run_command(const RunRequest& request, const Surroundings& surroundings);

} // namespace carom::cli
