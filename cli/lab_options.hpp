// The options of `carom lab`.
#pragma once

#include "cli/program.hpp"

namespace CLI
{
class App;
}

namespace carom::cli
{

void add_lab_command(CLI::App& app, const Surroundings& surroundings);

} // namespace carom::cli
