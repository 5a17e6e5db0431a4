// Which joints lie side by side in rows, and in which order rows are solved.
//
// Joints hang together where they hold bodies that can move rigidly to each other: such a mechanism (a chain, a ragdoll, a car) is solved as one. Mechanisms
// of one kind lie side by side, one in each lane, joint for joint. A net is too wide to be solved as one: its joints, and those that hold nothing rigidly (a
// mouse, a spring), are solved one by one, colour by colour, where those of one colour share no body that can move.
//
// The plan depends on the active joints alone, and is kept until they change.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/joint_store.hpp"
#include "solver/joints/elimination.hpp"

#include <cstdint>
#include <memory_resource>
#include <span>
#include <utility>
#include <vector>

namespace carom::detail
{

/// A row to be: the joints of its lanes are JointPlan::slots from `first` on.
struct PlannedRow
{
    std::uint32_t first;
    std::uint32_t lanes;
};

/// Mechanisms of one kind, side by side.
struct PlannedGroup
{
    std::uint32_t kind;
    std::uint32_t lanes;
    std::uint32_t first_row;  ///< one for each joint
    std::uint32_t first_body; ///< in JointPlan::bodies: those of the first body of each lane, of the second, ...
};

class JointPlan
{
public:
    explicit JointPlan(std::pmr::memory_resource& memory);

    /// Makes the plan anew when the active joints are not what it was made for.
    /// @param lanes of a wide row
    /// @return whether it did
    bool update(const BodyStore& bodies, const JointStore& joints, int lanes);

    std::pmr::vector<PlannedRow> rows;       ///< first those that are solved one by one, then those of the groups
    std::pmr::vector<std::uint32_t> offsets; ///< by row: where it begins in memory [bytes]
    std::pmr::vector<std::uint32_t> slots;   ///< of joints; null_index in a free lane
    std::pmr::vector<std::uint32_t> bodies;  ///< slots; null_index for the world and in a free lane
    std::pmr::vector<PlannedGroup> groups;
    std::size_t single_rows = 0; ///< how many rows are solved one by one
    std::size_t bytes = 0;       ///< of all rows

    const EliminationPlan& kind(const PlannedGroup& group) const { return kinds_[group.kind].plan; }

private:
    /// An active joint, as far as the plan depends on it.
    struct Member
    {
        std::uint32_t slot;
        std::uint32_t body_a; ///< null_index: the world
        std::uint32_t body_b;
        std::uint32_t shape; ///< JointShape::key() and the type
        bool moves_a;        ///< whether body A can move
        bool moves_b;

        friend bool operator==(const Member&, const Member&) = default;
    };

    /// Mechanisms that differ in nothing that the plan depends on.
    struct Kind
    {
        explicit Kind(std::pmr::memory_resource& memory) : joints(&memory), can_move(&memory), plan(memory) {}

        std::uint64_t hash = 0;
        std::pmr::vector<PlannedJoint> joints;
        std::pmr::vector<std::uint8_t> can_move; ///< by body
        EliminationPlan plan;
        std::uint32_t count = 0; ///< of mechanisms in the plan
        std::uint32_t first = 0; ///< of them in same_kind_
    };

    /// A mechanism: `count` members from members_[order_[begin]] on, and its bodies in the order in which its joints name them.
    struct Component
    {
        std::uint32_t begin;
        std::uint32_t count;
        std::uint32_t bodies_begin;
        std::uint32_t bodies_end;
        std::uint32_t kind;
    };

    static Member member_of(std::uint32_t slot, const BodyStore& bodies, const JointStore& joints);
    static bool holds_rigidly(const Member& member);
    void find_components(std::size_t body_count);
    void name_bodies(Component& component);
    std::uint32_t kind_in_hand();
    void place_single_rows(std::size_t body_count, std::uint32_t lanes);
    void place_groups(std::uint32_t lanes);
    void place_group(std::uint32_t kind, std::span<const std::uint32_t> components, std::uint32_t lanes);
    std::uint32_t* place_row(std::uint32_t shape, std::uint32_t lanes);
    void index_kinds();
    void drop_unused_kinds();
    std::uint32_t root_of(std::uint32_t body);

    std::pmr::memory_resource* memory_;
    Eliminator eliminator_;
    int lanes_ = 0;
    std::uint64_t joint_revision_ = 0; ///< of the stores when the signature was taken
    std::uint64_t body_revision_ = 0;
    std::pmr::vector<Member> signature_; ///< in the order of the store's list
    std::pmr::vector<Member> members_;   ///< by slot
    std::pmr::vector<Kind> kinds_;
    std::pmr::vector<std::pair<std::uint64_t, std::uint32_t>> kind_by_hash_; ///< rising

    // Scratch.
    std::pmr::vector<Member> now_;
    std::pmr::vector<std::uint32_t> parent_; ///< by body slot: merged into
    std::pmr::vector<std::uint32_t> number_; ///< by body slot, and last the world: its component, then its place in one
    std::pmr::vector<std::uint64_t> colors_; ///< by body slot: those of its joints
    std::pmr::vector<std::uint32_t> order_;  ///< members, component by component
    std::pmr::vector<std::uint32_t> body_list_;
    std::pmr::vector<Component> components_;
    std::pmr::vector<PlannedJoint> joints_; ///< of the component in hand
    std::pmr::vector<std::uint8_t> can_move_;
    std::pmr::vector<std::uint32_t> same_kind_; ///< components, kind by kind
    std::pmr::vector<std::uint32_t> used_kinds_;
    std::pmr::vector<std::uint64_t> single_; ///< colour, shape and member of each that is solved by itself
};

} // namespace carom::detail
