// Checks of what callers give: everything is looked at before anything is changed.
#pragma once

#include "math/usage_error.hpp"
#include "state/world_state.hpp"

#include <carom/world.hpp>

#include <string_view>

namespace carom::detail
{

/// Rates and factors beyond this are surely a mistake, and near it float still computes well.
inline constexpr float max_factor = 1e6f;
/// The shortest and the longest step that takes time [s].
inline constexpr float min_dt = 1e-6f;
inline constexpr float max_dt = 1;

// Each throws UsageError in the name of the public function `function`.
/// @param field the argument that the id came in
std::uint32_t require_body(const WorldState& world, BodyId id, std::string_view function, std::string_view field = "body");
std::uint32_t require_shape(const WorldState& world, ShapeId id, std::string_view function);
std::uint32_t require_joint(const WorldState& world, JointId id, std::string_view function);
std::uint32_t require_chain(const WorldState& world, ChainId id, std::string_view function);
std::uint32_t require_field(const WorldState& world, FieldId id, std::string_view function);

void validate(const WorldDef& def, std::string_view function);
void validate(const BodyDef& def, std::string_view function);
void validate(const ShapeDef& def, std::string_view function);
/// @param prefix of the fields' names
void validate(const Material& material, std::string_view function, std::string_view prefix = "material.");
void validate(const ChainDef& def, std::string_view function, const Tolerances& tolerances);
void validate(const MaterialMixing& mixing, std::string_view function);
void validate_max_pairs(int count, std::string_view function);
void validate_hit_speed(float speed, std::string_view function);
void validate(const Field& field, std::string_view function);
void validate(const SleepTuning& tuning, std::string_view function);
void validate(const SolverTuning& tuning, std::string_view function);
void validate(const WorldState& world, const JointDef& def, std::string_view function);
void validate(const JointSpec& spec, std::string_view function, const Tolerances& tolerances);
/// Whether a joint of this type can have the world as its body A.
void validate_ends(const JointDef& def, const JointSpec& spec, std::string_view function);
void validate_frame(const Transform& frame, std::string_view field, std::string_view function);
void validate_break_limit(float limit, std::string_view field, std::string_view function);
void validate(BroadPhaseType type, const BroadPhaseOptions& options, std::string_view function);
void validate_position(Vec2 position, float angle, std::string_view function);
void validate_type(BodyType type, std::string_view function);
/// Finite, not negative, and light enough that the mass of the shape can be computed with.
void validate_density(const Geometry& geometry, float density, std::string_view function);
void validate_mass(const MassData& data, BodyType type, std::string_view function);
void validate_velocity(BodyType type, Vec2 velocity, std::string_view function);
void validate_spin(BodyType type, float spin, std::string_view function);

} // namespace carom::detail
