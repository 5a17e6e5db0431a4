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
    SceneHash{"planets", 0x280fd70436ef2dec},
    SceneHash{"triggers", 0xb73c363253cd4a89},
    SceneHash{"collisions", 0xc445f83f94e9fca3},
    SceneHash{"gravity", 0xc45ddd19111a7e02},
};

inline constexpr std::uint64_t mixed_world = 0x671f9b48bb039ebd;

} // namespace carom::golden
