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
    SceneHash{"planets", 0xea478250e5166bbb},
    SceneHash{"triggers", 0xdce2d667fe27e555},
    SceneHash{"collisions", 0xd9eb16e004c2bccf},
    SceneHash{"gravity", 0xca56df53917623ae},
    SceneHash{"queries", 0x3ea9b3c34ea5e92d},
    SceneHash{"character", 0x5f705949745928ac},
    SceneHash{"chain-terrain", 0x577e82296a419770},
    SceneHash{"tiles", 0x85d3ac19385e9673},
    SceneHash{"one-way", 0x4b5fe22b1b856faf},
    SceneHash{"bullets", 0xb4d0097199098eca},
    SceneHash{"sleep", 0xcf6b1fdadf82e22d},
    SceneHash{"bridge", 0xbfecb59540c950bc},
    SceneHash{"domino", 0xfd0acc9d993a2d16},
    SceneHash{"newton-cradle", 0x77e4745f76f7ead1},
    SceneHash{"card-house", 0x6cee91470a6ce9d},
    SceneHash{"arch", 0x3707a202a135be0},
    SceneHash{"joints", 0x54a19526fce20b1a},
    SceneHash{"ragdolls", 0xfd76ca67453a6fea},
    SceneHash{"car", 0xb310c5e74628388},
    SceneHash{"mass-ratio", 0xdc30799c9a56cee6},
};

inline constexpr std::uint64_t mixed_world = 0x7001d72a4cfed87a;

} // namespace carom::golden
