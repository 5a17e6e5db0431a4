// In which order the joints of a mechanism are eliminated, and which blocks of A that fills: the plan of kernels/mechanism.hpp.
//
// Eliminating a joint couples all joints on its two bodies, as if the bodies had become one. So planning only merges bodies and keeps for
// each merged one the list of joints that are left on it: its `front` is what the next elimination there will couple. Joints are taken by rising
// size of their fronts. Where a front grows too large the mechanism is a net, which is solved joint by joint.
#pragma once

#include "solver/kernels/mechanism.hpp"

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace carom::detail
{

/// A larger front is not eliminated: its cost grows with the square of this, and a net of n joints has fronts of sqrt(n).
inline constexpr std::size_t max_front = 16;

/// A joint as a plan sees it.
struct PlannedJoint
{
    JointEnds ends;
    std::uint32_t rigid_count; ///< 1 to 3
    std::uint32_t shape;       ///< equal for joints whose rows may lie side by side

    friend bool operator==(const PlannedJoint&, const PlannedJoint&) = default;
};

/// The plan of a kind of mechanism.
struct EliminationPlan
{
    explicit EliminationPlan(std::pmr::memory_resource& memory)
        : ends(&memory),
          columns(&memory),
          front_columns(&memory),
          targets(&memory),
          couplings(&memory)
    {
    }

    /// For the passes; valid as long as this stands where it is.
    MechanismPlan view() const;

    bool is_net = false;   ///< not to be eliminated: the rest is empty
    bool has_loop = false; ///< whether rows may say the same twice, or contradict each other
    std::uint32_t body_count = 0;
    std::uint32_t block_rows = 0;
    std::pmr::vector<JointEnds> ends;
    std::pmr::vector<EliminationColumn> columns;
    std::pmr::vector<std::uint32_t> front_columns;
    std::pmr::vector<std::uint32_t> targets;
    std::pmr::vector<JointCoupling> couplings;
};

/// Makes plans. Keeps its scratch memory from one to the next.
class Eliminator
{
public:
    explicit Eliminator(std::pmr::memory_resource& memory);

    /// @param joints that hang together through bodies that can move
    /// @param can_move by body, 1 or 0
    EliminationPlan plan(std::span<const PlannedJoint> joints, std::span<const std::uint8_t> can_move, std::pmr::memory_resource& memory);

private:
    bool can_move(std::uint32_t body) const { return can_move_[body] != 0; }
    void start_lists();
    std::uint32_t root_of(std::uint32_t body);
    std::size_t front_size(std::uint32_t joint);
    void gather_front(std::uint32_t joint);
    void eliminate(std::uint32_t joint, EliminationPlan& plan);
    bool order_all(EliminationPlan& plan);
    void finish_columns(EliminationPlan& plan);
    std::uint32_t block_of(std::uint32_t row_joint, std::uint32_t column_joint, const EliminationPlan& plan) const;
    void find_couplings(EliminationPlan& plan);
    bool has_loop() const;

    std::span<const PlannedJoint> joints_;
    std::span<const std::uint8_t> can_move_;
    std::pmr::vector<std::uint32_t> parent_; ///< by body: merged into
    std::pmr::vector<std::uint32_t> first_;  ///< by body: first edge 2 joint + side, or null_index
    std::pmr::vector<std::uint32_t> last_;
    std::pmr::vector<std::uint32_t> count_; ///< by body: joints left
    std::pmr::vector<std::uint32_t> next_;  ///< by edge
    std::pmr::vector<std::uint32_t> mark_;  ///< by joint: the last front that it was gathered into
    std::pmr::vector<std::uint32_t> gathered_;
    std::pmr::vector<std::uint32_t> front_; ///< joints, each column's by rising place
    std::pmr::vector<std::uint32_t> place_; ///< by joint: its column
    std::pmr::vector<std::uint64_t> heap_;  ///< front size and joint
    std::pmr::vector<bool> is_left_;        ///< by joint: not yet eliminated
    std::uint32_t stamp_ = 0;
};

} // namespace carom::detail
