// Bodies of rows, gathered from the body store and scattered back.
#pragma once

#include "dynamics/body_store.hpp"
#include "solver/kernels/body_lanes.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace carom::detail
{

static_assert(sizeof(BodyMotion) == motion_floats * sizeof(float));
static_assert(offsetof(BodyMotion, w) == 2 * sizeof(float) && offsetof(BodyMotion, dp) == 3 * sizeof(float) &&
              offsetof(BodyMotion, dq) == 5 * sizeof(float));

inline float* floats_of(std::span<BodyMotion> motions) { return &motions.data()->v.x; }
inline const float* floats_of(std::span<const BodyMotion> motions) { return &motions.data()->v.x; }

/// Writes the bodies of a contact or a joint into lane `i` of its row: who they are, who of them can be pushed, and how heavy they are.
/// @param body_a, body_b motion indices
template <class Row>
void fill_bodies(Row& row, int i, std::uint32_t body_a, std::uint32_t body_b, const BodyMass& mass_a, const BodyMass& mass_b)
{
    const auto at = static_cast<std::size_t>(i);
    row.body_a[at] = body_a;
    row.body_b[at] = body_b;
    row.pushed_a[at] = can_be_pushed(mass_a) ? body_a : 0;
    row.pushed_b[at] = can_be_pushed(mass_b) ? body_b : 0;
    set_lane(row.inv_mass_a, i, mass_a.inv_mass);
    set_lane(row.inv_mass_b, i, mass_b.inv_mass);
    lane(row.inv_inertia_a, i) = mass_a.inv_inertia;
    lane(row.inv_inertia_b, i) = mass_b.inv_inertia;
}

template <class F>
BodyLanes<F> gather(std::span<const BodyMotion> motions, const BodyIndices<F>& indices)
{
    return gather(floats_of(motions), indices);
}

template <class F>
void scatter(std::span<BodyMotion> motions, const BodyIndices<F>& indices, const BodyLanes<F>& lanes)
{
    scatter(floats_of(motions), indices, lanes);
}

} // namespace carom::detail
