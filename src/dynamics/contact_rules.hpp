// What the user has set for all contacts of a world.
#pragma once

#include <carom/hooks.hpp>
#include <carom/shape.hpp>

#include <cstdint>

namespace carom::detail
{

struct ContactRules
{
    std::uint32_t world = 0; ///< the number that its ids carry
    MaterialMixing mixing;
    ContactHooks* hooks = nullptr; ///< may be null
    float hit_speed = 1;           ///< [length units/s]
    int max_pairs = 0;             ///< as WorldDef has it; 0 chooses by the number of shapes
};

} // namespace carom::detail
