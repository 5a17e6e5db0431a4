// Area, centre and polar moment of shapes, before a density makes them a mass.
#pragma once

#include "geometry/vec2d.hpp"

#include <carom/shape.hpp>

namespace carom::detail
{

/// Integrals over a shape's area.
struct AreaMoments
{
    double area = 0;  ///< [m^2]
    Vec2d center;     ///< centre of area, in the shape's frame [m]
    double polar = 0; ///< integral of the squared distance from the centre [m^4]
};

// All take shapes that validate() accepts.
AreaMoments moments_of(const Circle& circle);
AreaMoments moments_of(const Capsule& capsule);
AreaMoments moments_of(const Segment& segment); ///< no area; the centre is its middle
AreaMoments moments_of(const Polygon& polygon); ///< reads vertices, count and radius only
AreaMoments moments_of(const Geometry& geometry);

/// Mass of a shape that validate() accepts; infinite when float can't hold it. mass_of() with the checks left to the caller.
MassData mass_from(const Geometry& geometry, float density);

} // namespace carom::detail
