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
    SceneHash{"collisions", 0xa5382a92beb1a5d4},    SceneHash{"gravity", 0x5a84487635fe4a90},
    SceneHash{"queries", 0x191fc9fce77786fd},       SceneHash{"character", 0x76b49aca99d5d22},
    SceneHash{"chain-terrain", 0xcd7202a28c9f5500}, SceneHash{"tiles", 0xb1e8a99a62e0d769},
    SceneHash{"one-way", 0x87a1164c0111541e},       SceneHash{"bullets", 0x7c0b2c6a1cafa5cf},
    SceneHash{"sleep", 0x54cb03fa4569f8cb},         SceneHash{"bridge", 0x693d096b113acb7a},
    SceneHash{"domino", 0x147ba30ebf00419b},        SceneHash{"newton-cradle", 0x1b9c9bef3d9148b7},
    SceneHash{"card-house", 0xef851043c3ac891b},    SceneHash{"arch", 0xb7fc98d59d1a4def},
    SceneHash{"mass-ratio", 0x177a1214115b7690},
};

inline constexpr std::uint64_t mixed_world = 0x85ffe9eea9f5d1e3;

} // namespace carom::golden
