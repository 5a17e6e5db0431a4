// What the command line asks for.
#pragma once

#include "gallery/scene_source.hpp"
#include "gallery/theme.hpp"
#include "scenes/parameters.hpp"

#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace carom::gallery
{

/// The command line asks for what can't be had.
struct BadUsage : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

struct Options
{
    std::string scene;
    std::optional<SceneSource> file; ///< a scene file, instead of the scene
    scenes::ParameterValues values;
    std::uint64_t seed = 1;
    int width = 1600; ///< [points]
    int height = 900; ///< [points]
    ThemeKind theme = ThemeKind::Dark;
    Palette palette = Palette::Scene;
    bool has_panels = true;
    std::string tab;                ///< of the panel on the right, that is open at first
    std::vector<std::string> shown; ///< names of overlays
    int frames = 0;                 ///< after which the program ends; 0 to go on until a person ends it
    int inside = -1;                ///< the moment of the first step that is shown; -1 to let the scene run
    bool is_json = false;
    std::filesystem::path screenshot; ///< of the last frame; empty for none
    std::filesystem::path widgets;    ///< where the map of widgets goes; empty for none
};

/// @param arguments without the program's name
/// @param out       gets the help or the version when that is asked for, and nothing is returned
/// @throws BadUsage, SceneError
std::optional<Options> read_options(const std::vector<std::string>& arguments, std::ostream& out);

} // namespace carom::gallery
