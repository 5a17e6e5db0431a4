// Acceleration of bodies by gravity fields.
#pragma once

#include "fields/barnes_hut.hpp"

#include <carom/fields.hpp>
#include <carom/math.hpp>

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// Sources of an N-body field: positions and masses, arrays of one length. A source of mass 0 pulls nothing.
struct PointMasses
{
    std::span<const Vec2> position; ///< centres of mass [m]
    std::span<const float> mass;    ///< [kg]
};

/// Adds the pull of a fixed point at each target.
/// @param targets      [m]
/// @param acceleration [m/s^2], as long as targets; added to
void add_point_field(const PointField& field, std::span<const Vec2> targets, std::span<Vec2> acceleration);

/// Sums the pull between bodies; keeps its arrays between calls, so that it allocates nothing once they have grown.
class NBodySolver
{
public:
    explicit NBodySolver(std::pmr::memory_resource& memory);

    /// Adds the pull of the sources at each target by the field's method. A source at exactly the target's position pulls nothing,
    /// so a body does not pull itself.
    /// @param are_as_before the sources and targets are those of the last call by the same field, and have hardly moved
    void add(const NBodyField& field, const PointMasses& sources, std::span<const Vec2> targets, std::span<Vec2> acceleration,
             const PullPasses& passes, bool are_as_before = false);

private:
    void gather(float gravitational_constant, const PointMasses& sources);
    void add_direct(float softening, std::span<const Vec2> targets, std::span<Vec2> acceleration, const PullPasses& passes);

    std::pmr::vector<Vec2> positions_; ///< of the sources that pull
    std::pmr::vector<float> pull_;     ///< gravitational constant times their mass [m^3/s^2]
    std::pmr::vector<Vec2> pulls_;     ///< at the targets
    InteractionList all_;
    BarnesHut barnes_hut_;
};

} // namespace carom::detail
