// Solves the rigid rows of all joints together, exactly: what makes a long chain hold a heavy load.
//
// Row by row, an impulse travels one joint a pass: a chain of 100 links under 100 times a link's weight needs thousands of passes. Together
// the rows are one linear system A lambda = -rhs, A = J M^-1 J^T, that is nearly empty: two joints are coupled when they share a body that
// can move. Block by block elimination (L D L^T) costs a chain or a tree no more than a few passes.
//
// Eliminating a joint couples all joints on its two bodies, as if the bodies had become one. So the plan only merges bodies and keeps for
// each merged one the list of joints that are left on it: its `front` is what the next elimination there will couple. Joints are taken by rising
// size of their fronts. One whose front is too large (a wide net) is left to be solved by itself, and counts no more.
//
// In a loop of joints rows may say the same twice, as in a net of pins, or contradict each other. Each is a very stiff spring rather than rigid:
//   (A + S) change = -rhs - S lambda,   S = 1e-5 of the diagonal of A
// In a chain or a tree they can't, and S is only what rounding asks for, so that a rope carries any load.
#pragma once

#include "solver/joints/joint_row.hpp"

#include <array>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// The softness of every row of a structure with loops, as a share of its diagonal of A. A needs it where rows say the same twice, as in a net of
/// pins, or contradict each other. What it costs: under a tension T a row creeps by T h softness times the inverse mass of its bodies, a micrometre
/// under 1 t on a link of 1 kg. Below 1e-6 the rounding of float velocities shakes nets apart; from 1e-4 on, a gear slips.
inline constexpr double loop_softness = 1e-5;
/// That of a structure without loops whose bodies may move in every way: a rope that hangs under 100,000 times a link's mass stretches by less
/// than 0.2 mm a link (RopeLoad). With loop_softness it would creep apart from 10,000 times on.
inline constexpr double tree_softness = 1e-9;

/// From this mass ratio on, arcs are left out of a component's rows (JointRow::arc). The links of such a rope tremble faster than substeps can
/// follow, and an arc that is taken from a trembling velocity, times the load's mass, shakes the rope apart. RopeLoad breaks.
inline constexpr float heavy_load = 150;

/// What the system needs to know of a joint.
struct ArticulatedJoint
{
    std::uint32_t body_a = 0; ///< motion index; 0 where the body can't be pushed
    std::uint32_t body_b = 0;
    int count = 0; ///< rigid rows, 0 to 3
    std::array<Jacobian<float>, max_rigid_rows> j;
    Vec2 inv_mass_a;
    Vec2 inv_mass_b;
    float inv_inertia_a = 0;
    float inv_inertia_b = 0;
    std::array<double, max_rigid_rows> rhs = {};      ///< in: the velocities to bring about; out: the impulses that do it
    std::array<double, max_rigid_rows> softness = {}; ///< out of factor(): what A has on its diagonal beside J M^-1 J^T
    bool is_in = false;                               ///< planned; else it is solved by itself
    std::uint32_t component = 0;                      ///< equal for all that hang together, below the number of bodies
};

class Articulation
{
public:
    explicit Articulation(std::pmr::memory_resource& memory);

    /// The joints of this step; bodies, counts and Jacobians are for the caller to fill in.
    std::pmr::vector<ArticulatedJoint> joints;

    /// Decides who is in and in which order, unless nothing has changed since the last time.
    void plan();
    /// Whether the heaviest body of a component weighs heavy_load times as much as its lightest.
    bool bears_a_load(std::uint32_t component) const;
    /// Builds and eliminates A from the Jacobians.
    void factor();
    /// Solves for all `rhs` in place.
    void solve();
    /// Solves for that part of `rhs` which the rows can bring about together. Of a contradiction only S would be left to resist, and its huge
    /// impulses, without effect here, would throw the bodies about where the Jacobians have changed.
    void solve_consistent();

private:
    /// An elimination: the joint, and where its front stands in `front_` and `blocks_`.
    struct Column
    {
        std::uint32_t joint;
        std::uint32_t front_begin;
        std::uint32_t front_end;
        std::uint32_t targets_begin; ///< in targets_: for each pair of the front the block that it changes
    };

