// Which scenes are measured together, and what should hold in them.
#pragma once

#include "lab/field_scenes/field_scenes.hpp"
#include "lab/quality.hpp"

#include <span>
#include <string>
#include <vector>

namespace carom::lab
{

struct SuiteScene
{
    std::string name;                  ///< of its file; sizes of one kind end in _ and a number
    const FieldScene* scene = nullptr; ///< what it is
    int size = 1;
    int steps = 1;
    QualityTraits traits = {};

    SceneFile make() const;
    /// Moments of a run at which engines tell where the bodies are.
    int samples() const { return traits.has_shots ? steps : 10; }
};

struct Suite
{
    std::string name;
    std::string what;
    std::vector<SuiteScene> scenes;

    /// @param scene one of this suite
    const QualityTraits& traits_of(const std::string& scene) const;
    /// With those scenes alone, in this order.
    /// @throws std::invalid_argument naming all scenes of this suite, when one is not among them
    Suite with_scenes(const std::vector<std::string>& names) const;
};

/// "box2d", "ordinary", "origin", "nbody", "full": all of these, and "quick".
std::span<const Suite> suites();
/// @throws std::invalid_argument naming all suites
const Suite& find_suite(const std::string& name);

/// Bodies that a file makes in all, those of events included.
int body_count(const SceneFile& file);

} // namespace carom::lab
