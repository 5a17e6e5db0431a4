// The step, stage by stage. Each stage is a function that takes what it reads and writes; `run` times it, and shows the probe what it has left.
#include "step/step.hpp"

#include "dynamics/finalize_bodies.hpp"
#include "dynamics/find_pairs.hpp"
#include "dynamics/ids.hpp"
#include "edit/edits.hpp"
#include "fields/isa/pull_passes.hpp"
#include "math/usage_error.hpp"
#include "solver/continuous/continuous.hpp"
#include "solver/isa/dispatch.hpp"
#include "solver/rows/contact_solver.hpp"
#include "solver/rows/integrate.hpp"
#include "solver/rows/softness.hpp"
#include "step/check_state.hpp"
#include "step/sleep.hpp"
#include "step/stage_runner.hpp"
#include "step/update_contacts.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace carom::detail
{

namespace
{

void put_aside(WorldState& world, std::span<const LostBody> lost)
{
    for (const auto& [body, reason] : lost)
    {
        set_body_enabled(world, body, false);
        world.quarantined.push_back(id_of<BodyId>(world.bodies, body, world.world));
        world.quarantine_reasons.push_back(reason);
    }
}

/// Ends the step before anything has moved.
[[noreturn]] void refuse_crowd(WorldState& world, const PairSearch& search)
{
    world.is_broken = false; // the world is as it was before the step
    const Vec2 place = world.bodies.poses[world.shapes.records[search.crowded_shape].body].center;
    const auto number = [](float value) { return std::to_string(std::llround(value)); };
    usage_error("step", "pairs", "more than " + std::to_string(most_pairs(world.rules, world.shapes)),
                "too many shapes lie in one place: the one of index " + std::to_string(search.crowded_shape) + " alone, near (" +
                    number(place.x) + ", " + number(place.y) + "), is near at least " + std::to_string(search.crowd) +
                    " others; move them apart, destroy some, keep them from meeting by a filter, or give WorldDef::max_pairs");
}

/// Those that pulled harder than they may, by slot.
std::pmr::vector<std::uint32_t> overloaded(const JointStore& joints, std::pmr::memory_resource& scratch)
{
    std::pmr::vector<std::uint32_t> slots(&scratch);
    for (const std::uint32_t slot : joints.active)
    {
        const Joint& joint = joints.joints[slot];
        if (length(joint.force) > joint.break_force || std::abs(joint.torque) > joint.break_torque) slots.push_back(slot);
    }
    std::sort(slots.begin(), slots.end());
    return slots;
}

void break_joints(WorldState& world, std::span<const std::uint32_t> slots)
{
    for (const std::uint32_t slot : slots)
    {
        note_break(world, slot);
        destroy_joint(world, slot);
    }
}

/// Of the rows of a step.
struct RowConstants
{
    JointStepConstants joints;
    ContactConstants contacts;
};

RowConstants row_constants(const WorldState& world, float dt, int substeps)
{
    const float h = dt / static_cast<float>(substeps);
    const Tolerances& tolerances = world.shapes.tolerances;
    return {make_joint_constants(world.tuning, h, world.last_substep, tolerances),
            make_contact_constants(world.tuning, dt, h, world.last_substep, tolerances, lets_sleep(world.sleep, world.fields))};
}

/// Gathers what the solver works on.
void build_rows(JointSolver& joint_rows, ContactSolver& contact_rows, const ColorLists& colors, const BodyStore& bodies, JointStore& joints,
                const ContactStore& contacts, Simd simd, const RowConstants& constants)
{
    joint_rows.build(passes_of(simd), bodies, joints, constants.joints);
    contact_rows.build(colors, bodies, contacts, constants.contacts);
}

std::span<const Vec2> fields_at_bodies(WorldState& world, bool is_new_step)
{
    return world.field_forces.at_bodies(world.fields, world.bodies, pull_passes_of(world.simd), is_new_step);
}

void bounce(WorldState& world, ContactSolver& contacts)
{
    if (!contacts.any_bounces()) return;
    BodyStore& bodies = world.bodies;
    std::pmr::vector<Vec2> accelerations(bodies.motions.size(), Vec2{}, &world.arena);
    free_accelerations(bodies.masses, bodies.drives, world.gravity, fields_at_bodies(world, true), accelerations);
    contacts.bounce(bodies.motions, bodies.watches, accelerations);
}

/// From the velocities at the start of the step to the motions of its end.
void solve_substeps(WorldState& world, ContactSolver& contacts, float dt, int substeps, StageRunner& run)
{
    const float h = dt / static_cast<float>(substeps);
    BodyStore& bodies = world.bodies;
    JointSolver& joints = world.joint_solver;
    const BodyPasses& passes = passes_of(world.simd).bodies;
    run(Stage::Restitution, [&] { bounce(world, contacts); });
    for (int i = 0; i < substeps; ++i)
    {
        run(Stage::IntegrateVelocities, i, [&]
        {
            const std::span<const Vec2> fields = fields_at_bodies(world, i == 0);
            integrate_velocities(passes, {bodies.motions, bodies.masses, bodies.drives}, world.gravity, fields, h);
        });
        run(Stage::WarmStart, i, [&]
        {
            joints.warm_start(bodies.motions);
            contacts.warm_start(bodies.motions);
        });
        run(Stage::Solve, i, [&]
        {
            joints.solve(bodies.motions);
            contacts.solve(bodies.motions);
        });
        run(Stage::IntegratePositions, i, [&] { integrate_positions(passes, bodies.motions, h); });
        run(Stage::Relax, i, [&]
        {
            joints.relax(bodies.motions);
            contacts.relax(bodies.motions);
        });
    }
    run(Stage::StoreImpulses, [&]
    {
        contacts.store_impulses(world.contacts, bodies.watches);
        contacts.mark_driven(bodies.motions, bodies.watches);
        joints.mark_driven(bodies.motions, bodies.watches);
        joints.conclude(bodies.motions);
        joints.store_impulses(world.joints, 1 / dt);
        break_joints(world, overloaded(world.joints, world.arena));
    });
}

/// From motions to poses.
void move_bodies(WorldState& world, ContinuousCollision& continuous, float dt, StageRunner& run)
{
    FastMotion fast(world.arena);
    run(Stage::FinalizeBodies, [&]
    {
        std::pmr::vector<LostBody> lost(&world.arena);
        finalize_bodies(world.bodies, world.shapes, *world.broad_phase, dt, world.sleep.speed * world.shapes.tolerances.length_unit, lost,
                        world.is_continuous ? &fast : nullptr);
        put_aside(world, lost);
    });
    run(Stage::Continuous, [&]
    {
        continuous.run(fast, world.bodies, world.shapes, world.joints, world.contacts, world.rules, *world.broad_phase, dt);
        renew_bounds(fast.leaving_shapes, world.bodies, world.shapes, *world.broad_phase, dt);
    });
}

void count(const WorldState& world, const ColorLists& contacts, float dt, std::size_t allocations_before, StepReport& report)
{
    report.bodies = world.bodies.slots.live_count();
    report.shapes = world.shapes.slots.live_count();
    report.pairs = world.contacts.slots.live_count();
    report.colors = contacts.used_colors();
    report.overflow_rows = static_cast<int>(contacts.list(overflow_color).size());
    report.rows = static_cast<int>(contacts.size());
    report.broad_phase = world.broad_phase->stats();
    report.memory = memory_report(world);
    report.allocations = world.memory.stats().allocations - allocations_before;
    if (dt > 0)
    {
        report.contact_hertz = contact_stiffness(world.tuning, world.last_substep);
        report.is_too_long = is_too_soft(world.tuning, world.last_substep);
    }
    report.quarantined = world.quarantined;
    report.quarantine_reasons = world.quarantine_reasons;
}

void run_stages(WorldState& world, float dt, int substeps, StepProbe* probe, StepReport& report)
{
    StepClock clock(report, world.has_stage_times);
    const std::size_t allocations_before = world.memory.stats().allocations;
    world.arena.reset();
    world.quarantined.clear();
    world.quarantine_reasons.clear();
    world.events.clear();
    const ContactSolverPtr rows = make_contact_solver(passes_of(world.simd), world.arena);
    ContactSolver& solver = *rows;
    ContinuousCollision continuous(world.arena);
    StageRunner run(clock, {world, solver, dt, Stage::FindPairs}, substeps, probe);

    run(Stage::FindPairs, [&]
    {
        const PairSearch search =
            find_pairs(*world.broad_phase, world.shapes, world.bodies, world.joints, world.contacts, world.pairs, world.rules, world.arena);
        if (search.is_over_limit) refuse_crowd(world, search);
        if (search.has_idle) world.must_review = true;
        make_room_for_contacts(world);
    });
    run(Stage::UpdateManifolds, [&]
    {
        update_contacts({touch_passes_of(world.simd), world, world.shapes, world.pairs, world.events, world.rules, world.step_count},
                        world.arena);
    });
    const ColorLists colors = run(Stage::BuildRows, [&]
    {
        ColorLists lists(world.contacts, world.arena);
        if (dt > 0)
            build_rows(world.joint_solver, solver, lists, world.bodies, world.joints, world.contacts, world.simd,
                       row_constants(world, dt, substeps));
        return lists;
    });
    const bool is_at_rest = world.bodies.motions.size() == 1; // nobody is awake, and only a probe would see the stages
    if (dt > 0 && (!is_at_rest || probe))
    {
        solve_substeps(world, solver, dt, substeps, run);
        move_bodies(world, continuous, dt, run);
    }
    if (dt > 0) world.last_substep = dt / static_cast<float>(substeps);
    run(Stage::EmitEvents,
        [&] { report.contacts = emit_events(world.contacts, continuous.crossings(), world.shapes, world.rules, world.events); });
    report.awake_bodies = static_cast<int>(world.bodies.motions.size()) - 1;
    report.islands = static_cast<int>(world.islands.awake().size());
    if (dt > 0)
        run(Stage::Sleep, [&]
        {
            put_islands_to_sleep(
                world, world.events,
                {lets_sleep(world.sleep, world.fields), world.sleep.time, world.must_review, world.step_count, world.world});
            world.must_review = false;
        });

    assert(first_fault(world).empty());
    ++world.step_count;
    count(world, colors, dt, allocations_before, report);
}

} // namespace

StepReport step(WorldState& world, float dt, int substeps, StepProbe* probe)
{
    StepReport report;
    run_stages(world, dt, substeps, probe, report);
    plot_step(report);
    return report;
}

} // namespace carom::detail
