// The overlays by the names under which panels and the command line know them.
#pragma once

#include "gallery/overlay.hpp"

#include <array>
#include <string>
#include <string_view>

namespace carom::gallery
{

struct OverlayName
{
    const char* name;
    bool DrawOptions::* option;
    const char* tip;
};

inline constexpr std::array overlays = {
    OverlayName{"shapes", &DrawOptions::shapes, "the scene's own picture of its bodies"},
    OverlayName{"contacts", &DrawOptions::contacts, "points where shapes touch, and normals from A to B; pale where they only come near"},
    OverlayName{"impulses", &DrawOptions::impulses,
                "orange along normals, green along surfaces, pink on joints; the largest of each is longest"},
    OverlayName{"joints", &DrawOptions::joints, "anchors, and lines to the centres of mass"},
    OverlayName{"velocities", &DrawOptions::velocities, "how far each centre moves in 0.1 s"},
    OverlayName{"mass centres", &DrawOptions::mass_centers, "centres of mass, and how the bodies are turned"},
    OverlayName{"islands", &DrawOptions::islands, "a colour for each set of bodies that touch or are joined: they sleep together"},
    OverlayName{"sleep", &DrawOptions::sleep, "grey for bodies that sleep and cost nothing"},
    OverlayName{"graph colours", &DrawOptions::colors, "contacts of one colour share no body, so that all of them can be solved at once"},
    OverlayName{"names", &DrawOptions::names, "names of bodies, or their numbers"},
    OverlayName{"grid", &DrawOptions::grid, "round distances, and a bar that says how long one is (F6)"},
};

/// "contacts, impulses, ...", for messages; without the shapes, which are drawn anyway.
std::string overlay_names();
/// @throws BadUsage naming all of them
bool DrawOptions::* find_overlay(std::string_view name);

} // namespace carom::gallery
