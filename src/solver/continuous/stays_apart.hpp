// A test that is much cheaper than an exact time of impact, and spares most pairs that one.
#pragma once

#include "geometry/time_of_impact.hpp"

namespace carom::detail
{

/// Whether some line between the two keeps them apart on their whole ways: along its normal n, from A to B,
///   s(t) >= s(0) + min(0, n . way of B past A) - what both swing by turning
/// Asked along the faces of both, across their relative way, and from middle to middle. Where they stay apart, time_of_impact finds nothing.
/// @param least distance of the surfaces that counts as apart; well above the rounding of coordinates [m]
bool stays_apart(const ConvexPoints& a, const Sweep& way_a, const ConvexPoints& b, const Sweep& way_b, float least);

} // namespace carom::detail
