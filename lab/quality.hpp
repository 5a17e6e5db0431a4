// How well an engine did what a scene asks for: one evaluator for all engines, from where the bodies are at some moments.
#pragma once

#include "lab/engine_run.hpp"
#include "lab/scene_file/model.hpp"

#include <map>
#include <string>

namespace carom::lab
{

/// What should hold in a scene, and so can be held against an engine.
struct QualityTraits
{
    bool rests = false;          ///< comes to rest before its end
    bool stands = false;         ///< what is there at the start stays where it is
    bool keeps_energy = false;   ///< no friction, restitution 1, no fields but uniform gravity
    bool keeps_momentum = false; ///< nothing pushes from outside: no gravity but that between bodies, nothing static
    bool has_shots = false;      ///< fast things fly at thin ones: seen after every step, to count what goes through
    bool is_closed = false;      ///< no moving body can leave what is around: the bounds of those that are not dynamic, turned by any angle
};

/// Puts the bodies where the engine had them, into a world of its own, and measures there; so the same geometry judges all. Contacts are those of
/// shapes that may collide.
/// - deepest_penetration_m over all samples, mean_penetration_m of touching shapes over all samples
/// - joint_separation_m: the largest over all samples of what joints miss that they hold rigidly
/// - tunnelled: pairs of bodies of which one went through the other (lab/passages.hpp); where there are shots, from samples after every step
/// - lost: bodies that are not finite, or beyond the largest coordinate, in any sample
/// and, by the traits, of the last sample:
/// - rest_energy_j_per_kg: kinetic energy over mass; drift_m: the farthest that a body has come from its start; escapes: bodies outside of the bounds
/// - energy_error: the largest change of energy over all samples, over the kinetic energy at the start, or over the weight's energy of falling through
///   a metre when nothing moved then
/// - momentum_error: the largest change of the sum of momenta over all samples, over the sum of their sizes at the start
/// @throws SceneFileError when the file can't be played
std::map<std::string, double> quality_of(const SceneFile& file, const std::vector<Sample>& samples, const QualityTraits& traits);

} // namespace carom::lab
