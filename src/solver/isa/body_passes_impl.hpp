// Definitions of the passes over bodies, for the one file of each instruction set (solver_passes_impl.hpp).
#pragma once

#include "math/lane_records.hpp"
#include "solver/isa/body_passes.hpp"
#include "solver/kernels/contact_records.hpp"
#include "solver/kernels/motion_kernels.hpp"

namespace carom::detail
{

/// Drives as kernels see them: force, torque, gravity scale, dampings, and one float that no kernel reads.
inline constexpr std::size_t drive_floats = 8;

/// Neighbours in an array of records, one in each lane.
template <class F, class Float>
LaneRecords<F, Float> neighbors(Float* records, std::size_t floats, std::size_t first)
{
    LaneRecords<F, Float> lanes;
    for (std::size_t i = 0; i < static_cast<std::size_t>(lane_width<F>); ++i) lanes.at[i] = records + floats * (first + i);
    return lanes;
}

/// The bodies from `first` on, one in each lane.
template <class F>
[[gnu::flatten]] void integrate_velocities_of(const MotionArrays& bodies, std::size_t first, const LaneVec<F>& gravity, const F& h)
{
    const FourLanes<F> motion = gather_four(neighbors<F, const float>(bodies.motions, motion_floats, first), 0);
    const FourLanes<F> mass = gather_four(neighbors<F, const float>(bodies.masses, mass_floats, first), 0);
    const EightLanes<F> drive = gather_eight(neighbors<F, const float>(bodies.drives, drive_floats, first), 0);
    BodyLanes<F> body = {{motion.f0, motion.f1}, motion.f2, {}, {}};
    integrate_velocity(body, MassLanes<F>{{mass.f0, mass.f1}, mass.f2},
                       DriveLanes<F>{{drive.f0, drive.f1}, drive.f2, {drive.f3, drive.f4}, drive.f5, drive.f6}, gravity, h);
    scatter_four(neighbors<F, float>(bodies.motions, motion_floats, first), 0, FourLanes<F>{body.v.x, body.v.y, body.w, motion.f3});
}

template <class F>
[[gnu::flatten]] void integrate_positions_of(float* motions, std::size_t first, const F& h)
{
    constexpr std::size_t place = 3; // where dp and dq lie
    const auto read = neighbors<F, const float>(motions, motion_floats, first);
    const FourLanes<F> speed = gather_four(read, 0);
    const FourLanes<F> at = gather_four(read, place);
    BodyLanes<F> body = {{speed.f0, speed.f1}, speed.f2, {at.f0, at.f1}, {at.f2, at.f3}};
    integrate_position(body, h);
    scatter_four(neighbors<F, float>(motions, motion_floats, first), place, FourLanes<F>{body.dp.x, body.dp.y, body.dq.c, body.dq.s});
}

/// Copies records of floats.
template <class F>
void copy_floats(float* to, const float* from, std::size_t count)
{
    for (std::size_t i = 0; i < count; ++i) to[i] = from[i];
}

template <class F>
void integrate_all_velocities(const MotionArrays& bodies, const Pull& pull)
{
    constexpr auto width = static_cast<std::size_t>(lane_width<F>);
    const LaneVec<F> gravity = {F(pull.gravity_x), F(pull.gravity_y)};
    std::size_t i = 1;
    for (; i + width <= bodies.count; i += width) integrate_velocities_of<F>(bodies, i, gravity, F(pull.h));
    if (i >= bodies.count) return;
    // The last ones, with copies of nothing in the lanes that are left.
    const std::size_t left = bodies.count - i;
    float motions[width * motion_floats] = {};
    float masses[width * mass_floats] = {};
    float drives[width * drive_floats] = {};
    copy_floats<F>(motions, bodies.motions + motion_floats * i, motion_floats * left);
    copy_floats<F>(masses, bodies.masses + mass_floats * i, mass_floats * left);
    copy_floats<F>(drives, bodies.drives + drive_floats * i, drive_floats * left);
    integrate_velocities_of<F>({motions, masses, drives, width}, 0, gravity, F(pull.h));
    copy_floats<F>(bodies.motions + motion_floats * i, motions, motion_floats * left);
}

template <class F>
void integrate_all_positions(float* motions, std::size_t count, float h)
{
    constexpr auto width = static_cast<std::size_t>(lane_width<F>);
    std::size_t i = 1;
    for (; i + width <= count; i += width) integrate_positions_of<F>(motions, i, F(h));
    if (i >= count) return;
    const std::size_t left = count - i;
    float last[width * motion_floats] = {};
    copy_floats<F>(last, motions + motion_floats * i, motion_floats * left);
    integrate_positions_of<F>(last, 0, F(h));
    copy_floats<F>(motions + motion_floats * i, last, motion_floats * left);
}

template <class F>
inline constexpr BodyPasses body_passes = {integrate_all_velocities<F>, integrate_all_positions<F>};

} // namespace carom::detail