    /// Two joints of one body: the block of A that couples them.
    struct Coupling
    {
        std::uint32_t row_joint; ///< eliminated later
        std::uint32_t column_joint;
        bool row_is_b; ///< whether the body is B of that joint
        bool column_is_b;
        std::uint32_t block;
    };

    /// What the plan was made for.
    struct Signature
    {
        std::uint32_t body_a;
        std::uint32_t body_b;
        int count;
        friend bool operator==(const Signature&, const Signature&) = default;
    };

    // Of blocks with as many rows as the joint with most has.
    template <std::size_t Rows>
    void factor_blocks();
    template <std::size_t Rows>
    void fill_blocks();
    template <std::size_t Rows>
    void eliminate_blocks();
    template <std::size_t Rows>
    void substitute();
    bool is_planned() const;
    void start_lists();
    std::uint32_t root_of(std::uint32_t body);
    void gather_front(std::uint32_t joint);
    void eliminate(std::uint32_t joint);
    void leave_out(std::uint32_t joint);
    void order_all();
    void finish_columns();
    void find_couplings();
    void find_loops();
    void weigh();
    std::uint32_t block_of(std::uint32_t row_joint, std::uint32_t column_joint) const;

    std::pmr::vector<Signature> signature_;
    std::pmr::vector<Column> columns_;
    std::pmr::vector<std::uint32_t> front_;   ///< joints, each column's by rising place
    std::pmr::vector<std::uint32_t> targets_; ///< blocks
    std::pmr::vector<Coupling> couplings_;
    std::pmr::vector<std::uint32_t> place_;                       ///< by joint: its column
    std::pmr::vector<double> diagonal_;                           ///< a block by column; its inverse after factor()
    std::pmr::vector<std::array<double, max_rigid_rows>> wanted_; ///< by joint, scratch of solve_consistent()
    std::pmr::vector<double> blocks_;                             ///< a block beside each of front_: A, then A D^-1
    std::pmr::vector<std::uint32_t> front_places_;                ///< beside front_: the column of the joint
    std::pmr::vector<double> values_;                             ///< by column, scratch of solve()

    // Scratch of a plan.
    std::pmr::vector<std::uint32_t> parent_; ///< by body: merged into
    std::pmr::vector<std::uint32_t> first_;  ///< by body: first edge 2 joint + side, or null_index
    std::pmr::vector<std::uint32_t> last_;
    std::pmr::vector<std::uint32_t> count_; ///< by body: joints left
    std::pmr::vector<std::uint32_t> next_;  ///< by edge
    std::pmr::vector<std::uint32_t> mark_;  ///< by joint: the last front that it was gathered into
    std::pmr::vector<std::uint32_t> gathered_;
    std::pmr::vector<std::uint64_t> heap_;      ///< front size and joint
    std::pmr::vector<bool> is_left_;            ///< by joint: not yet eliminated
    std::pmr::vector<bool> was_in_;             ///< by joint: what the plan decided
    std::pmr::vector<std::uint32_t> component_; ///< by joint
    std::pmr::vector<bool> has_loop_;           ///< by component
    std::pmr::vector<bool> is_held_;            ///< by component, scratch of find_loops(): whether a joint holds it to what does not move
    std::pmr::vector<double> softness_;         ///< by component, as a share of the diagonal
    std::pmr::vector<float> lightest_;          ///< by component: the inverse mass of its lightest body [1/kg]
    std::pmr::vector<float> heaviest_;          ///< of its heaviest
    std::uint32_t stamp_ = 0;
    int rows_ = 0; ///< of the joint with most
};

} // namespace carom::detail
