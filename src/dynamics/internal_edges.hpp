// Takes the bumps out of ground that is made of many shapes: no contact with a face or a corner that lies inside the surface.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/shape_store.hpp"
#include "geometry/manifold.hpp"

namespace carom::detail
{

/// The contact as it is with the whole surface. Two tiles side by side have faces and corners of their own where the floor that they make
/// has none; what slides over the seam would bump into them. Such a contact gets the normal of the tile's outer face where the shape
/// is over that face, and otherwise no points: a neighbour carries the shape there. Tiles belong together when they are shapes of one
/// body, or of bodies that no force moves and that move alike.
/// @param manifold of the contact alone, in the frame of body A
/// @return the same, changed, or without points
LocalManifold without_internal_edges(const LocalManifold& manifold, const Contact& contact, const BodyStore& bodies,
                                     const ShapeStore& shapes, const ContactStore& contacts);

} // namespace carom::detail
