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
    SceneHash{"planets", 0x9259e249020ee02b},
    SceneHash{"triggers", 0xc1eec1acd98d5096},
    SceneHash{"collisions", 0xba70d041257301bb},
    SceneHash{"gravity", 0xb46176862dff5c7e},
};

inline constexpr std::uint64_t mixed_world = 0x29ff5b8cbabf0f5e;

} // namespace carom::golden
