// All that a program can read of a world, in one number.
#pragma once

#include <carom/world.hpp>

#include <cstdint>

namespace carom::fuzz
{

/// World::hash() tells what later steps depend on. This tells the rest as well: names, user data, ids of materials, options, what the
/// last step reported. Fields can't be read, and are left to the hash.
std::uint64_t readable_state(const World& world);

} // namespace carom::fuzz
