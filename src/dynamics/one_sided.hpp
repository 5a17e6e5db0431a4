// One-sided segments: solid in front, on the right of the way from p1 to p2, and nothing to what comes from behind.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/shape_store.hpp"
#include "geometry/manifold.hpp"

namespace carom::detail
{

/// Notes in the contact whether one shape passes the other from behind, and takes the points away if so. What overlaps the front is
/// pushed forwards, never backwards.
/// @param manifold in the frame of body A; without points when the shapes are clear of each other
LocalManifold keep_front(const LocalManifold& manifold, Contact& contact, const BodyStore& bodies, const ShapeStore& shapes);

/// Whether one of two shapes is a one-sided segment and the other has its middle behind it.
bool comes_from_behind(const ShapeStore& shapes, std::uint32_t shape_a, std::uint32_t shape_b, const Transform& b_in_a);

} // namespace carom::detail
