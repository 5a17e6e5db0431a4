// A world that steps, or whose step was stopped half-way, is left alone.
#include "state/guards.hpp"

#include "math/usage_error.hpp"

namespace carom::detail
{

void require_idle(const WorldState& world, std::string_view function)
{
    if (world.is_stepping.load(std::memory_order_relaxed)) [[unlikely]]
        usage_error(function, "world", std::string_view("stepping"), "change the world between steps, not during one");
    if (world.is_broken) [[unlikely]]
        usage_error(function, "world", std::string_view("broken"), "destroy it: its memory resource failed during a step");
}

void require_queryable(const WorldState& world, std::string_view function)
{
    if (world.is_stepping.load(std::memory_order_relaxed)) [[unlikely]]
        usage_error(function, "world", std::string_view("stepping"), "query the world between steps, not during one");
    if (world.is_broken) [[unlikely]]
        usage_error(function, "world", std::string_view("broken"), "destroy it: its memory resource failed during a step");
}

} // namespace carom::detail
