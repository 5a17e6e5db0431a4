// The shapes that bodies are made of, their mass, and how they behave on contact.
#pragma once

#include <carom/ids.hpp>
#include <carom/math.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <variant>

namespace carom
{

/// Most vertices of a polygon.
inline constexpr int max_polygon_vertices = 8;

/// Largest coordinate of a body and largest length of a shape that calls accept [m].
inline constexpr float max_coordinate = 1e6f;

/// Range of WorldDef::length_unit, the typical size of a body [m].
inline constexpr float min_length_unit = 0.001f;
inline constexpr float max_length_unit = 1000;

/// A disc.
struct Circle
{
    Vec2 center = {}; ///< in the body's frame [m]
    float radius = 0; ///< [m], > 0
};

/// All points within `radius` of a line segment.
struct Capsule
{
    Vec2 p1;          ///< [m]
    Vec2 p2;          ///< [m], not p1
    float radius = 0; ///< [m], > 0
};

/// A line segment without thickness or mass: an edge of the ground. Collides from both sides.
struct Segment
{
    Vec2 p1; ///< [m]
    Vec2 p2; ///< [m], not p1
};

/// A convex polygon, counter-clockwise, grown by `radius`. Made by box(), rounded_box(), convex_hull() and their kin.
struct Polygon
{
    std::array<Vec2, max_polygon_vertices> vertices; ///< [m]; the first `count` are in use
    std::array<Vec2, max_polygon_vertices> normals;  ///< outward unit normal of the edge from vertex i to vertex i + 1
    Vec2 centroid;                                   ///< [m]
    float radius = 0;                                ///< rounding [m], >= 0
    int count = 0;                                   ///< 3 to 8
};

using Geometry = std::variant<Circle, Capsule, Segment, Polygon>;

// Makers of shapes. The least sizes below are for a world of length unit 1, the default. For a world with another one, pass its
// WorldDef::length_unit to the makers too: the least sizes scale with it.

/// @param radius [m], > 0
/// @throws UsageError on a value out of range or not finite; so do all makers below
Circle circle(float radius, Vec2 center = {});
/// @param p1, p2 centres of the two ends [m], at least 1 mm apart
Capsule capsule(Vec2 p1, Vec2 p2, float radius, float length_unit = 1);
/// @param p1, p2 [m], at least 1 mm apart
Segment segment(Vec2 p1, Vec2 p2, float length_unit = 1);
/// A box around the origin.
/// @param width, height full side lengths [m], at least 1 mm
Polygon box(float width, float height, float length_unit = 1);
/// A box whose corners are rounded; `width` and `height` are the outer sizes.
/// @param radius [m], >= 0 and less than half of the shorter side by at least 0.5 mm
Polygon rounded_box(float width, float height, float radius, float length_unit = 1);
/// A box around `center`, turned by `angle` [rad].
Polygon offset_box(float width, float height, Vec2 center, float angle = 0, float length_unit = 1);
/// The convex hull of 3 or more points, of which at most 8 may be corners; points within 1 mm of each other are welded.
/// @param points [m], 3 to 64 of them
/// @param radius rounding [m], >= 0
/// @throws UsageError also when the points lie on a line, or the hull has more than 8 corners
Polygon convex_hull(std::span<const Vec2> points, float radius = 0, float length_unit = 1);
/// The same shape, moved and turned within the body's frame.
Geometry transformed(const Geometry& geometry, const Transform& transform, float length_unit = 1);

/// Mass, its centre, and its resistance to turning.
struct MassData
{
    float mass = 0;    ///< [kg]
    Vec2 center = {};  ///< in the body's frame [m]
    float inertia = 0; ///< about the centre of mass [kg m^2]
};

/// Mass of a shape of uniform density. Segments have none.
/// @param density [kg/m^2]
MassData mass_of(const Geometry& geometry, float density);
/// Bounds of a shape at a place in the world.
/// @param transform p finite [m], q a unit rotation
/// @throws UsageError on a shape or a transform that is out of range or not finite
Aabb aabb_of(const Geometry& geometry, const Transform& transform);
/// True when the point [m], given in the shape's own frame, lies in the shape or on its edge.
/// @throws UsageError on a shape that is out of range, or a point that is not finite
bool contains(const Geometry& geometry, Vec2 local_point);

/// How a surface behaves on contact. Of two surfaces friction and restitution mix by the world's MaterialMixing, rolling resistance is
/// max(a, b) times the larger radius, and tangent speeds add.
struct Material
{
    float friction = 0.6f;        ///< Coulomb's coefficient, >= 0
    float restitution = 0;        ///< part of the approach speed that comes back, 0 to 1
    float rolling_resistance = 0; ///< share of the normal force that brakes rolling, >= 0
    float tangent_speed = 0;      ///< speed of a conveyor's surface [m/s]; positive carries things to the right of the outward normal
    std::uint64_t id = 0;         ///< yours; the engine does not read it

    friend bool operator==(const Material&, const Material&) = default;
};

/// How a property of two surfaces becomes one of their contact.
enum class Mix
{
    GeometricMean, ///< sqrt(a b)
    Average,
    Minimum,
    Maximum,
    Product
};

struct MaterialMixing
{
    Mix friction = Mix::GeometricMean;
    Mix restitution = Mix::Maximum;

    friend bool operator==(const MaterialMixing&, const MaterialMixing&) = default;
};

/// Which shapes meet. Two shapes of one non-zero group always meet when it is positive, and never when it is negative;
/// otherwise each one's category must be in the other's mask.
struct Filter
{
    std::uint64_t category = 1;
    std::uint64_t mask = ~std::uint64_t{0};
    std::int32_t group = 0;

    friend bool operator==(const Filter&, const Filter&) = default;
};

/// What a shape is besides its geometry.
struct ShapeDef
{
    float density = 1; ///< [kg/m^2]; 0, or such that the shape's mass is from 1e-12 to 1e20 kg and its inertia at most 1e20 kg m^2
    Material material = {};
    Filter filter = {};
    bool is_sensor = false;      ///< reports overlaps and pushes nothing; sensors see each other too
    bool contact_events = true;  ///< begin and end of its contacts are reported; so they are when the other shape asks
    bool persist_events = false; ///< each further step of its contacts or overlaps is reported too
    bool sensor_events = true;   ///< its overlaps with sensors, or as a sensor, are found and reported
    bool hit_events = false;     ///< its collisions faster than WorldDef::hit_speed are reported
    bool pre_solve = false;      ///< its contacts are shown to ContactHooks::pre_solve before they are solved
    std::uint64_t user_data = 0; ///< yours; the engine does not read it
};

} // namespace carom
