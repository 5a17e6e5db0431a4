// Gathers targets and sources from the bodies and adds field by field.
#include "fields/field_store.hpp"

namespace carom::detail
{

FieldForces::FieldForces(std::pmr::memory_resource& memory)
    : targets_(&memory),
      acceleration_(&memory),
      source_positions_(&memory),
      source_masses_(&memory),
      n_body_(memory)
{
}

void FieldForces::gather_sources(NBodySources which, const BodyStore& bodies)
{
    source_positions_.clear();
    source_masses_.clear();
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot)
    {
        const BodyRecord& body = bodies.records[slot];
        const bool is_source = which == NBodySources::All || body.is_attractor;
        if (!bodies.slots.is_live(slot) || !body.is_enabled || !is_source || bodies.gravity_mass(slot) <= 0) continue;
        const Vec2 way = bodies.motions[bodies.motion_index[slot]].dp;
        source_positions_.push_back(bodies.poses[slot].center + way);
        source_masses_.push_back(bodies.gravity_mass(slot));
    }
}

std::span<const Vec2> FieldForces::at_bodies(const FieldStore& fields, const BodyStore& bodies)
{
    if (fields.slots.live_count() == 0) return {};

    targets_.clear();
    for (const BodyMotion& motion : bodies.motions)
        targets_.push_back(motion.slot == null_index ? Vec2{} : bodies.poses[motion.slot].center + motion.dp);
    acceleration_.assign(targets_.size(), Vec2{});
    const std::span<const Vec2> targets = std::span(targets_).subspan(1);
    const std::span<Vec2> acceleration = std::span(acceleration_).subspan(1);

    for (std::uint32_t slot = 0; slot < fields.slots.size(); ++slot)
    {
        if (!fields.slots.is_live(slot)) continue;
        const Field& field = fields.fields[slot];
        if (const auto* uniform = std::get_if<UniformField>(&field))
            for (Vec2& a : acceleration) a += uniform->acceleration;
        if (const auto* point = std::get_if<PointField>(&field)) add_point_field(*point, targets, acceleration);
        if (const auto* n_body = std::get_if<NBodyField>(&field))
        {
            gather_sources(n_body->sources, bodies);
            n_body_.add(*n_body, {source_positions_, source_masses_}, targets, acceleration);
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
            forces.gather_sources(exact.sources, bodies);
            forces.n_body_.add(exact, {forces.source_positions_, forces.source_masses_}, {&point, 1}, {&total, 1});
        }
    }
    return total;
}

} // namespace carom::detail
