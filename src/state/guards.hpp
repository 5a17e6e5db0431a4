// What every call asks of a world first.
#pragma once

#include "state/world_state.hpp"

#include <string_view>

namespace carom::detail
{

void require_idle(const WorldState& world, std::string_view function);      ///< not during step(), nor after one that was stopped
void require_queryable(const WorldState& world, std::string_view function); ///< the same for what only asks

} // namespace carom::detail
