// What a standard hash set of pairs is given.
#pragma once

#include "broadphase/broad_phase.hpp"

#include <functional>

namespace carom::detail
{

struct PairHash
{
    std::size_t operator()(const ProxyPair& pair) const { return std::hash<std::uint64_t>()(std::uint64_t{pair.a} << 32 | pair.b); }
};

} // namespace carom::detail
