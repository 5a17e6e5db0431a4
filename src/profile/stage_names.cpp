// The names of stages and of categories of memory, as people read them.
#include <carom/report.hpp>

namespace carom
{

std::string_view name_of(Stage stage)
{
    switch (stage)
    {
    case Stage::FindPairs: return "find pairs";
    case Stage::UpdateManifolds: return "update manifolds";
    case Stage::BuildRows: return "build rows";
    case Stage::IntegrateVelocities: return "integrate velocities";
    case Stage::WarmStart: return "warm start";
    case Stage::Solve: return "solve";
    case Stage::IntegratePositions: return "integrate positions";
    case Stage::Relax: return "relax";
    case Stage::Restitution: return "restitution";
    case Stage::StoreImpulses: return "store impulses";
    case Stage::FinalizeBodies: return "finalize bodies";
    case Stage::Continuous: return "continuous";
    case Stage::EmitEvents: return "emit events";
    case Stage::Sleep: return "sleep";
    }
    return "?";
}

std::string_view name_of(MemoryCategory category)
{
    switch (category)
    {
    case MemoryCategory::World: return "world";
    case MemoryCategory::Bodies: return "bodies";
    case MemoryCategory::Shapes: return "shapes";
    case MemoryCategory::BroadPhase: return "broad phase";
    case MemoryCategory::Contacts: return "contacts";
    case MemoryCategory::Joints: return "joints";
    case MemoryCategory::Islands: return "islands";
    case MemoryCategory::Solver: return "solver";
    case MemoryCategory::Events: return "events";
    case MemoryCategory::Scratch: return "scratch";
    }
    return "?";
}

} // namespace carom
