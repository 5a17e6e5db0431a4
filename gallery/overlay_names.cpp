// Finds overlays by name.
#include "gallery/overlay_names.hpp"

#include "gallery/options.hpp"

namespace carom::gallery
{

std::string overlay_names()
{
    std::string all;
    for (const OverlayName& overlay : overlays)
        if (overlay.option != &DrawOptions::shapes) all += (all.empty() ? "" : ", ") + std::string(overlay.name);
    return all;
}

bool DrawOptions::* find_overlay(std::string_view name)
{
    for (const OverlayName& overlay : overlays)
        if (overlay.name == name) return overlay.option;
    throw BadUsage("--show: \"" + std::string(name) + "\" is not known; give one of " + overlay_names());
}

} // namespace carom::gallery
