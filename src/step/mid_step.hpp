// The middle of a step, as a probe sees it.
#pragma once

#include "solver/rows/contact_solver.hpp"
#include "state/world_state.hpp"

#include <carom/step_probe.hpp>

namespace carom::detail
{

/// A world, and what the solver still holds for itself.
struct MidStep
{
    const WorldState& world;
    const ContactSolver& solver; ///< of this step; the joints' is in the world
    float dt;                    ///< of the step [s]
    Stage stage;                 ///< that has just ended

    StepView view() const { return StepView(*this); }
    /// Whether impulses are in rows: made, and not stored yet.
    bool is_solving() const
    {
        if (!(dt > 0)) return false; // then nothing is solved
        return stage == Stage::BuildRows || stage == Stage::Restitution || (stage >= Stage::IntegrateVelocities && stage <= Stage::Relax);
    }
    /// Whether the impulses of the substep in hand act on the bodies, and are not in the rows' sums yet.
    bool is_within_substep() const { return stage >= Stage::WarmStart && stage <= Stage::IntegratePositions; }
};

} // namespace carom::detail
