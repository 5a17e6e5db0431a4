// What a run has shown, for machines and for people.
#pragma once

#include "lab/runner.hpp"
#include "scenes/scene.hpp"

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace carom::cli
{

/// The object that `carom run --json` prints.
nlohmann::ordered_json run_json(const scenes::Scene& scene, const lab::RunResult& result);
/// The table that `carom run` prints.
std::string run_table(const scenes::Scene& scene, const lab::RunResult& result);

/// "gcc 12.2.0", "clang 22.1.0".
std::string compiler_name();
/// "Release", "Debug", ...
std::string build_type();
/// A hash as it is written: 16 hexadecimal digits.
std::string hash_text(std::uint64_t hash);

} // namespace carom::cli
