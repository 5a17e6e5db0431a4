// Closed forms of area, centre and inertia, in double precision around a point of the shape: exact also far from the origin.
#include "geometry/mass.hpp"
#include "geometry/validate.hpp"
#include "math/usage_error.hpp"

#include <limits>
#include <variant>

namespace carom
{

namespace detail
{

namespace
{

constexpr double pi_double = 3.14159265358979323846;

/// Integrals over parts of a shape about one fixed point o, to be added up.
struct MomentSum
{
    double area = 0;
    Vec2d first;       ///< integral of p - o
    double second = 0; ///< integral of |p - o|^2

    /// Steiner: moves the polar moment to the centre.
    AreaMoments about_center(Vec2d o) const
    {
        const Vec2d center = (1 / area) * first;
        return {area, o + center, second - area * dot(center, center)};
    }
};

/// The triangle o, o + a, o + b, counter-clockwise. With p = o + s a + t b over s, t >= 0, s + t <= 1 and D = a x b:
///     area = D / 2,  first = D (a + b) / 6,  second = D (a.a + a.b + b.b) / 12.
void add_triangle(MomentSum& sum, Vec2d a, Vec2d b)
{
    const double d = cross(a, b);
    sum.area += d / 2;
    sum.first += (d / 6) * (a + b);
    sum.second += d / 12 * (dot(a, a) + dot(a, b) + dot(b, b));
}

/// The strip of width r outside an edge of length l with middle m and outward unit normal n.
/// With p = o + m + s t + h n over |s| <= l/2 and 0 <= h <= r, odd powers of s vanish:
///     area = l r,  first = l (r m + r^2 n / 2),  second = l r m.m + l r^2 m.n + l^3 r / 12 + l r^3 / 3.
void add_strip(MomentSum& sum, Vec2d m, Vec2d n, double l, double r)
{
    sum.area += l * r;
    sum.first += l * (r * m + (r * r / 2) * n);
    sum.second += l * r * dot(m, m) + l * r * r * dot(m, n) + l * l * l * r / 12 + l * r * r * r / 3;
}

/// The sector of radius r around the corner v, from the normal n1 counter-clockwise to n2, an angle theta.
/// The mean direction needs no sine: the integral of (cos, sin) from angle 1 to angle 2 is right_perp(n2 - n1). So
///     area = theta r^2 / 2,  first = area v + r^3/3 right_perp(n2 - n1),
///     second = area v.v + 2 r^3/3 v.right_perp(n2 - n1) + theta r^4 / 4.
void add_sector(MomentSum& sum, Vec2d v, Vec2d n1, Vec2d n2, double r)
{
    const double theta = atan2(static_cast<float>(cross(n1, n2)), static_cast<float>(dot(n1, n2)));
    const double area = theta * r * r / 2;
    const Vec2d bulge = (r * r * r / 3) * right_perp(n2 - n1);
    sum.area += area;
    sum.first += area * v + bulge;
    sum.second += area * dot(v, v) + 2 * dot(v, bulge) + theta * r * r * r * r / 4;
}

} // namespace

AreaMoments moments_of(const Circle& circle)
{
    const double r = circle.radius;
    const double area = pi_double * r * r;
    return {area, Vec2d(circle.center), area * r * r / 2};
}

/// A rectangle l by 2 r and two half discs. A half disc's centroid lies 4 r / (3 pi) from its flat side; Steiner twice, from the
/// disc's centre to that centroid and on to the middle, leaves for both together: disc area (r^2/2 + l^2/4 + 4 r l / (3 pi)).
AreaMoments moments_of(const Capsule& capsule)
{
    const double r = capsule.radius;
    const Vec2d p1(capsule.p1);
    const Vec2d p2(capsule.p2);
    const double l = length(p2 - p1);
    const double rectangle = 2 * r * l;
    const double disc = pi_double * r * r;
    const double polar = rectangle * (l * l + 4 * r * r) / 12 + disc * (r * r / 2 + l * l / 4) + disc * l * 4 * r / (3 * pi_double);
    return {rectangle + disc, 0.5 * (p1 + p2), polar};
}

AreaMoments moments_of(const Segment& segment) { return {0, 0.5 * (Vec2d(segment.p1) + Vec2d(segment.p2)), 0}; }

/// A polygon grown by r falls apart into the polygon, a strip of width r along every edge, and a sector of radius r at every corner.
/// The sectors' angles add up to a full turn, so that the area is A + P r + pi r^2 (Steiner's formula).
///
///            ______
///           /|    |\        the corners of the inner polygon are vertices[i]
///          |_|____|_|
///          | |    | |
///          |_|____|_|
///           \|____|/
AreaMoments moments_of(const Polygon& polygon)
{
    const int count = polygon.count;
    const double r = polygon.radius;
    const Vec2d origin(polygon.vertices[0]);
    const auto vertex = [&](int i) { return Vec2d(polygon.vertices[static_cast<std::size_t>(i % count)]) - origin; };

    MomentSum sum;
    for (int i = 1; i + 1 < count; ++i) add_triangle(sum, vertex(i), vertex(i + 1));
    if (r > 0)
    {
        for (int i = 0; i < count; ++i)
        {
            const Vec2d edge = vertex(i + 1) - vertex(i);
            const Vec2d next_edge = vertex(i + 2) - vertex(i + 1);
            const Vec2d normal = unit(right_perp(edge));
            add_strip(sum, 0.5 * (vertex(i) + vertex(i + 1)), normal, length(edge), r);
            add_sector(sum, vertex(i + 1), normal, unit(right_perp(next_edge)), r);
        }
    }
    return sum.about_center(origin);
}

AreaMoments moments_of(const Geometry& geometry)
{
    switch (geometry.index())
    {
    case 0: return moments_of(*std::get_if<Circle>(&geometry));
    case 1: return moments_of(*std::get_if<Capsule>(&geometry));
    case 2: return moments_of(*std::get_if<Segment>(&geometry));
    default: return moments_of(*std::get_if<Polygon>(&geometry));
    }
}

MassData mass_from(const Geometry& geometry, float density)
{
    const AreaMoments moments = moments_of(geometry);
    const auto as_float = [](double value)
    { return value > std::numeric_limits<float>::max() ? std::numeric_limits<float>::infinity() : static_cast<float>(value); };
    return {as_float(density * moments.area), to_float(moments.center), as_float(density * moments.polar)};
}

} // namespace detail

MassData mass_of(const Geometry& geometry, float density)
{
    detail::require_not_negative("mass_of", "density", density);
    detail::validate(geometry, "mass_of", detail::any_world);
    const MassData mass = detail::mass_from(geometry, density);
    if (!std::isfinite(mass.mass) || !std::isfinite(mass.inertia))
    {
        detail::usage_error("mass_of", "density", density, "give a density that keeps mass and inertia finite");
    }
    return mass;
}

} // namespace carom
