// Bodies of rows, gathered from the body store and scattered back.
#pragma once

#include "dynamics/body_store.hpp"
#include "solver/kernels/body_lanes.hpp"

#include <cstddef>
#include <span>

namespace carom::detail
{

static_assert(sizeof(BodyMotion) == motion_floats * sizeof(float));
static_assert(offsetof(BodyMotion, w) == 2 * sizeof(float) && offsetof(BodyMotion, dp) == 3 * sizeof(float) &&
              offsetof(BodyMotion, dq) == 5 * sizeof(float));

inline float* floats_of(std::span<BodyMotion> motions) { return &motions.data()->v.x; }
inline const float* floats_of(std::span<const BodyMotion> motions) { return &motions.data()->v.x; }

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
