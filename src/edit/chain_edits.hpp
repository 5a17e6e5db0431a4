// Making and taking away chains. The arguments are checked already; see validate.hpp.
#pragma once

#include "state/world_state.hpp"

#include <string_view>

namespace carom::detail
{

/// Makes all segments or, when memory runs out, none.
std::uint32_t create_chain(WorldState& world, std::uint32_t body, const ChainDef& def);
void destroy_chain(WorldState& world, std::uint32_t chain);

/// The segment after this one; null_index after the last one of an open chain and of a loop.
std::uint32_t next_segment(const WorldState& world, std::uint32_t chain, std::uint32_t shape);

/// Throws UsageError when the shape is a chain's segment.
void require_no_segment(const WorldState& world, std::uint32_t shape, std::string_view function, std::string_view remedy);

} // namespace carom::detail
