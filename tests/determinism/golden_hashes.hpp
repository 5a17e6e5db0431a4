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
    SceneHash{"collisions", 0xf03ba3b745ac0d65},    SceneHash{"gravity", 0x2f3e0e8a14278613},
    SceneHash{"queries", 0x8fc113a3c81b23c1},       SceneHash{"character", 0xc8b3667b5c82dca1},
    SceneHash{"chain-terrain", 0xd20981cb6fd7c93f}, SceneHash{"tiles", 0x85d3ac19385e9673},
    SceneHash{"one-way", 0x47710e96f90fc015},       SceneHash{"bullets", 0x5d556abcb5ea9d09},
    SceneHash{"sleep", 0x89f4c3687e6c4c4f},         SceneHash{"bridge", 0x4f763b44f8b29a98},
    SceneHash{"domino", 0xe582753b3f73a391},        SceneHash{"newton-cradle", 0x98359510ae2eede0},
    SceneHash{"card-house", 0x9e4f029d082c323f},    SceneHash{"arch", 0xd8c75ad6617e8205},
    SceneHash{"joints", 0x83ae850a97bedeb1},        SceneHash{"ragdolls", 0xf988a22a75fdbc17},
    SceneHash{"car", 0x9212a8ad76557b7e},           SceneHash{"mass-ratio", 0x9e1869b6112eb11c},
};

inline constexpr std::uint64_t mixed_world = 0x4ab4991939695407;

} // namespace carom::golden
