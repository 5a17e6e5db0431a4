// Definitions of JointSolver, for the source files that instantiate it.
#pragma once

#include "memory/make_room.hpp"
#include "solver/joints/joint_kernels.hpp"
#include "solver/joints/joint_setup.hpp"
#include "solver/joints/joint_solver.hpp"
#include "solver/rows/integrate.hpp"

#include <algorithm>
#include <cmath>

namespace carom::detail
{

/// Joints that are to close faster than this [length units/s], [rad/s] are corrected apart from what they carry: 4 mm at 240 substeps a second. A push
/// through the velocity, taken back where the body has come to, leaves what the joints at that place do not hold.
inline constexpr float gentle_bias = 0.2f;
/// Most speed at which a body is corrected [length units/s], and most turn in a substep [rad].
inline constexpr float most_correction = 2 * max_bias;
inline constexpr float most_correction_turn = 0.1f;

template <class F>
void JointSolver<F>::build(const ColorLists& colors, const BodyStore& bodies, const JointStore& joints, const JointStepConstants& constants)
{
    rows_.clear();
    articulation_.joints.clear();
    constants_ = {F(constants.h),
                  F(constants.inv_h),
                  F(constants.rigid.bias_rate),
                  F(constants.rigid.mass_scale),
                  F(constants.rigid.impulse_scale),
                  F(constants.length_unit)};
    if (colors.size() == 0) return;
    // A row's lanes hold joints of one type and one colour; those that found no colour depend on each other and get a lane each.
    for (int color = color_count; color-- > 0;)
    {
        const int lanes = color == overflow_color ? 1 : lane_width<F>;
        for (std::size_t type = 0; type < std::variant_size_v<JointSpec>; ++type)
        {
            int next = lanes;
            std::size_t shape = 0; // rigid rows, controls and drive of the row in hand
            for (const std::uint32_t slot : colors.list(color))
            {
                const Joint& joint = joints.joints[slot];
                if (joint.spec.index() != type) continue;
                if (next == lanes || shape != shape_of(joint.spec).key())
                {
                    rows_.emplace_back(empty_row<F>(joint.spec));
                    shape = shape_of(joint.spec).key();
                    next = 0;
                }
                fill_row(rows_.back(), next++, slot, joint, bodies, constants);
            }
        }
    }
    if (rows_.empty()) return;
    plan_articulation();
    steady_links(colors, bodies, joints);
    for (JointRow<F>& row : rows_)
    {
        // Nothing has moved yet in this step.
        BodyLanes<F> still = {{F(0), F(0)}, F(0), {F(0), F(0)}, {F(1), F(0)}};
        linearise(row, still, still);
    }
    factor();
}

template <class F>
void JointSolver<F>::plan_articulation()
{
    for (const JointRow<F>& row : rows_)
    {
        for (int i = 0; i < lane_width<F>; ++i)
        {
            const auto at = static_cast<std::size_t>(i);
            ArticulatedJoint joint;
            joint.body_a = row.pushed_a[at];
            joint.body_b = row.pushed_b[at];
            joint.count = row.joint[at] == null_index ? 0 : row.rigid_count;
            joint.inv_mass_a = {lane(row.inv_mass_a.x, i), lane(row.inv_mass_a.y, i)};
            joint.inv_mass_b = {lane(row.inv_mass_b.x, i), lane(row.inv_mass_b.y, i)};
            joint.inv_inertia_a = lane(row.inv_inertia_a, i);
            joint.inv_inertia_b = lane(row.inv_inertia_b, i);
            articulation_.joints.push_back(joint);
        }
    }
    articulation_.plan();
    for (std::size_t r = 0; r < rows_.size(); ++r)
    {
        for (int i = 0; i < lane_width<F>; ++i)
        {
            const bool is_alone = articulated(r, i).count > 0 && !articulated(r, i).is_in;
            lane(rows_[r].alone, i) = is_alone ? 1.0f : 0.0f;
            rows_[r].any_alone = rows_[r].any_alone || is_alone;
        }
    }
}

/// Gives links under tension the inertia that substeps can follow.
template <class F>
void JointSolver<F>::steady_links(const ColorLists& colors, const BodyStore& bodies, const JointStore& joints)
{
    stiffness_.assign(bodies.masses.size(), 0);
    make_room(corrections_, bodies.masses.size()); // so that joints may come far off in a warm world
    make_room(shares_, bodies.masses.size());
    for (int color = 0; color < color_count; ++color)
        for (const std::uint32_t slot : colors.list(color)) add_stiffness(joints.joints[slot], bodies, stiffness_);
    const float h = lane(constants_.h, 0);
    for (std::size_t r = 0; r < rows_.size(); ++r)
    {
        JointRow<F>& row = rows_[r];
        for (int i = 0; i < lane_width<F>; ++i)
        {
            const auto at = static_cast<std::size_t>(i);
            ArticulatedJoint& joint = articulated(r, i);
            const bool is_loaded = articulation_.bears_a_load(joint.component);
            const float pace = is_loaded ? loaded_link_pace : link_pace;
            lane(row.arc, i) = is_loaded ? 0.0f : 1.0f;
            lane(row.inv_inertia_a, i) = joint.inv_inertia_a = steady_inv_inertia(joint.inv_inertia_a, stiffness_[row.body_a[at]], h, pace);
            lane(row.inv_inertia_b, i) = joint.inv_inertia_b = steady_inv_inertia(joint.inv_inertia_b, stiffness_[row.body_b[at]], h, pace);
        }
    }
}

/// Hands the Jacobians of all rigid rows on.
template <class F>
void JointSolver<F>::factor()
{
    for (std::size_t r = 0; r < rows_.size(); ++r)
    {
        const JointRow<F>& row = rows_[r];
        for (int i = 0; i < lane_width<F>; ++i)
        {
            for (std::size_t k = 0; k < static_cast<std::size_t>(row.rigid_count); ++k)
            {
                const Jacobian<F>& j = row.rigid[k];
                articulated(r, i).j[k] = {
                    {lane(j.l_a.x, i), lane(j.l_a.y, i)}, {lane(j.l_b.x, i), lane(j.l_b.y, i)}, lane(j.s_a, i), lane(j.s_b, i)};
            }
        }
    }
    articulation_.factor();
}

template <class F>
template <class Kernel>
void JointSolver<F>::for_each_row(std::span<BodyMotion> motions, Kernel&& kernel)
{
    for (JointRow<F>& row : rows_)
    {
        BodyLanes<F> a = gather<F>(motions, row.body_a);
        BodyLanes<F> b = gather<F>(motions, row.body_b);
        kernel(row, a, b);
        scatter<F>(motions, row.pushed_a, a);
        scatter<F>(motions, row.pushed_b, b);
    }
}

template <class F>
void JointSolver<F>::warm_start(std::span<BodyMotion> motions)
{
    for_each_row(motions, [](auto& row, auto& a, auto& b) { detail::warm_start(row, a, b); });
}

template <class F>
void JointSolver<F>::solve(std::span<BodyMotion> motions)
{
    if (rows_.empty()) return;
    for_each_row(motions, [this](auto& row, auto& a, auto& b)
    {
        bend(row, a, b, constants_);
        detail::solve<true>(row, constants_, a, b);
    });
    solve_articulation<true>(motions);
}

template <class F>
void JointSolver<F>::relax(std::span<BodyMotion> motions)
{
    if (rows_.empty()) return;
    for_each_row(motions, [this](auto& row, auto& a, auto& b)
    {
        linearise(row, a, b);
        detail::solve<false>(row, constants_, a, b);
    });
    factor();
    solve_articulation<false>(motions);
    for (JointRow<F>& row : rows_) sum_up(row);
}

/// (A + S) change = -(J v + curvature + bias) - S lambda, for all rigid rows at once.
template <class F>
template <bool WithBias>
void JointSolver<F>::solve_articulation(std::span<BodyMotion> motions)
{
    const bool is_far_off = WithBias && worst_bias() > gentle_bias;
    for (std::size_t r = 0; r < rows_.size(); ++r)
    {
        JointRow<F>& row = rows_[r];
        const BodyLanes<F> a = gather<F>(motions, row.body_a);
        const BodyLanes<F> b = gather<F>(motions, row.body_b);
        if constexpr (WithBias) bend(row, a, b, constants_);
        for (std::size_t k = 0; k < static_cast<std::size_t>(row.rigid_count); ++k)
        {
            F rate = velocity(row.rigid[k], a, b);
            if constexpr (WithBias) rate = rate + row.curvature[k];
            if (WithBias && !is_far_off) rate = rate + bias_of(row, k, constants_);
            for (int i = 0; i < lane_width<F>; ++i)
            {
                ArticulatedJoint& joint = articulated(r, i);
                const double held = joint.softness[k] * static_cast<double>(lane(row.lambda[k], i));
                joint.rhs[k] = joint.is_in ? -static_cast<double>(lane(rate, i)) - held : 0;
            }
        }
    }
    if constexpr (WithBias)
        articulation_.solve_consistent();
    else
        articulation_.solve();
    apply_articulation(motions);
    if (is_far_off) correct(motions);
}

template <class F>
float JointSolver<F>::worst_bias() const
{
    F worst = F(0);
    for (const JointRow<F>& row : rows_)
        for (std::size_t k = 0; k < static_cast<std::size_t>(row.rigid_count); ++k)
        {
            const F bias = bias_of(row, k, constants_) * (F(max_bias) / most_bias(row.rigid[k], constants_));
            worst = lane_max(worst, lane_max(bias, F(0) - bias));
        }
    float all = 0;
    for (int i = 0; i < lane_width<F>; ++i) all = std::max(all, lane(worst, i));
    return all;
}

/// Moves joints that are far off back into place, and leaves velocities as they are. Where joints contradict each other the equations ask for
/// a leap: each structure goes that way in proportion, and not much faster than its joints are to close.
template <class F>
void JointSolver<F>::correct(std::span<BodyMotion> motions)
{
    for (std::size_t r = 0; r < rows_.size(); ++r)
        for (std::size_t k = 0; k < static_cast<std::size_t>(rows_[r].rigid_count); ++k)
        {
            const F bias = bias_of(rows_[r], k, constants_);
            for (int i = 0; i < lane_width<F>; ++i)
                articulated(r, i).rhs[k] = articulated(r, i).is_in ? -static_cast<double>(lane(bias, i)) : 0;
        }
    articulation_.solve_consistent();

    const float most_speed = most_correction * lane(constants_.length_unit, 0);
    corrections_.assign(motions.size(), {});
    shares_.assign(motions.size(), 1);
    for (const ArticulatedJoint& joint : articulation_.joints)
        for (std::size_t k = 0; k < static_cast<std::size_t>(joint.count); ++k) add_correction(joint, k);
    for (const ArticulatedJoint& joint : articulation_.joints)
    {
        if (!joint.is_in) continue;
        float& share = shares_[joint.component];
        for (const std::uint32_t body : {joint.body_a, joint.body_b})
        {
            if (body == 0) continue;
            share = std::min(share, most_speed / std::max(length(corrections_[body].v), most_speed));
            share = std::min(share,
                             most_correction_turn / std::max(std::abs(corrections_[body].w) * lane(constants_.h, 0), most_correction_turn));
        }
    }
    const float h = lane(constants_.h, 0);
    for (const ArticulatedJoint& joint : articulation_.joints)
    {
        if (!joint.is_in) continue;
        for (const std::uint32_t body : {joint.body_a, joint.body_b})
        {
            if (body == 0) continue;
            Correction& correction = corrections_[body];
            const float part = h * shares_[joint.component];
            motions[body].dp += part * correction.v;
            motions[body].dq = turned(motions[body].dq, part * correction.w);
            correction = {}; // a body may have several joints
        }
    }
}

/// What an impulse of a row would do to the bodies.
template <class F>
void JointSolver<F>::add_correction(const ArticulatedJoint& joint, std::size_t k)
{
    const Jacobian<float>& j = joint.j[k];
    const auto lambda = static_cast<float>(joint.rhs[k]);
    Correction& a = corrections_[joint.body_a];
    Correction& b = corrections_[joint.body_b];
    a.v -= lambda * Vec2{joint.inv_mass_a.x * j.l_a.x, joint.inv_mass_a.y * j.l_a.y};
    a.w -= lambda * joint.inv_inertia_a * j.s_a;
    b.v += lambda * Vec2{joint.inv_mass_b.x * j.l_b.x, joint.inv_mass_b.y * j.l_b.y};
    b.w += lambda * joint.inv_inertia_b * j.s_b;
}

/// Applies the impulses of the last solution.
template <class F>
void JointSolver<F>::apply_articulation(std::span<BodyMotion> motions)
{
    std::size_t r = 0;
    for_each_row(motions, [&](auto& row, auto& a, auto& b)
    {
        for (std::size_t k = 0; k < static_cast<std::size_t>(row.rigid_count); ++k)
        {
            F change = F(0);
            for (int i = 0; i < lane_width<F>; ++i) lane(change, i) = static_cast<float>(articulated(r, i).rhs[k]);
            row.lambda[k] = row.lambda[k] + change;
            apply(row, row.rigid[k], change, a, b);
        }
        ++r;
    });
}

template <class F>
void JointSolver<F>::store_impulses(std::span<const BodyMotion> motions, JointStore& joints, float inv_dt) const
{
    for (const JointRow<F>& row : rows_)
    {
        const BodyLanes<F> a = gather<F>(motions, row.body_a);
        const BodyLanes<F> b = gather<F>(motions, row.body_b);
        for (int i = 0; i < lane_width<F>; ++i)
        {
            const std::uint32_t slot = row.joint[static_cast<std::size_t>(i)];
            if (slot != null_index) store_row(row, i, a, b, joints.joints[slot], inv_dt);
        }
    }
}

template <class F>
void JointSolver<F>::mark_driven(std::span<const BodyMotion> motions, std::span<BodyWatch> watches) const
{
    for (const JointRow<F>& row : rows_)
    {
        const BodyLanes<F> a = gather<F>(motions, row.body_a);
        const BodyLanes<F> b = gather<F>(motions, row.body_b);
        for (int i = 0; i < lane_width<F>; ++i)
        {
            const auto at = static_cast<std::size_t>(i);
            if (row.joint[at] == null_index || !is_driven(row, i, a, b, constants_)) continue;
            for (const std::uint32_t body : {row.pushed_a[at], row.pushed_b[at]})
                if (body != 0) watches[body].is_driven = true;
        }
    }
}

template <class F>
void JointSolver<F>::show(std::span<Vec2> forces, float inv_dt, bool is_within_substep) const
{
    for (JointRow<F> row : rows_)
    {
        if (is_within_substep) sum_up(row);
        for (int i = 0; i < lane_width<F>; ++i)
            if (const std::uint32_t slot = row.joint[static_cast<std::size_t>(i)]; slot != null_index)
                forces[slot] = inv_dt * Vec2{lane(row.total_impulse.x, i), lane(row.total_impulse.y, i)};
    }
}

} // namespace carom::detail
