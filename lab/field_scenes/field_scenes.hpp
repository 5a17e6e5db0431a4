// The benchmark scenes of the field, and ordinary ones, as scene files: what all engines are measured on.
#pragma once

#include "lab/scene_file/model.hpp"
#include "scenes/parameters.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace carom::lab
{

/// How large a scene is, in a number that means something else for each.
struct FieldSize
{
    int min = 1;
    int initial = 1; ///< the size that is measured
    int max = 1;
    std::string what; ///< "rows of boxes"
};

struct FieldSetup
{
    int size = 1;
    std::uint64_t seed = 1;
};

struct FieldScene
{
    std::string name;
    std::string suite; ///< "box2d", "ordinary", "origin" or "nbody"
    std::string description;
    FieldSize size;
    int steps = 600; ///< how long it runs
    SceneFile (*make)(const FieldSetup&) = nullptr;
};

/// By suite.
const std::vector<FieldScene>& field_scenes();
/// Null when there is none of that name.
const FieldScene* find_field_scene(std::string_view name);

/// @throws scenes::SceneError when the size is out of range
SceneFile make_field_scene(const FieldScene& scene, const FieldSetup& setup);
/// What `--set size=N` sets.
scenes::ParameterInfo size_parameter(const FieldScene& scene);

} // namespace carom::lab
