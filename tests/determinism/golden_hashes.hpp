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
    SceneHash{"planets", 0x8bfc616b0baa927a},       SceneHash{"triggers", 0xdce2d667fe27e555},
    SceneHash{"collisions", 0xd9eb16e004c2bccf},    SceneHash{"gravity", 0xbec2060f26f6f5a2},
    SceneHash{"queries", 0x3ea9b3c34ea5e92d},       SceneHash{"character", 0xc8b3667b5c82dca1},
    SceneHash{"chain-terrain", 0x33b80fed8eccfe73}, SceneHash{"tiles", 0x85d3ac19385e9673},
    SceneHash{"one-way", 0x4b5fe22b1b856faf},       SceneHash{"bullets", 0x6ce5c7105fe166d},
    SceneHash{"sleep", 0x89f4c3687e6c4c4f},         SceneHash{"bridge", 0xbfecb59540c950bc},
    SceneHash{"domino", 0xe57f3fc8a5956175},        SceneHash{"newton-cradle", 0x77e4745f76f7ead1},
    SceneHash{"card-house", 0x9e4f029d082c323f},    SceneHash{"arch", 0xd8c75ad6617e8205},
    SceneHash{"joints", 0x9881b7ec3b55b3af},        SceneHash{"ragdolls", 0x88a1e802151a1da7},
    SceneHash{"car", 0xef171a07e68080fe},           SceneHash{"mass-ratio", 0x3a20a224fc55cb4c},
};

inline constexpr std::uint64_t mixed_world = 0xb5b7c27234e02be;

} // namespace carom::golden
