// What a step did and how long each of its stages took.
#pragma once

#include <carom/broad_phase.hpp>
#include <carom/ids.hpp>
#include <carom/memory.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace carom
{

/// The stages of World::step, in their order but for Restitution, which comes before the substeps.
enum class Stage
{
    FindPairs,           ///< broad phase: new pairs of near shapes
    UpdateManifolds,     ///< narrow phase: where pairs touch
    BuildRows,           ///< colours contacts and gathers what the solver needs
    IntegrateVelocities, ///< gravity, forces, damping
    WarmStart,           ///< applies the impulses of the substep before
    Solve,               ///< contact rows with bias against overlap
    IntegratePositions,  ///< moves bodies
    Relax,               ///< contact rows without bias, with friction
    Restitution,         ///< bounces
    StoreImpulses,       ///< keeps impulses for the next step
    FinalizeBodies,      ///< transforms, bounds, quarantine
    Continuous,          ///< stops fast bodies at what they would pass through
    EmitEvents,          ///< contacts and overlaps that began, persist, ended
    Sleep                ///< islands that have come to rest
};
inline constexpr int stage_count = 14;

/// "find pairs", "update manifolds", ...
std::string_view name_of(Stage stage);

/// What a world's memory is for.
enum class MemoryCategory
{
    World,      ///< the world object itself, its fields
    Bodies,     ///< stores of bodies
    Shapes,     ///< stores of shapes and chains
    BroadPhase, ///< the tree, or whatever finds pairs
    Contacts,   ///< pairs of near shapes and their manifolds
    Joints,     ///< stores of joints
    Islands,    ///< who sleeps with whom
    Solver,     ///< colours, rows of contacts and joints, forces of fields
    Events,     ///< what the last step tells
    Scratch     ///< of a step: an arena that is reused
};
inline constexpr int memory_category_count = 10;

/// "world", "bodies", "broad phase", ...
std::string_view name_of(MemoryCategory category);

/// All that a world has taken from its memory resource.
struct MemoryReport
{
    MemoryStats total;
    std::array<MemoryStats, memory_category_count> categories;

    const MemoryStats& of(MemoryCategory category) const { return categories[static_cast<std::size_t>(category)]; }
};

/// Why a step put a body aside.
enum class QuarantineReason
{
    NotFinite, ///< its place or velocity became NaN, infinite or larger than 1e15
    LeftWorld  ///< its origin or its centre of mass went beyond max_coordinate
};

/// "not finite", "left the world"
std::string_view name_of(QuarantineReason reason);

/// What World::step did.
struct StepReport
{
    double seconds = 0;                                 ///< wall time of the whole step [s]; 0 without WorldDef::stage_times
    std::array<double, stage_count> stage_seconds = {}; ///< wall time by stage, over all substeps [s]; likewise

    int bodies = 0;        ///< in the world
    int awake_bodies = 0;  ///< dynamic and kinematic bodies that took part in the step
    int islands = 0;       ///< awake sets of bodies that touch or are joined
    int shapes = 0;        ///< in the world
    int pairs = 0;         ///< pairs of shapes whose fattened bounds overlap
    int contacts = 0;      ///< of those, pairs that touch, as the events tell it: contacts and sensor overlaps
    int rows = 0;          ///< contacts with at least a point, near ones included: what the solver works on when the step takes time
    int colors = 0;        ///< groups of independent contacts that it made of them
    int overflow_rows = 0; ///< contacts that found no colour and were solved one by one

    /// Stiffness of contacts in this step: WorldDef::solver.contact_hertz, or an eighth of the substep rate if that is less [1/s]; 0
    /// in a step that takes no time.
    float contact_hertz = 0;
    /// A warning: substeps are so long that contacts have less than half of the stiffness that SolverTuning asks for, so that piles
    /// sink and tip over. With the defaults: fewer than 120 substeps a second. Give World::step more substeps, or step more often.
    bool is_too_long = false;

    BroadPhaseStats broad_phase; ///< of this step's search for pairs

    MemoryReport memory;         ///< after the step
    std::size_t allocations = 0; ///< requests to the world's memory resource during this step

    /// Bodies that this step put aside: each is back at the place where it was before the step, at rest and disabled. Valid until
    /// the world's next step.
    std::span<const BodyId> quarantined;
    /// Why, for each body of `quarantined`. Valid as long.
    std::span<const QuarantineReason> quarantine_reasons;
};

} // namespace carom
