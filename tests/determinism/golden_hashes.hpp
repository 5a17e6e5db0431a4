// Hashes that every build has to give, whatever the compiler, the build type and the broad phase. They change only with a change to the
// physics or to a scene, which the change log then tells.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace carom::golden
{

struct SceneHash
{
    std::string_view scene;
    std::uint64_t hash; ///< World::hash() after 240 steps of the scene with its defaults and seed 1
};

inline constexpr std::array scenes = {
    SceneHash{"planets", 0xc5a43b230ebd3135},       SceneHash{"triggers", 0xdce2d667fe27e555},
    SceneHash{"collisions", 0xf03ba3b745ac0d65},    SceneHash{"gravity", 0x8c78ba6e88bcde98},
    SceneHash{"queries", 0x8fc113a3c81b23c1},       SceneHash{"character", 0xc8b3667b5c82dca1},
    SceneHash{"chain-terrain", 0xd20981cb6fd7c93f}, SceneHash{"tiles", 0x85d3ac19385e9673},
    SceneHash{"one-way", 0x47710e96f90fc015},       SceneHash{"bullets", 0xd3cc0b163188e0f1},
    SceneHash{"sleep", 0x89f4c3687e6c4c4f},         SceneHash{"bridge", 0x4f763b44f8b29a98},
    SceneHash{"domino", 0x98b68e0cbf1c8e73},        SceneHash{"newton-cradle", 0x7d2905fee7c73d3b},
    SceneHash{"card-house", 0x9e4f029d082c323f},    SceneHash{"arch", 0xd8c75ad6617e8205},
    SceneHash{"joints", 0x83ae850a97bedeb1},        SceneHash{"ragdolls", 0x10b7131667940494},
    SceneHash{"car", 0x846f38dc057e05d1},           SceneHash{"mass-ratio", 0x9e1869b6112eb11c},
};

inline constexpr std::uint64_t mixed_world = 0x4ab4991939695407;

} // namespace carom::golden
