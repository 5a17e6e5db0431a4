// The bodies of a row, one lane each: gathered from the dense array before its kernels run, scattered back after.
#pragma once

#include "math/lane_records.hpp"
#include "math/lane_vec.hpp"

#include <cstddef>
#include <cstdint>

namespace carom::detail
{

/// Motions as kernels see them: 8 floats a body, in the order of BodyMotion (v, w, dp, dq and a slot, which no kernel reads).
inline constexpr std::size_t motion_floats = 8;

/// Motion indices of the bodies on one side of a row; 0 where there is nothing to move.
template <class F>
using BodyIndices = LaneIndices<F>;

/// Velocity and way of the bodies on one side of a row.
template <class F>
struct BodyLanes
{
    LaneVec<F> v;
    F w;
    LaneVec<F> dp;
    LaneRot<F> dq;
};

/// Lane by lane; wide lanes have a version of their own, by transposes (solver/isa/).
template <class F>
BodyLanes<F> gather(const float* motions, const BodyIndices<F>& indices)
{
    BodyLanes<F> lanes;
    for (int i = 0; i < lane_width<F>; ++i)
    {
        const float* motion = motions + motion_floats * indices[static_cast<std::size_t>(i)];
        lane(lanes.v.x, i) = motion[0];
        lane(lanes.v.y, i) = motion[1];
        lane(lanes.w, i) = motion[2];
        lane(lanes.dp.x, i) = motion[3];
        lane(lanes.dp.y, i) = motion[4];
        lane(lanes.dq.c, i) = motion[5];
        lane(lanes.dq.s, i) = motion[6];
    }
    return lanes;
}

/// Gathers velocities, and what scatter() writes beside them; the rest is zero.
template <class F>
BodyLanes<F> gather_velocities(const float* motions, const BodyIndices<F>& indices)
{
    return gather(motions, indices);
}

/// Writes velocities back.
/// @param indices 0 for every body that nothing pushes: kinematic bodies too, which rows of one colour may share, and whose velocity must
///                stay what it is when an infinite impulse meets their inverse mass of zero
template <class F>
void scatter(float* motions, const BodyIndices<F>& indices, const BodyLanes<F>& lanes)
{
    for (int i = 0; i < lane_width<F>; ++i)
    {
        const std::uint32_t index = indices[static_cast<std::size_t>(i)];
        if (index == 0) continue;
        float* motion = motions + motion_floats * index;
        motion[0] = lane(lanes.v.x, i);
        motion[1] = lane(lanes.v.y, i);
        motion[2] = lane(lanes.w, i);
    }
}

} // namespace carom::detail
