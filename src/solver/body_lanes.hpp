// The bodies of a row, one lane each: gathered from the dense array before its kernels run, scattered back after.
#pragma once

#include "dynamics/body_store.hpp"
#include "math/lane_vec.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace carom::detail
{

/// Motion indices of the bodies on one side of a row; 0 where there is nothing to move.
template <class F>
using BodyIndices = std::array<std::uint32_t, lane_width<F>>;

/// Velocity and way of the bodies on one side of a row.
template <class F>
struct BodyLanes
{
    LaneVec<F> v;
    F w;
    LaneVec<F> dp;
    LaneRot<F> dq;
};

template <class F>
BodyLanes<F> gather(std::span<const BodyMotion> motions, const BodyIndices<F>& indices)
{
    BodyLanes<F> lanes;
    for (int i = 0; i < lane_width<F>; ++i)
    {
        const BodyMotion& motion = motions[indices[static_cast<std::size_t>(i)]];
        set_lane(lanes.v, i, motion.v);
        lane(lanes.w, i) = motion.w;
        set_lane(lanes.dp, i, motion.dp);
        lane(lanes.dq.c, i) = motion.dq.c;
        lane(lanes.dq.s, i) = motion.dq.s;
    }
    return lanes;
}

/// Writes velocities back.
/// @param indices 0 for every body that nothing pushes: kinematic bodies too, which rows of one colour may share, and whose velocity must
///                stay what it is when an infinite impulse meets their inverse mass of zero
template <class F>
void scatter(std::span<BodyMotion> motions, const BodyIndices<F>& indices, const BodyLanes<F>& lanes)
{
    for (int i = 0; i < lane_width<F>; ++i)
    {
        const std::uint32_t index = indices[static_cast<std::size_t>(i)];
        if (index == 0) continue;
        BodyMotion& motion = motions[index];
        motion.v = {lane(lanes.v.x, i), lane(lanes.v.y, i)};
        motion.w = lane(lanes.w, i);
    }
}

} // namespace carom::detail
