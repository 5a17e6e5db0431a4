// Solves all joints of a step: builds their rows colour by colour, runs the passes, and stores the impulses.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/joint_store.hpp"
#include "solver/joints/articulation.hpp"
#include "solver/joints/joint_row.hpp"
#include "solver/rows/graph_colors.hpp"

#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// The rows of a step in lanes of type F. Definitions are in joint_solver_impl.hpp; one source file a lane type instantiates them.
///
/// In each pass what is soft or one-sided is solved joint by joint in the order of colours, then all rigid rows together (Articulation).
template <class F>
class JointSolver
{
public:
    explicit JointSolver(std::pmr::memory_resource& memory)
        : rows_(&memory),
          stiffness_(&memory),
          corrections_(&memory),
          shares_(&memory),
          articulation_(memory)
    {
    }

    /// Makes a row of every joint that has a colour.
    void build(const ColorLists& colors, const BodyStore& bodies, const JointStore& joints, const JointStepConstants& constants);

    void warm_start(std::span<BodyMotion> motions);
    void solve(std::span<BodyMotion> motions);
    /// Linearises anew where the bodies have come to, and takes back what the bias pushed.
    void relax(std::span<BodyMotion> motions);

    /// Notes the bodies that a motor turns or pushes, or that a drive pulls to its target.
    void mark_driven(std::span<const BodyMotion> motions, std::span<BodyWatch> watches) const;
    /// @param inv_dt of the whole step [1/s]
    void store_impulses(std::span<const BodyMotion> motions, JointStore& joints, float inv_dt) const;

    /// Writes what the step has applied so far into a copy of the joints' forces.
    /// @param forces by joint slot: on B [N]
    /// @param is_within_substep whether the impulses of the substep in hand act on the bodies already, and are not yet in the sums
    void show(std::span<Vec2> forces, float inv_dt, bool is_within_substep) const;

    bool is_empty() const { return rows_.empty(); }

private:
    /// How correcting would change a body's velocity.
    struct Correction
    {
        Vec2 v;
        float w = 0;
    };

    template <class Kernel>
    void for_each_row(std::span<BodyMotion> motions, Kernel&& kernel);
    void steady_links(const ColorLists& colors, const BodyStore& bodies, const JointStore& joints);
    void plan_articulation();
    void factor();
    template <bool WithBias>
    void solve_articulation(std::span<BodyMotion> motions);
    float worst_bias() const;
    void correct(std::span<BodyMotion> motions);
    void add_correction(const ArticulatedJoint& joint, std::size_t row);
    void apply_articulation(std::span<BodyMotion> motions);
    ArticulatedJoint& articulated(std::size_t row, int lane)
    {
        return articulation_.joints[row * lane_width<F> + static_cast<std::size_t>(lane)];
    }

    std::pmr::vector<JointRow<F>> rows_;
    std::pmr::vector<float> stiffness_;        ///< by motion index: what joints oppose to turning [N m/rad]
    std::pmr::vector<Correction> corrections_; ///< by motion index
    std::pmr::vector<float> shares_;           ///< by component of the articulation: how much of its correction is applied
    Articulation articulation_;                ///< a joint a lane, in the order of the rows
    JointConstants<F> constants_ = {};
};

extern template class JointSolver<float>;

} // namespace carom::detail
