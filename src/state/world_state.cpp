// Builds an empty world on the user's memory.
#include "state/world_state.hpp"
#include "solver/isa/dispatch.hpp"

#include "memory/make_room.hpp"

#include <array>
#include <span>

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

std::size_t room(int hint) { return static_cast<std::size_t>(hint); }

constexpr std::size_t first_arena = 4096; // [bytes]; it learns how much a step needs

std::span<const char* const> category_names()
{
    static const std::array names = []
    {
        std::array<const char*, memory_category_count> all = {};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = name_of(static_cast<MemoryCategory>(i)).data(); // literals
        return all;
    }();
    return names;
}

} // namespace

WorldState::WorldState(const WorldDef& def, std::pmr::memory_resource& upstream)
    : memory(category_names(), &upstream),
      world(next_world_number()),
      gravity(def.gravity),
      tuning(def.solver),
      sleep(def.sleep),
      is_continuous(def.continuous),
      has_stage_times(def.stage_times),
      simd(chosen_simd(def.simd, "World")),
      rules{.world = world, .mixing = def.mixing, .hooks = def.hooks, .hit_speed = def.hit_speed, .max_pairs = def.max_pairs},
      broad_phase_options(def.broad_phase_options),
      fields(memory_for(MemoryCategory::World)),
      bodies(memory_for(MemoryCategory::Bodies)),
      shapes(memory_for(MemoryCategory::Shapes)),
      chains(memory_for(MemoryCategory::Shapes)),
      contacts(memory_for(MemoryCategory::Contacts)),
      joints(memory_for(MemoryCategory::Joints)),
      islands(memory_for(MemoryCategory::Islands)),
      pairs(memory_for(MemoryCategory::Contacts)),
      broad_phase(make_broad_phase(def.broad_phase, def.broad_phase_options, memory_for(MemoryCategory::BroadPhase))),
      events(memory_for(MemoryCategory::Events)),
      quarantined(&memory_for(MemoryCategory::Events)),
      quarantine_reasons(&memory_for(MemoryCategory::Events)),
      joint_solver(memory_for(MemoryCategory::Solver)),
      field_forces(memory_for(MemoryCategory::Solver)),
      arena(first_arena, &memory_for(MemoryCategory::Scratch))
{
    shapes.tolerances = {.length_unit = def.length_unit};
    const std::size_t body_count = room(def.capacity.bodies);
    const std::size_t shape_count = room(def.capacity.shapes);
    const std::size_t contact_count = room(def.capacity.contacts);
    islands.make_room_for(body_count);
    events.fell_asleep.reserve(body_count);
    events.woke.reserve(body_count);
    bodies.reserve(body_count);
    shapes.reserve(shape_count);
    broad_phase->reserve(shape_count);
    contacts.reserve(contact_count);
    make_room_for_contacts(*this);
    if (body_count + contact_count > 0) arena.reserve(128 * body_count + 64 * contact_count);
    events.arena.reserve(128 * contact_count);
}

void make_room_for_contacts(WorldState& world)
{
    const std::size_t wanted = world.contacts.contacts.size() + world.contacts.contacts.size() / 4;
    if (wanted > world.contacts.contacts.capacity()) world.contacts.reserve(wanted + wanted / 2);
    const std::size_t capacity = world.contacts.contacts.capacity();
    world.pairs.reserve(capacity);
    make_room(world.events.pending_contact_end, capacity);
    make_room(world.events.pending_sensor_end, capacity);
}

MemoryReport memory_report(const WorldState& world)
{
    // The world's object lies in the resource itself, beside what it counts.
    const auto with_world = [](MemoryStats stats)
    {
        stats.bytes += sizeof(WorldState);
        stats.peak_bytes += sizeof(WorldState);
        stats.total_bytes += sizeof(WorldState);
        ++stats.blocks;
        ++stats.allocations;
        return stats;
    };
    MemoryReport report;
    report.total = with_world(world.memory.stats());
    for (std::size_t i = 0; i < report.categories.size(); ++i) report.categories[i] = world.memory.stats(i);
    MemoryStats& own = report.categories[static_cast<std::size_t>(MemoryCategory::World)];
    own = with_world(own);
    return report;
}

} // namespace carom::detail
