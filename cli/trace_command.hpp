// `carom trace`: sums up a trace, and draws the memory in it.
#pragma once

#include "cli/program.hpp"

#include <optional>
#include <string>

namespace carom::cli
{

/// What the command line says.
struct TraceRequest
{
    std::string trace;
    std::optional<std::string> memory;
};

/// @throws BadUsage for a file that can't be read or is no trace, Failure
void trace_command(const TraceRequest& request, const Surroundings& surroundings);

} // namespace carom::cli
