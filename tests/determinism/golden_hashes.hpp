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
    SceneHash{"planets", 0xc5a43b230ebd3135},
    SceneHash{"triggers", 0xdd748a15be11db95},
    SceneHash{"collisions", 0x6bfa75e51e603293},
    SceneHash{"gravity", 0x70a77992491f7bae},
    SceneHash{"queries", 0x4b367f20849e0751},
    SceneHash{"character", 0x76b49aca99d5d22},
    SceneHash{"chain-terrain", 0x1f30528b27e0f281},
    SceneHash{"tiles", 0xb1e8a99a62e0d769},
    SceneHash{"one-way", 0x87a1164c0111541e},
};

inline constexpr std::uint64_t mixed_world = 0x36c5c6cf5d1ea574;

} // namespace carom::golden
