// Gathers targets and sources from the bodies and adds field by field.
#include "fields/field_store.hpp"

namespace carom::detail
{
namespace
{

int count_n_body(const FieldStore& fields)
{
    int count = 0;
    for (std::uint32_t slot = 0; slot < fields.slots.size(); ++slot)
        count += fields.slots.is_live(slot) && std::holds_alternative<NBodyField>(fields.fields[slot]);
    return count;
}

} // namespace

FieldForces::FieldForces(std::pmr::memory_resource& memory)
    : targets_(&memory),
      acceleration_(&memory),
      source_slots_(&memory),
      source_positions_(&memory),
      source_masses_(&memory),
      n_body_(memory)
{
}

/// Finds the bodies that pull, and their masses.
void FieldForces::list_sources(NBodySources which, const BodyStore& bodies)
{
    source_slots_.clear();
    source_masses_.clear();
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot)
    {
        const BodyRecord& body = bodies.records[slot];
        const bool is_source = which == NBodySources::All || body.is_attractor;
        if (!bodies.slots.is_live(slot) || !body.is_enabled || !is_source || bodies.gravity_mass(slot) <= 0) continue;
        source_slots_.push_back(slot);
        source_masses_.push_back(bodies.gravity_mass(slot));
    }
}

/// Finds where they are now.
void FieldForces::place_sources(const BodyStore& bodies)
{
    source_positions_.clear();
    for (const std::uint32_t slot : source_slots_)
        source_positions_.push_back(bodies.poses[slot].center + bodies.motions[bodies.motion_index[slot]].dp);
}

std::span<const Vec2> FieldForces::at_bodies(const FieldStore& fields, const BodyStore& bodies, const PullPasses& passes, bool is_new_step)
{
    if (fields.slots.live_count() == 0) return {};

    targets_.clear();
    for (const BodyMotion& motion : bodies.motions)
        targets_.push_back(motion.slot == null_index ? Vec2{} : bodies.poses[motion.slot].center + motion.dp);
    acceleration_.assign(targets_.size(), Vec2{});
    const std::span<const Vec2> targets = std::span(targets_).subspan(1);
    const std::span<Vec2> acceleration = std::span(acceleration_).subspan(1);

    const bool has_one_n_body = count_n_body(fields) == 1; // whose sources are still those of the last call
    for (std::uint32_t slot = 0; slot < fields.slots.size(); ++slot)
    {
        if (!fields.slots.is_live(slot)) continue;
        const Field& field = fields.fields[slot];
        if (const auto* uniform = std::get_if<UniformField>(&field))
            for (Vec2& a : acceleration) a += uniform->acceleration;
        if (const auto* point = std::get_if<PointField>(&field)) add_point_field(*point, targets, acceleration);
        if (const auto* n_body = std::get_if<NBodyField>(&field))
        {
            const bool are_as_before = !is_new_step && has_one_n_body;
            if (!are_as_before) list_sources(n_body->sources, bodies);
            place_sources(bodies);
            n_body_.add(*n_body, {source_positions_, source_masses_}, targets, acceleration, passes, are_as_before);
        }
    }
    return acceleration_;
}

Vec2 FieldForces::at_point(const FieldStore& fields, const BodyStore& bodies, Vec2 point)
{
    FieldForces forces(*std::pmr::get_default_resource());
    Vec2 total;
    for (std::uint32_t slot = 0; slot < fields.slots.size(); ++slot)
    {
        if (!fields.slots.is_live(slot)) continue;
        const Field& field = fields.fields[slot];
        if (const auto* uniform = std::get_if<UniformField>(&field)) total += uniform->acceleration;
        if (const auto* center = std::get_if<PointField>(&field)) add_point_field(*center, {&point, 1}, {&total, 1});
        if (const auto* n_body = std::get_if<NBodyField>(&field))
        {
            NBodyField exact = *n_body;
            exact.method = NBodyMethod::Direct;
            forces.list_sources(exact.sources, bodies);
            forces.place_sources(bodies);
            forces.n_body_.add(exact, {forces.source_positions_, forces.source_masses_}, {&point, 1}, {&total, 1}, four_lane_pull_passes());
        }
    }
    return total;
}

} // namespace carom::detail
