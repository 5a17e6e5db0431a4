// Copies of a world: all state lies in arrays that are linked by index, so a copy is a copy of arrays. The broad phase is built anew; it does not show.
#include "edit/edits.hpp"
#include "state/guards.hpp"

namespace carom
{

using detail::WorldState;

namespace
{

/// Ends that wait to be told carry the number of their world.
void renumber(detail::EventBuffers& events, std::uint32_t world)
{
    for (ContactEnd& end : events.pending_contact_end) end.shape_a.world = end.shape_b.world = world;
    for (SensorEvent& end : events.pending_sensor_end) end.sensor.world = end.visitor.world = world;
}

void copy_state(WorldState& to, const WorldState& from)
{
    to.is_broken = true; // unless the copy comes to its end
    to.gravity = from.gravity;
    to.tuning = from.tuning;
    to.rules.mixing = from.rules.mixing; // not the hooks: they belong to the world that they were given to
    to.rules.hit_speed = from.rules.hit_speed;
    to.rules.max_pairs = from.rules.max_pairs;
    to.sleep = from.sleep;
    to.is_continuous = from.is_continuous;
    to.fields = from.fields;
    to.bodies = from.bodies;
    to.shapes = from.shapes; // and the tolerances
    to.chains = from.chains;
    to.contacts = from.contacts;
    to.joints = from.joints;
    to.islands = from.islands;
    to.pairs = from.pairs;
    to.must_review = from.must_review;
    to.step_count = from.step_count;
    to.last_substep = from.last_substep;

    to.events.clear();
    to.events.pending_contact_end = from.events.pending_contact_end;
    to.events.pending_sensor_end = from.events.pending_sensor_end;
    to.events.touching = from.events.touching;
    renumber(to.events, to.world);
    to.quarantined.clear();
    to.quarantine_reasons.clear();
    detail::reserve_for_edits(to);
    detail::set_broad_phase(to, from.broad_phase->type(), from.broad_phase_options);
    to.is_broken = false;
}

} // namespace

World World::copy(std::pmr::memory_resource* memory) const
{
    const WorldState& from = state("copy");
    detail::require_idle(from, "copy");
    World result({.gravity = from.gravity,
                  .simd = from.simd,
                  .stage_times = from.has_stage_times,
                  .memory = memory ? memory : &from.memory.upstream()});
    copy_state(result.state("copy"), from);
    return result;
}

void World::restore(const World& saved)
{
    WorldState& to = state("restore");
    detail::require_idle(to, "restore");
    detail::require_idle(saved.state("restore"), "restore");
    if (&saved != this) copy_state(to, saved.state("restore"));
}

std::uint32_t World::number() const { return state("number").world; }

} // namespace carom
