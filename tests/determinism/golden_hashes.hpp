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
    SceneHash{"planets", 0x6372402b42b342aa},
    SceneHash{"triggers", 0xdd748a15be11db95},
    SceneHash{"collisions", 0xa4fba7a6c8a6ace6},
    SceneHash{"gravity", 0x1d69b58ad4a2c95e},
};

inline constexpr std::uint64_t mixed_world = 0xf53d9896bde015d8;

} // namespace carom::golden
