// Everything that a world holds.
#pragma once

#include "broadphase/broad_phase.hpp"
#include "broadphase/pair_set.hpp"
#include "dynamics/body_store.hpp"
#include "dynamics/chain_store.hpp"
#include "dynamics/contact_rules.hpp"
#include "dynamics/contact_store.hpp"
#include "dynamics/island_store.hpp"
#include "dynamics/joint_store.hpp"
#include "dynamics/shape_store.hpp"
#include "fields/field_store.hpp"
#include "solver/joints/joint_solver.hpp"
#include "state/event_buffers.hpp"
#include "state/wake_graph.hpp"

#include <carom/memory.hpp>
#include <carom/world.hpp>

#include <atomic>
#include <cstdint>
#include <memory_resource>
#include <vector>

namespace carom::detail
{

struct WorldState
{
    WorldState(const WorldDef& def, std::pmr::memory_resource& upstream);
    WorldState(const WorldState&) = delete;
    WorldState& operator=(const WorldState&) = delete;

    std::pmr::memory_resource& memory_for(MemoryCategory category) { return memory.category(static_cast<std::size_t>(category)); }

    /// An edit passes its whole world where only these stores are asked for.
    operator WakeGraph() { return {bodies, contacts, joints, islands}; }

    TrackingResource memory; ///< all that follows comes from here
    std::uint32_t world;     ///< the number that this world's ids carry; never 0
    std::atomic<bool> is_stepping = false;
    bool is_broken = false; ///< a step was stopped half-way by the memory resource

    // What the user set.
    Vec2 gravity;
    SolverTuning tuning;
    SleepTuning sleep;
    bool is_continuous = true;
    bool has_stage_times = true;
    Simd simd; ///< never Best
    ContactRules rules;
    BroadPhaseOptions broad_phase_options;
    FieldStore fields;

    // What the world is made of.
    BodyStore bodies;
    ShapeStore shapes;
    ChainStore chains;
    ContactStore contacts;
    JointStore joints;
    IslandStore islands;
    PairSet pairs; ///< of the contacts
    BroadPhasePtr broad_phase;

    bool must_review = false; ///< an edit may have left contacts awake of which no body is

    // What a step leaves behind.
    EventBuffers events;
    std::pmr::vector<BodyId> quarantined;
    std::pmr::vector<QuarantineReason> quarantine_reasons; ///< of each of them
    std::uint64_t step_count = 0;
    float last_substep = 0; ///< [s]; 0 before the first

    // Kept so that they need not grow again.
    JointSolver joint_solver;
    FieldForces field_forces;
    LinearResource arena; ///< scratch of a step, and of nothing else
};

/// Contacts come and go in every step of a busy world: room for a quarter more before it is needed, so that a warm world does not grow.
void make_room_for_contacts(WorldState& world);

/// What the world holds now, its own object included.
MemoryReport memory_report(const WorldState& world);

} // namespace carom::detail
