// The public World: checks its arguments, then hands on.
#include <carom/world.hpp>

#include "api/validate.hpp"
#include "dynamics/ids.hpp"
#include "dynamics/walks.hpp"
#include "edit/chain_edits.hpp"
#include "edit/edits.hpp"
#include "edit/wake.hpp"
#include "geometry/validate.hpp"
#include "memory/make_room.hpp"
#include "solver/isa/dispatch.hpp"
#include "state/guards.hpp"
#include "state/world_state.hpp"
#include "step/step.hpp"

#include <new>

namespace carom
{

using detail::require_body;
using detail::require_idle;
using detail::require_shape;
using detail::WorldState;

namespace
{

/// Marks the world as stepping for as long as it lives, whatever ends the step.
class StepGuard
{
public:
    explicit StepGuard(std::atomic<bool>& is_stepping) : is_stepping_(is_stepping) { is_stepping_.store(true, std::memory_order_relaxed); }
    StepGuard(const StepGuard&) = delete;
    StepGuard& operator=(const StepGuard&) = delete;
    ~StepGuard() { is_stepping_.store(false, std::memory_order_relaxed); }

private:
    std::atomic<bool>& is_stepping_;
};

} // namespace

World::World(const WorldDef& def)
{
    detail::validate(def, "World");
    std::pmr::memory_resource& memory = def.memory ? *def.memory : *std::pmr::get_default_resource();
    std::pmr::polymorphic_allocator<> allocator(&memory);
    state_.reset(allocator.new_object<WorldState>(def, memory));
}

World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::Destroy::operator()(WorldState* state) const
{
    std::pmr::polymorphic_allocator<> allocator(&state->memory.upstream());
    allocator.delete_object(state);
}

WorldState& World::state(std::string_view function) const
{
    if (!state_) [[unlikely]]
        detail::usage_error(function, "world", std::string_view("moved from"), "use the world that it was moved to");
    return *state_;
}

BodyId World::create_body(const BodyDef& def)
{
    WorldState& world = state("create_body");
    require_idle(world, "create_body");
    detail::validate(def, "create_body");
    const std::uint32_t body = detail::create_body(world, def);
    return detail::id_of<BodyId>(world.bodies, body, world.world);
}

BodyId World::create_body(const BodyDef& def, const Geometry& geometry, const ShapeDef& shape)
{
    WorldState& world = state("create_body");
    require_idle(world, "create_body");
    detail::validate(def, "create_body");
    detail::validate(geometry, "create_body", world.shapes.tolerances);
    detail::validate(shape, "create_body");
    detail::validate_density(geometry, shape.density, "create_body");

    const std::uint32_t body = detail::create_body(world, def);
    detail::Rollback without_shape([&] { detail::destroy_body(world, body); });
    detail::create_shape(world, body, geometry, shape);
    without_shape.dismiss();
    // The velocity was given for the centre of mass that the shape has brought.
    world.bodies.set_velocity(body, def.linear_velocity);
    return detail::id_of<BodyId>(world.bodies, body, world.world);
}

void World::destroy_body(BodyId id)
{
    WorldState& world = state("destroy_body");
    require_idle(world, "destroy_body");
    detail::destroy_body(world, require_body(world, id, "destroy_body"));
}

ShapeId World::create_shape(BodyId id, const Geometry& geometry, const ShapeDef& def)
{
    WorldState& world = state("create_shape");
    require_idle(world, "create_shape");
    const std::uint32_t body = require_body(world, id, "create_shape");
    detail::validate(geometry, "create_shape", world.shapes.tolerances);
    detail::validate(def, "create_shape");
    detail::validate_density(geometry, def.density, "create_shape");
    return detail::shape_id(world.shapes, detail::create_shape(world, body, geometry, def), world.world);
}

void World::destroy_shape(ShapeId id)
{
    WorldState& world = state("destroy_shape");
    require_idle(world, "destroy_shape");
    const std::uint32_t shape = require_shape(world, id, "destroy_shape");
    detail::require_no_segment(world, shape, "destroy_shape", "destroy the chain");
    detail::destroy_shape(world, shape);
}

ChainId World::create_chain(BodyId id, const ChainDef& def)
{
    WorldState& world = state("create_chain");
    require_idle(world, "create_chain");
    const std::uint32_t body = require_body(world, id, "create_chain");
    detail::validate(def, "create_chain", world.shapes.tolerances);
    const std::uint32_t chain = detail::create_chain(world, body, def);
    return detail::id_of<ChainId>(world.chains, chain, world.world);
}

void World::destroy_chain(ChainId id)
{
    WorldState& world = state("destroy_chain");
    require_idle(world, "destroy_chain");
    detail::destroy_chain(world, detail::require_chain(world, id, "destroy_chain"));
}

Body World::body(BodyId id)
{
    WorldState& world = state("body");
    require_body(world, id, "body");
    return {world, id};
}

BodyView World::body(BodyId id) const
{
    WorldState& world = state("body");
    require_body(world, id, "body");
    return {world, id};
}

std::optional<Body> World::find_body(BodyId id)
{
    WorldState& world = state("find_body");
    if (id.world != world.world || !world.bodies.slots.is_live(id.index, id.generation)) return std::nullopt;
    return Body(world, id);
}

std::optional<BodyView> World::find_body(BodyId id) const
{
    WorldState& world = state("find_body");
    if (id.world != world.world || !world.bodies.slots.is_live(id.index, id.generation)) return std::nullopt;
    return BodyView(world, id);
}

Shape World::shape(ShapeId id)
{
    WorldState& world = state("shape");
    require_shape(world, id, "shape");
    return {world, id};
}

ShapeView World::shape(ShapeId id) const
{
    WorldState& world = state("shape");
    require_shape(world, id, "shape");
    return {world, id};
}

std::optional<Shape> World::find_shape(ShapeId id)
{
    WorldState& world = state("find_shape");
    if (id.world != world.world || !world.shapes.slots.is_live(id.index, id.generation)) return std::nullopt;
    return Shape(world, id);
}

std::optional<ShapeView> World::find_shape(ShapeId id) const
{
    WorldState& world = state("find_shape");
    if (id.world != world.world || !world.shapes.slots.is_live(id.index, id.generation)) return std::nullopt;
    return ShapeView(world, id);
}

Chain World::chain(ChainId id)
{
    WorldState& world = state("chain");
    detail::require_chain(world, id, "chain");
    return {world, id};
}

ChainView World::chain(ChainId id) const
{
    WorldState& world = state("chain");
    detail::require_chain(world, id, "chain");
    return {world, id};
}

std::optional<Chain> World::find_chain(ChainId id)
{
    WorldState& world = state("find_chain");
    if (id.world != world.world || !world.chains.slots.is_live(id.index, id.generation)) return std::nullopt;
    return Chain(world, id);
}

std::optional<ChainView> World::find_chain(ChainId id) const
{
    WorldState& world = state("find_chain");
    if (id.world != world.world || !world.chains.slots.is_live(id.index, id.generation)) return std::nullopt;
    return ChainView(world, id);
}

std::vector<BodyId> World::bodies() const
{
    const WorldState& world = state("bodies");
    std::vector<BodyId> ids;
    ids.reserve(static_cast<std::size_t>(world.bodies.slots.live_count()));
    for (std::uint32_t slot = 0; slot < world.bodies.slots.size(); ++slot)
        if (world.bodies.slots.is_live(slot)) ids.push_back(detail::id_of<BodyId>(world.bodies, slot, world.world));
    return ids;
}

Vec2 World::gravity() const { return state("gravity").gravity; }

void World::set_gravity(Vec2 gravity)
{
    WorldState& world = state("set_gravity");
    require_idle(world, "set_gravity");
    detail::require_within("set_gravity", "gravity", gravity, detail::max_factor);
    if (world.gravity == gravity) return;
    world.gravity = gravity;
    detail::wake_all(world);
}

FieldId World::add_field(const Field& field)
{
    WorldState& world = state("add_field");
    require_idle(world, "add_field");
    detail::validate(field, "add_field");
    detail::make_room(world.fields.fields, world.fields.fields.size() + 1);
    const std::uint32_t slot = world.fields.slots.acquire();
    detail::wake_all(world);
    if (slot == world.fields.fields.size())
        world.fields.fields.push_back(field);
    else
        world.fields.fields[slot] = field;
    return detail::id_of<FieldId>(world.fields, slot, world.world);
}

void World::set_field(FieldId id, const Field& field)
{
    WorldState& world = state("set_field");
    require_idle(world, "set_field");
    const std::uint32_t slot = detail::require_field(world, id, "set_field");
    detail::validate(field, "set_field");
    if (world.fields.fields[slot] == field) return;
    detail::wake_all(world);
    world.fields.fields[slot] = field;
}

void World::remove_field(FieldId id)
{
    WorldState& world = state("remove_field");
    require_idle(world, "remove_field");
    world.fields.slots.release(detail::require_field(world, id, "remove_field"));
    detail::wake_all(world);
}

Field World::field(FieldId id) const
{
    const WorldState& world = state("field");
    return world.fields.fields[detail::require_field(world, id, "field")];
}

std::vector<FieldId> World::fields() const
{
    const WorldState& world = state("fields");
    std::vector<FieldId> ids;
    for (std::uint32_t slot = 0; slot < world.fields.slots.size(); ++slot)
        if (world.fields.slots.is_live(slot)) ids.push_back(detail::id_of<FieldId>(world.fields, slot, world.world));
    return ids;
}

Vec2 World::gravity_at(Vec2 point) const
{
    const WorldState& world = state("gravity_at");
    detail::require_within("gravity_at", "point", point, max_coordinate);
    return world.gravity + detail::FieldForces::at_point(world.fields, world.bodies, point);
}

StepReport World::step(float dt, int substeps, StepProbe* probe)
{
    WorldState& world = state("step");
    require_idle(world, "step");
    const bool is_good_dt = dt == 0 || (dt >= detail::min_dt && dt <= detail::max_dt); // false for NaN
    if (!is_good_dt) detail::usage_error("step", "dt", dt, "give 0, or a value from 1e-06 to 1");
    detail::require_range("step", "substeps", substeps, 1, 64);
    const StepGuard guard(world.is_stepping);
    world.is_broken = true; // unless the step comes to its end
    const StepReport report = detail::step(world, dt, substeps, probe);
    world.is_broken = false;
    return report;
}

Events World::events() const
{
    const detail::EventBuffers& events = state("events").events;
    return {events.contact_begin,  events.contact_persist, events.contact_end, events.contact_hit, events.sensor_begin,
            events.sensor_persist, events.sensor_end,      events.joint_break, events.fell_asleep, events.woke};
}

Manifold World::manifold(ShapeId a, ShapeId b) const
{
    const WorldState& world = state("manifold");
    const std::uint32_t shape_a = require_shape(world, a, "manifold");
    const std::uint32_t shape_b = require_shape(world, b, "manifold");
    for (const detail::Tie tie : detail::contacts_of(world.bodies, world.contacts, world.shapes.records[shape_a].body))
    {
        const detail::Contact& contact = world.contacts.contacts[tie.slot];
        if (contact.is_sensor) continue;
        const Manifold manifold = detail::public_manifold(world.contacts.manifolds[tie.slot], world.contacts.results[tie.slot]);
        if (contact.shape_a == shape_a && contact.shape_b == shape_b) return manifold;
        if (contact.shape_a == shape_b && contact.shape_b == shape_a)
        {
            Manifold turned = manifold;
            turned.normal = -manifold.normal;
            turned.rolling_impulse = -manifold.rolling_impulse; // on the second shape; those of the points turn with the normal
            return turned;
        }
    }
    return {};
}

BroadPhaseType World::broad_phase() const { return state("broad_phase").broad_phase->type(); }

BroadPhaseOptions World::broad_phase_options() const { return state("broad_phase_options").broad_phase_options; }

void World::set_broad_phase(BroadPhaseType type, const BroadPhaseOptions& options)
{
    WorldState& world = state("set_broad_phase");
    require_idle(world, "set_broad_phase");
    detail::validate(type, options, "set_broad_phase");
    detail::set_broad_phase(world, type, options);
}

Simd World::simd() const { return state("simd").simd; }

void World::set_simd(Simd simd)
{
    WorldState& world = state("set_simd");
    require_idle(world, "set_simd");
    world.simd = detail::chosen_simd(simd, "set_simd");
}

float World::length_unit() const { return state("length_unit").shapes.tolerances.length_unit; }

SolverTuning World::solver_tuning() const { return state("solver_tuning").tuning; }

void World::set_solver_tuning(const SolverTuning& tuning)
{
    WorldState& world = state("set_solver_tuning");
    require_idle(world, "set_solver_tuning");
    detail::validate(tuning, "set_solver_tuning");
    world.tuning = tuning;
}

SleepTuning World::sleep_tuning() const { return state("sleep_tuning").sleep; }

void World::set_sleep_tuning(const SleepTuning& tuning)
{
    WorldState& world = state("set_sleep_tuning");
    require_idle(world, "set_sleep_tuning");
    detail::validate(tuning, "set_sleep_tuning");
    world.sleep = tuning;
    if (!tuning.is_enabled) detail::wake_all(world);
}

void World::wake_all()
{
    WorldState& world = state("wake_all");
    require_idle(world, "wake_all");
    detail::wake_all(world);
}

bool World::is_continuous() const { return state("is_continuous").is_continuous; }

void World::set_continuous(bool continuous)
{
    WorldState& world = state("set_continuous");
    require_idle(world, "set_continuous");
    world.is_continuous = continuous;
}

int World::awake_body_count() const { return static_cast<int>(state("awake_body_count").bodies.motions.size()) - 1; }

MaterialMixing World::mixing() const { return state("mixing").rules.mixing; }

void World::set_mixing(const MaterialMixing& mixing)
{
    WorldState& world = state("set_mixing");
    require_idle(world, "set_mixing");
    detail::validate(mixing, "set_mixing");
    world.rules.mixing = mixing;
    detail::wake_all(world);
    detail::mix_all_again(world);
}

float World::hit_speed() const { return state("hit_speed").rules.hit_speed; }

void World::set_hit_speed(float speed)
{
    WorldState& world = state("set_hit_speed");
    require_idle(world, "set_hit_speed");
    detail::validate_hit_speed(speed, "set_hit_speed");
    world.rules.hit_speed = speed;
}

int World::max_pairs() const { return state("max_pairs").rules.max_pairs; }

void World::set_max_pairs(int count)
{
    WorldState& world = state("set_max_pairs");
    require_idle(world, "set_max_pairs");
    detail::validate_max_pairs(count, "set_max_pairs");
    world.rules.max_pairs = count;
}

ContactHooks* World::hooks() const { return state("hooks").rules.hooks; }

void World::set_hooks(ContactHooks* hooks)
{
    WorldState& world = state("set_hooks");
    require_idle(world, "set_hooks");
    world.rules.hooks = hooks;
    detail::mix_all_again(world);
}

void World::shrink()
{
    WorldState& world = state("shrink");
    require_idle(world, "shrink");
    world.is_broken = true; // unless it comes to its end
    detail::shrink(world);
    world.is_broken = false;
}

int World::body_count() const { return state("body_count").bodies.slots.live_count(); }

int World::shape_count() const { return state("shape_count").shapes.slots.live_count(); }

MemoryReport World::memory() const { return detail::memory_report(state("memory")); }

std::uint64_t World::step_count() const { return state("step_count").step_count; }

} // namespace carom
