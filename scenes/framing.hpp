// The camera of a scene, from the part of the world that it is about.
#pragma once

#include "scenes/camera.hpp"

#include <carom/carom.hpp>

#include <optional>

namespace carom::scenes
{

/// The bounds of all bodies that can move, as they are now; none when there is none.
std::optional<Aabb> movable_bounds(const World& world);

/// Shows a box with a margin around it, and room for captions above; a picture of any shape does.
Camera framed(const Aabb& content);
/// Shows what can move now, and a box where it will go.
Camera framed(const World& world, const Aabb& more);
/// Shows a field that fills the picture, captions over it: for scenes that walls enclose.
Camera framed_field(const Aabb& field);

/// The corners of what a picture of 16 to 9 shows.
Aabb visible_box(const Camera& camera);

} // namespace carom::scenes
