// The names of stages, also as zones, of categories of memory and of reasons for quarantine, as people read them.
#include "profile/stage_timer.hpp"

namespace carom
{

namespace
{

constexpr profile::ZoneSite site(const char* name) { return {name, "carom::World::step", "src/step/step.cpp", 0}; }

constexpr std::array<profile::ZoneSite, stage_count> stage_sites{site("find pairs"),          site("update manifolds"),
                                                                 site("build rows"),          site("integrate velocities"),
                                                                 site("warm start"),          site("solve"),
                                                                 site("integrate positions"), site("relax"),
                                                                 site("restitution"),         site("store impulses"),
                                                                 site("finalize bodies"),     site("continuous"),
                                                                 site("emit events"),         site("sleep")};
static_assert(stage_sites.back().name != nullptr);

constexpr profile::ZoneSite step_site = site("step");

} // namespace

namespace detail
{

const profile::ZoneSite& zone_site_of(Stage stage) { return stage_sites[static_cast<std::size_t>(stage)]; }

const profile::ZoneSite& zone_site_of_step() { return step_site; }

} // namespace detail

std::string_view name_of(Stage stage)
{
    const auto index = static_cast<std::size_t>(stage);
    return index < stage_sites.size() ? stage_sites[index].name : "?";
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

std::string_view name_of(QuarantineReason reason)
{
    switch (reason)
    {
    case QuarantineReason::NotFinite: return "not finite";
    case QuarantineReason::LeftWorld: return "left the world";
    }
    return "?";
}

} // namespace carom
