// `carom export`: writes a scene into a file that other engines can read too.
#pragma once

#include "cli/program.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carom::cli
{

/// What the command line says.
struct ExportRequest
{
    std::string scene;
    std::string file;
    std::vector<std::string> settings; ///< each NAME=VALUE
    std::optional<int> steps;
    std::uint64_t seed = 1;
    bool lists = false;   ///< the scenes of the laboratory instead
    bool is_json = false; ///< of the list
    bool schema = false;  ///< the schema of scene files instead
};

/// @throws BadUsage, Failure, or the scene's own errors
void export_command(const ExportRequest& request, const Surroundings& surroundings);

} // namespace carom::cli
