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
    SceneHash{"planets", 0xd494360bb22faa1d},       SceneHash{"triggers", 0x43f1fae814c8a07a},
    SceneHash{"collisions", 0xdbdfef193a319223},    SceneHash{"gravity", 0xf7e8d8a7fc207604},
    SceneHash{"queries", 0x269d2b7be6e314c2},       SceneHash{"character", 0x2304f2d2e9376e7a},
    SceneHash{"chain-terrain", 0x207e3061ec884879}, SceneHash{"tiles", 0xcb7a63b26891a349},
    SceneHash{"one-way", 0x80bccb7b27b0c185},       SceneHash{"bullets", 0x83d31c032173423d},
    SceneHash{"sleep", 0xa8f6c409a6274b5d},         SceneHash{"bridge", 0xe707522ccb21e2a},
    SceneHash{"domino", 0x6800d3c7673e9aeb},        SceneHash{"newton-cradle", 0xa14c08344bfef025},
    SceneHash{"card-house", 0x6cee91470a6ce9d},     SceneHash{"arch", 0x3707a202a135be0},
    SceneHash{"joints", 0x76b800ae5291ac49},        SceneHash{"ragdolls", 0xe3d252030cf0ff97},
    SceneHash{"car", 0x8c67068cafb50c0e},           SceneHash{"mass-ratio", 0xc0b2aba2df98d478},
};

inline constexpr std::uint64_t mixed_world = 0x97e300b2da149bcb;

} // namespace carom::golden
