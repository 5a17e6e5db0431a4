// Builds an empty world on the user's memory.
#include "world/world_state.hpp"

namespace carom::detail
{

namespace
{

/// Worlds of a process are numbered, so that an id of one is never taken for another's.
std::uint32_t next_world_number()
{
    static std::atomic<std::uint32_t> last = 0;
    std::uint32_t number = ++last;
    while (number == 0) number = ++last;
    return number;
}

} // namespace

WorldState::WorldState(const WorldDef& def, std::pmr::memory_resource& upstream)
    : memory(upstream),
      world(next_world_number()),
      gravity(def.gravity),
      tuning(def.solver),
      sleep(def.sleep),
      is_continuous(def.continuous),
      rules{.world = world, .mixing = def.mixing, .hooks = def.hooks, .hit_speed = def.hit_speed},
      broad_phase_options(def.broad_phase_options),
      fields(memory),
      bodies(memory),
      shapes(memory),
      chains(memory),
      contacts(memory),
      joints(memory),
      islands(memory),
      pairs(memory),
      broad_phase(make_broad_phase(def.broad_phase, def.broad_phase_options, memory)),
      colors(memory),
      joint_colors(memory),
      events(memory),
      quarantined(&memory),
      found_pairs(&memory),
      not_finite(&memory),
      changes(memory),
      solver(memory),
      joint_solver(memory),
      broken_joints(&memory),
      field_forces(memory),
      fast(&memory),
      continuous(memory)
{
    islands.make_room_for(static_cast<std::size_t>(def.capacity.bodies));
    continuous.make_room_for(static_cast<std::size_t>(def.capacity.bodies));
    fast.reserve(static_cast<std::size_t>(def.capacity.bodies) + 1);
    events.fell_asleep.reserve(static_cast<std::size_t>(def.capacity.bodies));
    events.woke.reserve(static_cast<std::size_t>(def.capacity.bodies));
    bodies.reserve(static_cast<std::size_t>(def.capacity.bodies));
    shapes.reserve(static_cast<std::size_t>(def.capacity.shapes));
    contacts.reserve(static_cast<std::size_t>(def.capacity.contacts));
    pairs.reserve(static_cast<std::size_t>(def.capacity.contacts));
}

} // namespace carom::detail
