// Solves all contacts of a step: builds their rows colour by colour, runs the passes, and stores the impulses.
#pragma once

#include "dynamics/body_store.hpp"
#include "dynamics/contact_store.hpp"
#include "solver/isa/solver_passes.hpp"
#include "solver/rows/graph_colors.hpp"
#include "solver/rows/softness.hpp"

#include <carom/events.hpp>

#include <memory>
#include <memory_resource>
#include <span>

namespace carom::detail
{

/// The rows of a step, as wide as an instruction set makes them; the width does not show in what they do.
class ContactSolver
{
public:
    virtual ~ContactSolver() = default;

    /// Makes a row of every contact that has a colour.
    virtual void build(const ColorLists& colors, const BodyStore& bodies, const ContactStore& contacts,
                       const ContactConstants& constants) = 0;

    /// Whether bounce() may have anything to do.
    virtual bool any_bounces() const = 0;
    /// Collisions that bounce, before the substeps.
    /// @param accelerations of each body by gravity and forces [m/s^2], by motion index
    virtual void bounce(std::span<BodyMotion> motions, std::span<const BodyWatch> watches, std::span<const Vec2> accelerations) = 0;
    virtual void warm_start(std::span<BodyMotion> motions) = 0;
    virtual void solve(std::span<BodyMotion> motions) = 0;
    virtual void relax(std::span<BodyMotion> motions) = 0;

    /// @param watches bodies of contacts that are still coming up begin their rest anew
    virtual void store_impulses(ContactStore& contacts, std::span<BodyWatch> watches) const = 0;
    /// Notes the bodies that a surface with a tangent speed carries, or that carry it.
    virtual void mark_driven(std::span<const BodyMotion> motions, std::span<BodyWatch> watches) const = 0;

    /// Writes what the rows hold into manifolds, as of this moment: what the step has applied so far, and where the points have come to.
    /// @param manifolds of all contacts by slot, as they were at the start of the step
    /// @param is_within_substep whether the impulses of the substep in hand act on the bodies already, and are not yet in the sums
    virtual void show(std::span<const BodyMotion> motions, std::span<Manifold> manifolds, bool is_within_substep) const = 0;
};

/// Ends a solver whose bytes go with the arena that they came from.
struct EndInArena
{
    void operator()(ContactSolver* solver) const { solver->~ContactSolver(); }
};
using ContactSolverPtr = std::unique_ptr<ContactSolver, EndInArena>;

/// A solver without rows.
/// @param arena outlives it; all that it needs comes from here
ContactSolverPtr make_contact_solver(const SolverPasses& passes, std::pmr::memory_resource& arena);

} // namespace carom::detail
