// Solves all joints of a step: builds their rows as planned, runs the passes, and stores the impulses.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/joint_store.hpp"
#include "solver/isa/solver_passes.hpp"
#include "solver/joints/joint_plan.hpp"
#include "solver/rows/softness.hpp"

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// The softness of every row of a mechanism with loops, as a share of its diagonal of A. A needs it where rows say the same twice, as in a net of
/// pins, or contradict each other. What it costs: under a tension T a row creeps by T h softness times the inverse mass of its bodies, a micrometre
/// under 1 t on a link of 1 kg. Below 1e-6 the rounding of float velocities shakes nets apart; from 1e-4 on, a gear slips.
inline constexpr double loop_softness = 1e-5;
/// That of a mechanism without loops whose bodies may move in every way: a rope that hangs under 100,000 times a link's mass stretches by less
/// than 0.2 mm a link (RopeLoad). With loop_softness it would creep apart from 10,000 times on.
inline constexpr double tree_softness = 1e-9;

/// From this mass ratio on, arcs are left out of a mechanism's rows (JointRow::arc). The links of such a rope tremble faster than substeps can
/// follow, and an arc that is taken from a trembling velocity, times the load's mass, shakes the rope apart. RopeLoad breaks.
inline constexpr float heavy_load = 150;

/// In each pass what is soft or one-sided is solved joint by joint, then the rigid rows of each mechanism together.
class JointSolver
{
public:
    explicit JointSolver(std::pmr::memory_resource& memory);

    /// Makes a row of every active joint.
    void build(const SolverPasses& passes, const BodyStore& bodies, const JointStore& joints, const JointStepConstants& constants);

    void warm_start(std::span<BodyMotion> motions);
    void solve(std::span<BodyMotion> motions);
    /// Linearises anew where the bodies have come to, and takes back what the bias pushed.
    void relax(std::span<BodyMotion> motions);
    /// Finds the joints' angles where the bodies have come to.
    void conclude(std::span<BodyMotion> motions);

    /// Notes the bodies that a motor turns or pushes, or that a drive pulls to its target.
    void mark_driven(std::span<const BodyMotion> motions, std::span<BodyWatch> watches) const;
    /// @param inv_dt of the whole step [1/s]
    void store_impulses(JointStore& joints, float inv_dt) const;

    /// Writes what the step has applied so far into a copy of the joints' forces.
    /// @param forces by joint slot: on B [N]
    /// @param is_within_substep whether the impulses of the substep in hand act on the bodies already, and are not yet in the sums
    void show(std::span<Vec2> forces, float inv_dt, bool is_within_substep) const;

private:
    /// Memory that rows of any width may begin in.
    struct alignas(64) Line
    {
        std::byte bytes[64];
    };

    /// What is heaviest and lightest of a mechanism, and whether all its bodies can move in every way.
    struct Weights
    {
        float lightest = 0; ///< inverse mass of the lightest body [1/kg]
        float heaviest = 0; ///< of the heaviest
        bool are_free = true;
    };

    template <class F>
    JointRow<F>& row(std::size_t index);
    template <class Action>
    void for_each_joint(Action&& action) const;
    void lay_out();
    void fill_rows(const BodyStore& bodies, const JointStore& joints, const JointStepConstants& constants);
    void prepare_groups(const BodyStore& bodies);
    void steady_links(float h);
    Weights weigh(const PlannedGroup& group, std::uint32_t lane, const BodyStore& bodies) const;
    const JointPasses& passes_for(std::uint32_t lanes) const;
    void run(JointRowPass JointRowPasses::* single, MechanismPass MechanismPasses::* together, std::span<BodyMotion> motions);

    const SolverPasses* passes_ = nullptr;
    JointPlan plan_;
    JointConstants<float> constants_ = {};
    std::pmr::vector<Line> rows_;
    std::pmr::vector<Line> numbers_;         ///< of all groups
    std::pmr::vector<Line> scratch_;         ///< of one group
    std::pmr::vector<std::uint32_t> bodies_; ///< beside JointPlan::bodies: motion indices
    std::pmr::vector<std::uint32_t> pushed_; ///< the same where a velocity can change, else 0
    std::pmr::vector<MechanismPlan> kinds_;  ///< by group
    std::pmr::vector<MechanismGroup> groups_;
    std::pmr::vector<std::uint8_t> is_loaded_; ///< beside JointPlan::slots: whether the mechanism bears a heavy load
    std::pmr::vector<float> stiffness_;        ///< by motion index: what joints oppose to turning [N m/rad]
};

} // namespace carom::detail
