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

/// Neighbours in an array of records, one in each lane. Lanes past the end get records of their own in `spare`.
template <class F, class Float>
LaneRecords<F, Float> neighbors(Float* records, std::size_t floats, std::size_t first, std::size_t count, Float* spare)
{
    LaneRecords<F, Float> lanes;
    for (std::size_t i = 0; i < static_cast<std::size_t>(lane_width<F>); ++i)
        lanes.at[i] = first + i < count ? records + floats * (first + i) : spare + floats * i;
    return lanes;
}

/// The same to read from.
template <class F>
LaneRecords<F, const float> read_only(const LaneRecords<F, float>& records)
{
    LaneRecords<F, const float> lanes;
    for (std::size_t i = 0; i < static_cast<std::size_t>(lane_width<F>); ++i) lanes.at[i] = records.at[i];
    return lanes;
}

template <class F>
void integrate_all_velocities(const MotionArrays& bodies, const Pull& pull)
{
    constexpr auto width = static_cast<std::size_t>(lane_width<F>);
    float spare[width * motion_floats] = {}; // written by free lanes, and read by nobody else
    const float nothing[width * drive_floats] = {};
    const LaneVec<F> gravity = {F(pull.gravity_x), F(pull.gravity_y)};
    for (std::size_t i = 1; i < bodies.count; i += width)
    {
        const auto motions = neighbors<F, float>(bodies.motions, motion_floats, i, bodies.count, spare);
        const FourLanes<F> motion = gather_four(read_only(motions), 0);
        const FourLanes<F> mass = gather_four(neighbors<F, const float>(bodies.masses, mass_floats, i, bodies.count, nothing), 0);
        const EightLanes<F> drive = gather_eight(neighbors<F, const float>(bodies.drives, drive_floats, i, bodies.count, nothing), 0);
        BodyLanes<F> body = {{motion.f0, motion.f1}, motion.f2, {}, {}};
        integrate_velocity(body, MassLanes<F>{{mass.f0, mass.f1}, mass.f2},
                           DriveLanes<F>{{drive.f0, drive.f1}, drive.f2, {drive.f3, drive.f4}, drive.f5, drive.f6}, gravity, F(pull.h));
        scatter_four(motions, 0, FourLanes<F>{body.v.x, body.v.y, body.w, motion.f3});
    }
}

template <class F>
void integrate_all_positions(float* motions, std::size_t count, float h)
{
    constexpr auto width = static_cast<std::size_t>(lane_width<F>);
    constexpr std::size_t place = 3; // where dp and dq lie
    float spare[width * motion_floats] = {};
    for (std::size_t i = 1; i < count; i += width)
    {
        const auto records = neighbors<F, float>(motions, motion_floats, i, count, spare);
        const FourLanes<F> speed = gather_four(read_only(records), 0);
        const FourLanes<F> at = gather_four(read_only(records), place);
        BodyLanes<F> body = {{speed.f0, speed.f1}, speed.f2, {at.f0, at.f1}, {at.f2, at.f3}};
        integrate_position(body, F(h));
        scatter_four(records, place, FourLanes<F>{body.dp.x, body.dp.y, body.dq.c, body.dq.s});
    }
}

template <class F>
inline constexpr BodyPasses body_passes = {integrate_all_velocities<F>, integrate_all_positions<F>};

} // namespace carom::detail
