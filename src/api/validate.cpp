// The ranges of everything that a caller may set, and what to do instead.
#include "api/validate.hpp"
#include "solver/isa/dispatch.hpp"

#include "geometry/mass.hpp"
#include "geometry/validate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace carom::detail
{

namespace
{

/// Largest mass [kg] and inertia [kg m^2] that the solver computes with safely.
constexpr float max_mass = 1e20f;
constexpr float min_mass = 1e-12f;

/// False for NaN. The names of fields are put together only when this is false.
bool is_in_range(const Material& m)
{
    return m.friction >= 0 && m.friction <= max_factor && m.restitution >= 0 && m.restitution <= 1 && m.rolling_resistance >= 0 &&
           m.rolling_resistance <= max_factor && std::abs(m.tangent_speed) <= max_speed;
}

template <class Tag>
std::uint32_t require_id(const SlotPool& slots, Id<Tag> id, std::uint32_t world, std::string_view function, std::string_view what)
{
    if (id.world == world && slots.is_live(id.index, id.generation)) [[likely]]
        return id.index;
    const std::string value = "{index " + std::to_string(id.index) + ", generation " + std::to_string(id.generation) + ", world " +
                              std::to_string(id.world) + "}";
    if (!id) usage_error(function, what, std::string_view("null"), "give an id that create returned");
    if (id.world != world) usage_error(function, what, value, "give an id of this world");
    if (!slots.was_live(id.index, id.generation))
        usage_error(function, what, value, "it does not exist yet in this world; give an id that create returned");
    usage_error(function, what, value, "it was destroyed; ask with find before using an old id");
}

} // namespace

std::uint32_t require_body(const WorldState& world, BodyId id, std::string_view function, std::string_view field)
{
    return require_id(world.bodies.slots, id, world.world, function, field);
}

std::uint32_t require_shape(const WorldState& world, ShapeId id, std::string_view function)
{
    return require_id(world.shapes.slots, id, world.world, function, "shape");
}

std::uint32_t require_joint(const WorldState& world, JointId id, std::string_view function)
{
    return require_id(world.joints.slots, id, world.world, function, "joint");
}

std::uint32_t require_chain(const WorldState& world, ChainId id, std::string_view function)
{
    return require_id(world.chains.slots, id, world.world, function, "chain");
}

std::uint32_t require_field(const WorldState& world, FieldId id, std::string_view function)
{
    return require_id(world.fields.slots, id, world.world, function, "field");
}

void validate(const WorldDef& def, std::string_view function)
{
    require_within(function, "gravity", def.gravity, max_factor);
    require_range(function, "length_unit", def.length_unit, min_length_unit, max_length_unit);
    validate(def.solver, function);
    validate(def.sleep, function);
    validate(def.mixing, function);
    validate_hit_speed(def.hit_speed, function);
    validate_max_pairs(def.max_pairs, function);
    validate(def.broad_phase, def.broad_phase_options, function);
    chosen_simd(def.simd, function);
    constexpr int most = 1 << 24;
    require_range(function, "capacity.bodies", def.capacity.bodies, 0, most);
    require_range(function, "capacity.shapes", def.capacity.shapes, 0, most);
    require_range(function, "capacity.contacts", def.capacity.contacts, 0, most);
}

void validate(const SolverTuning& tuning, std::string_view function)
{
    require_range(function, "solver.contact_hertz", tuning.contact_hertz, 0.01f, max_factor);
    require_range(function, "solver.contact_damping_ratio", tuning.contact_damping_ratio, 0, max_factor);
    require_range(function, "solver.push_out_speed", tuning.push_out_speed, 0.0001f, max_factor);
    require_range(function, "solver.restitution_threshold", tuning.restitution_threshold, 0, max_factor);
    require_range(function, "solver.joint_hertz", tuning.joint_hertz, 0.01f, max_factor);
    require_range(function, "solver.joint_damping_ratio", tuning.joint_damping_ratio, 0, max_factor);
}

void validate(const SleepTuning& tuning, std::string_view function)
{
    require_range(function, "sleep.speed", tuning.speed, 0, max_factor);
    require_range(function, "sleep.time", tuning.time, 0, max_factor);
}

void validate(BroadPhaseType type, const BroadPhaseOptions& options, std::string_view function)
{
    const int index = static_cast<int>(type);
    if (index < 0 || index > static_cast<int>(BroadPhaseType::Tree)) usage_error(function, "broad_phase", index, "give a BroadPhaseType");
    require_range(function, "broad_phase_options.quadtree_max_depth", options.quadtree_max_depth, 0, 10);
    require_range(function, "broad_phase_options.quadtree_node_capacity", options.quadtree_node_capacity, 1, 1 << 20);
}

void validate_position(Vec2 position, float angle, std::string_view function)
{
    require_within(function, "position", position, max_coordinate);
    require_finite(function, "angle", angle);
}

void validate_type(BodyType type, std::string_view function)
{
    const int index = static_cast<int>(type);
    if (index < 0 || index > static_cast<int>(BodyType::Dynamic)) usage_error(function, "type", index, "give a BodyType");
}

void validate_velocity(BodyType type, Vec2 velocity, std::string_view function)
{
    require_within(function, "linear_velocity", velocity, max_speed);
    if (type == BodyType::Static && velocity != Vec2{})
        usage_error(function, "linear_velocity", velocity, "a static body does not move; make it kinematic");
}

void validate_spin(BodyType type, float spin, std::string_view function)
{
    require_range(function, "angular_velocity", spin, -max_speed, max_speed);
    if (type == BodyType::Static && spin != 0)
        usage_error(function, "angular_velocity", spin, "a static body does not move; make it kinematic");
}

void validate(const BodyDef& def, std::string_view function)
{
    validate_type(def.type, function);
    validate_position(def.position, def.angle, function);
    validate_velocity(def.type, def.linear_velocity, function);
    validate_spin(def.type, def.angular_velocity, function);
    require_range(function, "linear_damping", def.linear_damping, 0, max_factor);
    require_range(function, "angular_damping", def.angular_damping, 0, max_factor);
    require_range(function, "gravity_scale", def.gravity_scale, -max_factor, max_factor);
}

void validate(const Material& material, std::string_view function, std::string_view prefix)
{
    if (is_in_range(material)) return;
    const auto require = [&](std::string_view name, float value, float min, float max)
    { require_range(function, std::string(prefix).append(name), value, min, max); };
    require("friction", material.friction, 0, max_factor);
    require("restitution", material.restitution, 0, 1);
    require("rolling_resistance", material.rolling_resistance, 0, max_factor);
    require("tangent_speed", material.tangent_speed, -max_speed, max_speed);
}

void validate(const MaterialMixing& mixing, std::string_view function)
{
    const auto require_mix = [&](std::string_view field, Mix rule)
    {
        const int index = static_cast<int>(rule);
        if (index < 0 || index > static_cast<int>(Mix::Product)) usage_error(function, field, index, "give a Mix");
    };
    require_mix("mixing.friction", mixing.friction);
    require_mix("mixing.restitution", mixing.restitution);
}

void validate_max_pairs(int count, std::string_view function) { require_range(function, "max_pairs", count, 0, 1 << 30); }

void validate_hit_speed(float speed, std::string_view function) { require_range(function, "hit_speed", speed, 0, max_speed); }

void validate(const ChainDef& def, std::string_view function, const Tolerances& tolerances)
{
    constexpr std::size_t most_points = 1000000;
    const std::size_t count = def.points.size();
    require_range(function, "points.size", static_cast<std::int64_t>(std::min(count, most_points + 1)), def.is_loop ? 3 : 2, most_points);
    const int sides = static_cast<int>(def.sides);
    if (sides < 0 || sides > static_cast<int>(ChainSides::OneSided)) usage_error(function, "sides", sides, "give a ChainSides");

    const auto name_of = [](std::string_view array, std::size_t i) { return std::string(array) + "[" + std::to_string(i) + "]"; };
    for (std::size_t i = 0; i < count; ++i)
    {
        const Vec2 point = def.points[i];
        const bool is_within = std::abs(point.x) <= max_coordinate && std::abs(point.y) <= max_coordinate; // false for NaN
        if (!is_within) require_within(function, name_of("points", i), point, max_coordinate);
    }
    const std::size_t segments = def.is_loop ? count : count - 1;
    for (std::size_t i = 0; i < segments; ++i)
    {
        const std::size_t next = i + 1 < count ? i + 1 : 0;
        if (distance(def.points[i], def.points[next]) >= 0.999f * tolerances.min_edge_length) continue;
        usage_error(function, name_of("points", next), def.points[next],
                    "give neighbours that are at least " + least_size_text(tolerances.min_edge_length, tolerances) + " apart");
    }
    if (def.materials.size() > 1 && def.materials.size() != segments)
        usage_error(function, "materials.size", def.materials.size(), "give none, one, or one for each segment");
    for (std::size_t i = 0; i < def.materials.size(); ++i)
    {
        if (!is_in_range(def.materials[i])) validate(def.materials[i], function, name_of("materials", i) + ".");
    }
}

void validate(const ShapeDef& def, std::string_view function)
{
    require_not_negative(function, "density", def.density);
    validate(def.material, function);
}

void validate_density(const Geometry& geometry, float density, std::string_view function)
{
    require_not_negative(function, "density", density);
    const MassData mass = mass_from(geometry, density);
    const bool is_massless = density == 0 || std::holds_alternative<Segment>(geometry);
    const bool is_good = mass.mass >= min_mass && mass.mass <= max_mass && mass.inertia > 0 && mass.inertia <= max_mass;
    if (!is_massless && !is_good)
        usage_error(function, "density", density,
                    "give a density for which the mass is from 1e-12 to 1e20 kg, and the inertia at most 1e20 kg m^2");
}

void validate_mass(const MassData& data, BodyType type, std::string_view function)
{
    require_within(function, "center", data.center, max_coordinate);
    const bool is_dynamic = type == BodyType::Dynamic;
    require_range(function, "mass", data.mass, is_dynamic ? min_mass : 0, max_mass);
    require_range(function, "inertia", data.inertia, is_dynamic ? min_mass * min_mass : 0, max_mass);
}

void validate(const Field& field, std::string_view function)
{
    if (field.valueless_by_exception()) usage_error(function, "field", std::string_view("empty"), "give a field");
    if (const auto* uniform = std::get_if<UniformField>(&field))
        require_within(function, "acceleration", uniform->acceleration, max_factor);
    if (const auto* point = std::get_if<PointField>(&field))
    {
        require_within(function, "center", point->center, max_coordinate);
        require_range(function, "strength", point->strength, -max_mass, max_mass);
        require_range(function, "softening", point->softening, 0, max_coordinate);
    }
    if (const auto* n_body = std::get_if<NBodyField>(&field))
    {
        require_range(function, "gravitational_constant", n_body->gravitational_constant, -max_mass, max_mass);
        require_range(function, "softening", n_body->softening, 0, max_coordinate);
        require_range(function, "opening_angle", n_body->opening_angle, 0, 1.5f);
        const int method = static_cast<int>(n_body->method);
        if (method < 0 || method > static_cast<int>(NBodyMethod::BarnesHut)) usage_error(function, "method", method, "give an NBodyMethod");
        const int sources = static_cast<int>(n_body->sources);
        if (sources < 0 || sources > static_cast<int>(NBodySources::All)) usage_error(function, "sources", sources, "give an NBodySources");
    }
}

} // namespace carom::detail
