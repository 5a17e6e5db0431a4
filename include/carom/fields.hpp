// Gravity beyond the world's own: everywhere the same, towards a point, or between the bodies themselves.
#pragma once

#include <carom/ids.hpp>
#include <carom/math.hpp>

#include <variant>

namespace carom
{

/// The same acceleration everywhere, on top of WorldDef::gravity.
struct UniformField
{
    Vec2 acceleration = {}; ///< [m/s^2]

    friend bool operator==(const UniformField&, const UniformField&) = default;
};

/// Pull towards a fixed point: acceleration = strength d / (|d|^2 + softening^2)^(3/2), with d from the body to the point.
struct PointField
{
    Vec2 center = {};    ///< [m]
    float strength = 0;  ///< gravitational constant times mass [m^3/s^2]; negative pushes away
    float softening = 0; ///< [m], >= 0

    friend bool operator==(const PointField&, const PointField&) = default;
};

/// How the pull between bodies is summed.
enum class NBodyMethod
{
    Direct,   ///< every pair: exact, O(n s) for n bodies and s sources
    BarnesHut ///< far groups as one mass, on quadtrees: about O(n + s), as exact as the opening angle asks
};

/// Which bodies pull.
enum class NBodySources
{
    Attractors, ///< those with BodyDef::is_attractor
    All         ///< every body that has mass
};

/// Newton's pull between bodies. A source at d from a body adds G m d / (|d|^2 + softening^2)^(3/2) to its acceleration. Bodies of
/// every type pull by their mass (a static or kinematic one by the mass its shapes would give it); dynamic bodies are pulled.
struct NBodyField
{
    float gravitational_constant = 6.674e-11f; ///< G [m^3 / (kg s^2)]
    float softening = 0;                       ///< [m], >= 0
    NBodyMethod method = NBodyMethod::BarnesHut;
    NBodySources sources = NBodySources::All;
    float opening_angle = 0.5f; ///< Barnes-Hut: a node of side w at distance d counts as one mass when w / d is less; 0 to 1.5, 0 is exact

    friend bool operator==(const NBodyField&, const NBodyField&) = default;
};

using Field = std::variant<UniformField, PointField, NBodyField>;

} // namespace carom
