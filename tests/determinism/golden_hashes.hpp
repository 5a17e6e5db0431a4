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
    SceneHash{"collisions", 0x4f0e86875fb1f3fa},    SceneHash{"gravity", 0x3b3a455d4b9e0141},
    SceneHash{"queries", 0x74131156f1828b82},       SceneHash{"character", 0xc8b3667b5c82dca1},
    SceneHash{"chain-terrain", 0xb01b45d30681730d}, SceneHash{"tiles", 0x85d3ac19385e9673},
    SceneHash{"one-way", 0x47710e96f90fc015},       SceneHash{"bullets", 0x5d556abcb5ea9d09},
    SceneHash{"sleep", 0x89f4c3687e6c4c4f},         SceneHash{"bridge", 0x4f763b44f8b29a98},
    SceneHash{"domino", 0xd7f642531f8c9657},        SceneHash{"newton-cradle", 0x98359510ae2eede0},
    SceneHash{"card-house", 0x9e4f029d082c323f},    SceneHash{"arch", 0xd8c75ad6617e8205},
    SceneHash{"joints", 0x6c4a1954d27689e},         SceneHash{"ragdolls", 0xf988a22a75fdbc17},
    SceneHash{"car", 0x9212a8ad76557b7e},           SceneHash{"mass-ratio", 0x9e1869b6112eb11c},
};

inline constexpr std::uint64_t mixed_world = 0x8aff831e9027316d;

} // namespace carom::golden
