// Which engines the laboratory knows, and where their programs are.
#pragma once

#include "lab/experiment.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom::lab
{

/// Names in the order of reports: "carom"; "box2d3", and "box2d3-source", which is built from a checkout of the user's; "rapier", "box2d2"; and "origin",
/// which is Carom with the quadtree of the engine that it began as.
std::span<const std::string_view> engine_names();

/// All of them but "box2d3-source", which is among them only where it is built.
/// @param peers the folder with the peers' programs
std::vector<std::string> default_engines(const std::filesystem::path& peers);

/// @param names  of engine_names(), in the order in which they take part
/// @param carom  the `carom` program
/// @param peers  the folder with the peers' programs; those that are not there are engines without a command
/// @throws std::invalid_argument on a name that is not known, with the names that are
std::vector<Engine> find_engines(std::span<const std::string> names, const std::filesystem::path& carom,
                                 const std::filesystem::path& peers);

} // namespace carom::lab
