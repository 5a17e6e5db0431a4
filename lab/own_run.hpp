// Carom as one of the engines of the laboratory.
#pragma once

#include "lab/engine_run.hpp"
#include "lab/scene_file/model.hpp"
#include "scenes/camera.hpp"
#include "scenes/draw_list.hpp"

#include <carom/broad_phase.hpp>
#include <carom/simd.hpp>

#include <functional>

namespace carom::lab
{

struct OwnRunOptions
{
    int threads = 1;
    int samples = 10; ///< moments at which it is told where the bodies are, the last one at the end
    BroadPhaseType broad_phase = BroadPhaseType::Tree;
    Simd simd = Simd::Best;
    double slowdown = 0; ///< each step waits for this share of its time, as a change that makes it slower would
    /// Draws the picture after each step; its time, and that of filling the list, is told beside the step's. Empty: nothing is drawn.
    std::function<void(const scenes::DrawList&, const scenes::Camera&)> draw = {};
};

/// Steps the scene as often as it says. A step's time is the world's own: events, rays and drawing are not in it. Counts, as means of a step: pairs_tested,
/// find_pairs_ms, allocations (over the second half, when the world no longer grows); and memory_bytes, the most that the world held.
/// @param name of the file, for the result and for messages
/// @throws SceneFileError when something in the file does not hold
EngineRun run_carom(const SceneFile& file, const std::string& name, const OwnRunOptions& options = {});

} // namespace carom::lab
