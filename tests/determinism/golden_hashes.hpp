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
    SceneHash{"planets", 0xc5a43b230ebd3135},       SceneHash{"triggers", 0xdd748a15be11db95},
    SceneHash{"collisions", 0xeb67ce56364fa2a4},    SceneHash{"gravity", 0x4d62e791b916f046},
    SceneHash{"queries", 0x145406711d8dd151},       SceneHash{"character", 0x857d68e194b0e773},
    SceneHash{"chain-terrain", 0x47df88e0c3e36ae2}, SceneHash{"tiles", 0xb1e8a99a62e0d769},
    SceneHash{"one-way", 0x87a1164c0111541e},       SceneHash{"bullets", 0xb2001786cbac86c5},
    SceneHash{"sleep", 0xcd6361869a137139},         SceneHash{"bridge", 0xa316be613bd44876},
    SceneHash{"domino", 0x22618e3fdde5b3dd},        SceneHash{"newton-cradle", 0x77d3b57055ad4ca0},
    SceneHash{"card-house", 0xc262a3fd61c0e573},    SceneHash{"arch", 0xecf027701c45731b},
    SceneHash{"joints", 0x9f46aee96d69a874},        SceneHash{"ragdolls", 0x885dc8fd3f0e6713},
    SceneHash{"car", 0x34528da1d6240a86},           SceneHash{"mass-ratio", 0xb1d649cf6bd889ec},
};

inline constexpr std::uint64_t mixed_world = 0xf136751a147692bc;

} // namespace carom::golden
