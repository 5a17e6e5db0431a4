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
    SceneHash{"planets", 0x8bf3ce9aecb93f9f},
    SceneHash{"triggers", 0x8ef4714799448936},
    SceneHash{"collisions", 0x25808b25e06d12ad},
    SceneHash{"gravity", 0xfdf22a9632382a2e},
};

inline constexpr std::uint64_t mixed_world = 0x6b223cb5965e4346;

} // namespace carom::golden
