// Looking inside a step: a probe is called after each of its stages and sees the world as it stands there.
#pragma once

#include <carom/debug_draw.hpp>
#include <carom/report.hpp>

namespace carom
{

namespace detail
{
struct MidStep;
}

/// The end of a stage.
struct StepMoment
{
    Stage stage = Stage::FindPairs;
    int substep = -1; ///< from 0; -1 for stages outside of the substeps
    int substeps = 0; ///< of the step
};

/// The world as it stands in the middle of a step. Valid during the call that it is given to.
class StepView
{
public:
    StepView(const StepView&) = delete;
    StepView& operator=(const StepView&) = delete;

    /// Shows to the visitor what is true at this moment, through the same calls as World::debug_draw:
    /// - Bodies and shapes are where the substeps have brought them, with the velocities of this moment. A state that has run away may be infinite or
    ///   NaN until Stage::FinalizeBodies.
    /// - Impulses of contacts and forces of joints, from Stage::BuildRows on, are what this step has applied so far: they start from 0, and each
    ///   pass shows what it changed. A force is that impulse over the length of the whole step. Points of contacts and their separations
    ///   follow the bodies. Before, after Stage::FindPairs, contacts and forces are those of the last step; Stage::UpdateManifolds makes new points, whose
    ///   impulses are 0.
    /// - Sleepers show what they carried last.
    /// - Bounds change in Stage::FinalizeBodies and Stage::Continuous, nodes of the broad phase in Stage::FindPairs, colours and islands in
    ///   Stage::UpdateManifolds (islands of sleepers in Stage::Sleep too), DebugContact::is_touching in Stage::EmitEvents.
    /// It changes nothing, and takes memory from the global heap.
    /// @throws UsageError when `parts` has bits that are no part
    void debug_draw(DebugDraw& visitor, DrawPart parts = DrawPart::All) const;

private:
    friend struct detail::MidStep;
    explicit StepView(const detail::MidStep& moment) : moment_(&moment) {}

    const detail::MidStep* moment_;
};

/// Derive and hand to World::step. A probe does not change what the step does, to the bit. It may read the world, whose bodies are where the
/// step began until Stage::FinalizeBodies; changing or querying it throws UsageError, as during a step. An exception that leaves a probe stops the step, and the world is then as
/// after a step that its memory resource stopped.
class StepProbe
{
public:
    virtual ~StepProbe() = default;

    /// Called at the end of each stage, in the order of the step: FindPairs, UpdateManifolds, BuildRows, Restitution; in each substep
    /// IntegrateVelocities, WarmStart, Solve, IntegratePositions, Relax; then StoreImpulses, FinalizeBodies, Continuous, EmitEvents, Sleep. A step that takes
    /// no time has FindPairs, UpdateManifolds, BuildRows and EmitEvents alone. The probe's time is in StepReport::seconds, and in no
    /// stage's.
    virtual void after_stage(const StepMoment& moment, const StepView& view) = 0;
};

} // namespace carom
