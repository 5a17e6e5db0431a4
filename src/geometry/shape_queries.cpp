// Distance and time of impact between two shapes that belong to no world.
#include "geometry/time_of_impact.hpp"
#include "geometry/validate.hpp"
#include "math/usage_error.hpp"

#include <carom/queries.hpp>

#include <string>

namespace carom
{

namespace
{

/// More makes the time too early to be of use [rad].
constexpr float most_turn = 1000;

void validate_motion(const ShapeMotion& motion, std::string_view name)
{
    constexpr std::string_view function = "time_of_impact";
    const std::string prefix(name);
    detail::validate(motion.start, function, prefix + ".start");
    detail::require_within(function, prefix + ".sweep", motion.sweep, 2 * max_coordinate);
    detail::require_range(function, prefix + ".turn", motion.turn, -most_turn, most_turn);
    detail::require_within(function, prefix + ".center", motion.center, max_coordinate);
}

detail::Sweep sweep_of(const ShapeMotion& motion)
{
    const Vec2 center = motion.start * motion.center;
    return {.local_center = motion.center,
            .center_start = center,
            .center_end = center + motion.sweep,
            .q_start = normalize(motion.start.q),
            .turn = motion.turn};
}

} // namespace

ShapeDistance distance(const Geometry& a, const Transform& transform_a, const Geometry& b, const Transform& transform_b)
{
    detail::validate(a, "distance", detail::any_world);
    detail::validate(b, "distance", detail::any_world);
    detail::validate(transform_a, "distance", "transform_a");
    detail::validate(transform_b, "distance", "transform_b");
    const detail::DistanceResult result =
        detail::distance(detail::convex_points(a), detail::convex_points(b), relative(transform_a, transform_b));
    return {result.distance, transform_a * result.point_a, transform_a * result.point_b, rotate(transform_a.q, result.normal)};
}

std::optional<float> time_of_impact(const Geometry& a, const ShapeMotion& motion_a, const Geometry& b, const ShapeMotion& motion_b,
                                    float target_distance, float length_unit)
{
    const detail::Tolerances tolerances = detail::tolerances_for(length_unit, "time_of_impact");
    detail::validate(a, "time_of_impact", detail::any_world);
    detail::validate(b, "time_of_impact", detail::any_world);
    validate_motion(motion_a, "motion_a");
    validate_motion(motion_b, "motion_b");
    detail::require_range("time_of_impact", "target_distance", target_distance, 1e-4f * length_unit, max_coordinate);
    return detail::time_of_impact(detail::convex_points(a), sweep_of(motion_a), detail::convex_points(b), sweep_of(motion_b),
                                  target_distance, tolerances);
}

} // namespace carom
