// Between joints and the passes: rows are filled lane by lane, handed on as plain memory, and read back.
#include "solver/joints/joint_solver.hpp"

#include "memory/make_room.hpp"
#include "solver/joints/joint_drive.hpp"
#include "solver/joints/joint_setup.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace carom::detail
{

namespace
{

/// Calls action(std::type_identity<F>()), F being the lanes of a row as they lie in memory.
template <class Action>
void with_lanes(std::uint32_t lanes, Action&& action)
{
    switch (lanes)
    {
    case 4: return action(std::type_identity<LaneArray<4>>());
    case 8: return action(std::type_identity<LaneArray<8>>());
    case 16: return action(std::type_identity<LaneArray<16>>());
    default: return action(std::type_identity<float>());
    }
}

/// One lane of a row, as a row of one lane. Rows of every width hold the same members in the same order: flags, then 4 bytes a lane each.
template <class F>
JointRow<float> lane_of(const JointRow<F>& row, std::size_t i)
{
    constexpr std::size_t head = offsetof(JointRow<float>, body_a);
    static_assert(offsetof(JointRow<F>, body_a) == head);
    constexpr std::size_t indices = 5;
    constexpr std::size_t first_one = offsetof(JointRow<float>, inv_mass_a);
    constexpr std::size_t first_wide = offsetof(JointRow<F>, inv_mass_a);
    JointRow<float> one = {};
    std::byte* const to = reinterpret_cast<std::byte*>(&one);
    const std::byte* const from = reinterpret_cast<const std::byte*>(&row);
    std::memcpy(to, from, head);
    for (std::size_t m = 0; m < indices; ++m) std::memcpy(to + head + 4 * m, from + head + m * 4 * lane_width<F> + 4 * i, 4);
    const std::size_t members = (row_bytes<float>(row.control_count, row.has_drive) - first_one) / 4;
    for (std::size_t m = 0; m < members; ++m) std::memcpy(to + first_one + 4 * m, from + first_wide + m * sizeof(F) + 4 * i, 4);
    return one;
}

std::size_t lines_for(std::size_t bytes, std::size_t line) { return (bytes + line - 1) / line; }

/// How many doubles the mechanisms of a group need in each lane: the softness, blocks, values, S and what is wanted.
std::size_t numbers_of(const MechanismPlan& plan)
{
    const auto block = static_cast<std::size_t>(plan.block_rows * plan.block_rows);
    const auto vector = static_cast<std::size_t>(plan.block_rows);
    return 1 + (plan.joint_count + plan.front_count) * block + 3 * plan.joint_count * vector;
}

/// How many floats the bodies of a group need in each lane.
constexpr std::size_t floats_of_body = (sizeof(BodyLanes<float>) + sizeof(CorrectionLanes<float>)) / sizeof(float);

} // namespace

JointSolver::JointSolver(std::pmr::memory_resource& memory)
    : plan_(memory),
      rows_(&memory),
      numbers_(&memory),
      scratch_(&memory),
      bodies_(&memory),
      pushed_(&memory),
      kinds_(&memory),
      groups_(&memory),
      is_loaded_(&memory),
      stiffness_(&memory)
{
}

template <class F>
JointRow<F>& JointSolver::row(std::size_t index)
{
    return *reinterpret_cast<JointRow<F>*>(reinterpret_cast<std::byte*>(rows_.data()) + plan_.offsets[index]);
}

const JointPasses& JointSolver::passes_for(std::uint32_t lanes) const { return lanes == 1 ? scalar_passes().joints : passes_->joints; }

/// Memory for what is planned, and the groups as the passes see them.
void JointSolver::lay_out()
{
    rows_.resize(lines_for(plan_.bytes, sizeof(Line)));
    bodies_.resize(plan_.bodies.size());
    pushed_.resize(plan_.bodies.size());
    is_loaded_.resize(plan_.slots.size());
    kinds_.clear();
    groups_.clear();
    std::size_t numbers = 0;
    std::size_t floats = 0;
    for (const PlannedGroup& group : plan_.groups)
    {
        const MechanismPlan& plan = kinds_.emplace_back(plan_.kind(group).view());
        numbers += lines_for(numbers_of(plan) * group.lanes * sizeof(double), sizeof(Line));
        floats = std::max(floats, floats_of_body * plan.body_count * group.lanes);
    }
    numbers_.resize(numbers);
    scratch_.resize(lines_for(floats * sizeof(float), sizeof(Line)));
    Line* next = numbers_.data();
    for (std::size_t g = 0; g < kinds_.size(); ++g)
    {
        const PlannedGroup& group = plan_.groups[g];
        groups_.push_back({.plan = &kinds_[g],
                           .rows = reinterpret_cast<char*>(rows_.data()),
                           .offsets = plan_.offsets.data() + group.first_row,
                           .bodies = bodies_.data() + group.first_body,
                           .pushed = pushed_.data() + group.first_body,
                           .numbers = reinterpret_cast<double*>(next),
                           .motions = reinterpret_cast<float*>(scratch_.data())});
        next += lines_for(numbers_of(kinds_[g]) * group.lanes * sizeof(double), sizeof(Line));
    }
}

void JointSolver::build(const SolverPasses& passes, const BodyStore& bodies, const JointStore& joints, const JointStepConstants& constants)
{
    passes_ = &passes;
    constants_ = {constants.h,          constants.inv_h, constants.bias_rate, constants.single.mass_scale, constants.single.impulse_scale,
                  constants.length_unit};
    if (plan_.update(bodies, joints, passes.lanes)) lay_out();
    if (plan_.rows.empty()) return;
    stiffness_.assign(bodies.masses.size(), 0);
    fill_rows(bodies, joints, constants);
    prepare_groups(bodies);
    steady_links(constants.h);
    // Preparing reads motions and writes none.
    BodyMotion* const motions = const_cast<BodyMotion*>(bodies.motions.data());
    run(&JointRowPasses::prepare, &MechanismPasses::prepare, {motions, bodies.motions.size()});
}

void JointSolver::fill_rows(const BodyStore& bodies, const JointStore& joints, const JointStepConstants& constants)
{
    for (std::size_t r = 0; r < plan_.rows.size(); ++r)
    {
        const PlannedRow planned = plan_.rows[r];
        with_lanes(planned.lanes, [&]<class F>(std::type_identity<F>)
        {
            const std::uint32_t* const slots = &plan_.slots[planned.first];
            JointRow<F>& to = start_row<F>(&row<F>(r), joints.joints[slots[0]].spec);
            for (std::uint32_t i = 0; i < planned.lanes && slots[i] != null_index; ++i)
                fill_row(to, static_cast<int>(i), slots[i], joints.joints[slots[i]], bodies, constants, stiffness_);
        });
    }
}

JointSolver::Weights JointSolver::weigh(const PlannedGroup& group, std::uint32_t lane, const BodyStore& bodies) const
{
    Weights weights = {.heaviest = std::numeric_limits<float>::infinity()};
    const std::uint32_t body_count = plan_.kind(group).body_count;
    for (std::uint32_t body = 0; body < body_count; ++body)
    {
        const std::uint32_t index = pushed_[group.first_body + body * group.lanes + lane];
        if (index == 0) continue;
        const BodyMass& mass = bodies.masses[index];
        // A body that can't move in every way takes rows away: those that are left may say the same twice without a loop.
        weights.are_free = weights.are_free && mass.inv_mass.x > 0 && mass.inv_mass.y > 0 && mass.inv_inertia > 0;
        const float most = std::max(mass.inv_mass.x, mass.inv_mass.y);
        if (!(most > 0)) continue;
        weights.lightest = std::max(weights.lightest, most);
        weights.heaviest = std::min(weights.heaviest, most);
    }
    return weights;
}

/// Bodies and softness of each mechanism, and whether it bears a heavy load.
void JointSolver::prepare_groups(const BodyStore& bodies)
{
    for (std::size_t i = 0; i < bodies_.size(); ++i)
    {
        bodies_[i] = plan_.bodies[i] == null_index ? 0 : bodies.motion_index[plan_.bodies[i]];
        pushed_[i] = can_be_pushed(bodies.masses[bodies_[i]]) ? bodies_[i] : 0;
    }
    std::fill(is_loaded_.begin(), is_loaded_.end(), std::uint8_t{0});
    for (std::size_t g = 0; g < groups_.size(); ++g)
    {
        const PlannedGroup& group = plan_.groups[g];
        for (std::uint32_t i = 0; i < group.lanes; ++i)
        {
            const Weights weights = weigh(group, i, bodies);
            groups_[g].numbers[i] = plan_.kind(group).has_loop || !weights.are_free ? loop_softness : tree_softness;
            if (!(weights.lightest > heavy_load * weights.heaviest)) continue;
            for (std::uint32_t joint = 0; joint < kinds_[g].joint_count; ++joint)
                is_loaded_[plan_.rows[group.first_row + joint].first + i] = 1;
        }
    }
}

/// Gives links under tension the inertia that substeps can follow.
void JointSolver::steady_links(float h)
{
    for (std::size_t r = 0; r < plan_.rows.size(); ++r)
    {
        const PlannedRow planned = plan_.rows[r];
        with_lanes(planned.lanes, [&]<class F>(std::type_identity<F>)
        {
            JointRow<F>& to = row<F>(r);
            for (std::uint32_t i = 0; i < planned.lanes; ++i)
            {
                const auto at = static_cast<int>(i);
                const bool is_loaded = is_loaded_[planned.first + i] != 0;
                const float pace = is_loaded ? loaded_link_pace : link_pace;
                lane(to.arc, at) = is_loaded ? 0.0f : 1.0f;
                lane(to.inv_inertia_a, at) = steady_inv_inertia(lane(to.inv_inertia_a, at), stiffness_[to.body_a[i]], h, pace);
                lane(to.inv_inertia_b, at) = steady_inv_inertia(lane(to.inv_inertia_b, at), stiffness_[to.body_b[i]], h, pace);
            }
        });
    }
}

/// Joints that are solved one by one, then mechanism by mechanism.
void JointSolver::run(JointRowPass JointRowPasses::* single, MechanismPass MechanismPasses::* together, std::span<BodyMotion> motions)
{
    if (plan_.rows.empty()) return;
    float* const floats = floats_of(motions);
    (passes_->joints.rows.*single)(reinterpret_cast<char*>(rows_.data()), plan_.offsets.data(), plan_.single_rows, floats, constants_);
    for (std::size_t g = 0; g < groups_.size(); ++g)
    {
        const MechanismPasses& of = passes_for(plan_.groups[g].lanes).mechanisms[kinds_[g].block_rows - 1];
        (of.*together)(groups_[g], floats, constants_);
    }
}

void JointSolver::warm_start(std::span<BodyMotion> motions) { run(&JointRowPasses::warm_start, &MechanismPasses::warm_start, motions); }
void JointSolver::solve(std::span<BodyMotion> motions) { run(&JointRowPasses::solve, &MechanismPasses::solve, motions); }
void JointSolver::relax(std::span<BodyMotion> motions) { run(&JointRowPasses::relax, &MechanismPasses::relax, motions); }
void JointSolver::conclude(std::span<BodyMotion> motions) { run(&JointRowPasses::conclude, &MechanismPasses::conclude, motions); }

/// Calls action(row, lane, joint slot) for every joint.
template <class Action>
void JointSolver::for_each_joint(Action&& action) const
{
    for (std::size_t r = 0; r < plan_.rows.size(); ++r)
    {
        const PlannedRow planned = plan_.rows[r];
        with_lanes(planned.lanes, [&]<class F>(std::type_identity<F>)
        {
            const JointRow<F>& from = const_cast<JointSolver&>(*this).row<F>(r);
            for (std::uint32_t i = 0; i < planned.lanes; ++i)
                if (from.joint[i] != null_index) action(from, static_cast<int>(i), from.joint[i]);
        });
    }
}

void JointSolver::store_impulses(JointStore& joints, float inv_dt) const
{
    for_each_joint([&](const auto& from, int i, std::uint32_t slot) { store_row(from, i, joints.joints[slot], inv_dt); });
}

void JointSolver::mark_driven(std::span<const BodyMotion> motions, std::span<BodyWatch> watches) const
{
    for_each_joint([&](const auto& from, int i, std::uint32_t)
    {
        if (!may_drive(from, i)) return;
        const JointRow<float> one = lane_of(from, static_cast<std::size_t>(i));
        if (!is_driven(one, gather(motions, one.body_a), gather(motions, one.body_b), constants_.length_unit)) return;
        for (const std::uint32_t body : {one.pushed_a[0], one.pushed_b[0]})
            if (body != 0) watches[body].is_driven = true;
    });
}

void JointSolver::show(std::span<Vec2> forces, float inv_dt, bool is_within_substep) const
{
    for_each_joint([&](const auto& from, int i, std::uint32_t slot)
    {
        JointRow<float> one = lane_of(from, static_cast<std::size_t>(i));
        if (is_within_substep) sum_up(one);
        forces[slot] = inv_dt * Vec2{one.total_impulse.x, one.total_impulse.y};
    });
}

} // namespace carom::detail
