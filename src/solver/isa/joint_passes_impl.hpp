// Definitions of the passes over joints, for the one file of each instruction set. Templates alone, as in contact_passes_impl.hpp.
#pragma once

#include "solver/isa/joint_passes.hpp"

namespace carom::detail
{

template <class F, class Kernel>
void for_joint_rows(char* rows, const std::uint32_t* offsets, std::size_t count, float* motions, const Kernel& kernel)
{
    for (std::size_t i = 0; i < count; ++i)
    {
        JointRow<F>& row = *reinterpret_cast<JointRow<F>*>(rows + offsets[i]);
        BodyLanes<F> a = gather(motions, row.body_a);
        BodyLanes<F> b = gather(motions, row.body_b);
        kernel(row, a, b);
        scatter(motions, row.pushed_a, a);
        scatter(motions, row.pushed_b, b);
    }
}

template <class F>
[[gnu::flatten]] void prepare_joint_rows(char* rows, const std::uint32_t* offsets, std::size_t count, float* motions,
                                         const JointConstants<float>&)
{
    for (std::size_t i = 0; i < count; ++i)
    {
        JointRow<F>& row = *reinterpret_cast<JointRow<F>*>(rows + offsets[i]);
        if (measures_angle(row)) find_turn(row);
        linearise_single(row, gather(motions, row.body_a), gather(motions, row.body_b));
    }
}

template <class F>
[[gnu::flatten]] void warm_start_joint_rows(char* rows, const std::uint32_t* offsets, std::size_t count, float* motions,
                                            const JointConstants<float>&)
{
    for_joint_rows<F>(rows, offsets, count, motions, [](auto& row, auto& a, auto& b) { warm_start(row, a, b); });
}

template <class F>
[[gnu::flatten]] void solve_joint_rows(char* rows, const std::uint32_t* offsets, std::size_t count, float* motions,
                                       const JointConstants<float>& constants)
{
    const JointConstants<F> k = widened<F>(constants);
    for_joint_rows<F>(rows, offsets, count, motions, [&](auto& row, auto& a, auto& b)
    {
        bend(row, a, b, k);
        solve<true>(row, k, a, b);
    });
}

template <class F>
[[gnu::flatten]] void relax_joint_rows(char* rows, const std::uint32_t* offsets, std::size_t count, float* motions,
                                       const JointConstants<float>& constants)
{
    const JointConstants<F> k = widened<F>(constants);
    for_joint_rows<F>(rows, offsets, count, motions, [&](auto& row, auto& a, auto& b)
    {
        linearise_single(row, a, b);
        solve<false>(row, k, a, b);
        sum_up(row);
    });
}

template <class F>
[[gnu::flatten]] void conclude_joint_rows(char* rows, const std::uint32_t* offsets, std::size_t count, float* motions,
                                          const JointConstants<float>&)
{
    for (std::size_t i = 0; i < count; ++i)
    {
        JointRow<F>& row = *reinterpret_cast<JointRow<F>*>(rows + offsets[i]);
        conclude(row, gather(motions, row.body_a), gather(motions, row.body_b));
    }
}

template <class F, std::size_t Rows>
[[gnu::flatten]] void prepare_mechanisms(const MechanismGroup& group, float* motions, const JointConstants<float>&)
{
    const Mechanisms<F, Rows> m(group);
    gather_bodies(m, motions);
    for (std::uint32_t joint = 0; joint < m.plan.joint_count; ++joint)
    {
        if (measures_angle(m.row(joint))) find_turn(m.row(joint));
        linearise(m.row(joint), m.a(joint), m.b(joint));
    }
    factor(m);
}

template <class F, std::size_t Rows>
[[gnu::flatten]] void warm_start_mechanisms(const MechanismGroup& group, float* motions, const JointConstants<float>&)
{
    const Mechanisms<F, Rows> m(group);
    gather_bodies(m, motions);
    warm_start(m);
    scatter_bodies(m, motions);
}

template <class F, std::size_t Rows>
[[gnu::flatten]] void solve_mechanisms(const MechanismGroup& group, float* motions, const JointConstants<float>& constants)
{
    const Mechanisms<F, Rows> m(group);
    gather_bodies(m, motions);
    const F far_off = solve(m, widened<F>(constants));
    scatter_bodies(m, motions);
    if (any(far_off > F(0))) scatter_places(m, motions);
}

template <class F, std::size_t Rows>
[[gnu::flatten]] void relax_mechanisms(const MechanismGroup& group, float* motions, const JointConstants<float>& constants)
{
    const Mechanisms<F, Rows> m(group);
    gather_bodies(m, motions);
    relax(m, widened<F>(constants));
    scatter_bodies(m, motions);
}

template <class F, std::size_t Rows>
[[gnu::flatten]] void conclude_mechanisms(const MechanismGroup& group, float* motions, const JointConstants<float>&)
{
    const Mechanisms<F, Rows> m(group);
    gather_bodies(m, motions);
    for (std::uint32_t joint = 0; joint < m.plan.joint_count; ++joint) conclude(m.row(joint), m.a(joint), m.b(joint));
}

template <class F, std::size_t Rows>
inline constexpr MechanismPasses mechanism_passes = {&prepare_mechanisms<F, Rows>, &warm_start_mechanisms<F, Rows>,
                                                     &solve_mechanisms<F, Rows>, &relax_mechanisms<F, Rows>, &conclude_mechanisms<F, Rows>};

template <class F>
inline constexpr JointPasses joint_passes = {
    {&prepare_joint_rows<F>, &warm_start_joint_rows<F>, &solve_joint_rows<F>, &relax_joint_rows<F>, &conclude_joint_rows<F>},
    {mechanism_passes<F, 1>, mechanism_passes<F, 2>, mechanism_passes<F, 3>}};

} // namespace carom::detail
