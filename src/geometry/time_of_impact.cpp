// Conservative advancement of second order. From a time at which the shapes are apart, the separation along an axis is followed into the
// future by its value, its slope and a bound K on its curvature:
//
//     s(t + h) >= s + h s' - K h^2 / 2   for each pair of corners,
//
// and time advances by the largest h for which no pair can come nearer than the target. Since value and slope are exact, the steps close in
// on the impact as Newton's do, but never from behind. The axis may turn along with either body, or not at all; whichever takes the largest
// step is used: an axis that turns with a long plank does not see its far end swing.
// @source B. Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems", 1996, chapter 2, for the bound of first order
#include "geometry/time_of_impact.hpp"

#include "geometry/vec2d.hpp"

#include <algorithm>
#include <cmath>

namespace carom::detail
{

namespace
{

/// The random motions of the tests, up to 1000 m/s and half a turn in a step, need 1 to 3 steps on average and 15 at most.
constexpr int max_steps = 48;

/// The steps have closed in when they are this short.
constexpr double least_step = 1e-7;

Rot turned(const Sweep& sweep, double time) { return rotation(static_cast<float>(time * double{sweep.turn})) * sweep.q_start; }

/// The corners of a shape as arms of the centre of mass.
struct Arms
{
    std::array<Vec2d, max_polygon_vertices> arms; ///< in the body's frame [m]
    int count = 0;
    double longest = 0; ///< [m]
};

Arms arms_of(const ConvexPoints& shape, Vec2 center)
{
    Arms result;
    result.count = shape.count;
    for (int i = 0; i < shape.count; ++i)
    {
        const auto place = static_cast<std::size_t>(i);
        result.arms[place] = Vec2d(shape.points[place]) - Vec2d(center);
        result.longest = std::max(result.longest, length(result.arms[place]));
    }
    return result;
}

/// The pair in motion, seen from A's centre of mass, which keeps numbers small wherever in the world they are.
struct Pair
{
    const ConvexPoints& a;
    const ConvexPoints& b;
    const Sweep& sweep_a;
    const Sweep& sweep_b;
    Arms arms_a;
    Arms arms_b;
    Vec2d offset_start; ///< from A's centre to B's, at time 0 [m]
    Vec2d velocity;     ///< of B's centre relative to A's [m]
    double w_a;         ///< [rad]
    double w_b;

    Vec2d offset(double time) const { return offset_start + time * velocity; }
};

/// The corners along an axis at some time.
struct Corner
{
    double at;    ///< along the axis [m]
    double slope; ///< its rate [m]
};

struct Projection
{
    std::array<Corner, max_polygon_vertices> corners;
    int count = 0;
};

/// @param w      spin of the shape relative to the axis [rad]
/// @param offset of the centre along the axis, and its rate
Projection project(const Arms& arms, Rot q, Vec2d axis, double w, Corner offset)
{
    Projection result;
    result.count = arms.count;
    for (int i = 0; i < arms.count; ++i)
    {
        const auto place = static_cast<std::size_t>(i);
        const Vec2d arm = rotated(q, arms.arms[place]);
        result.corners[place] = {offset.at + dot(axis, arm), offset.slope + w * dot(axis, cross(1.0, arm))};
    }
    return result;
}

/// The largest h up to `horizon` with s + h s' - K h^2 / 2 >= 0 from 0 to h, for s >= 0.
double safe_step(double s, double slope, double curvature, double horizon)
{
    if (s + horizon * (slope - 0.5 * curvature * horizon) >= 0) return horizon; // concave: then it is so in between as well
    const double root = std::sqrt(slope * slope + 2 * curvature * s);
    return slope < 0 ? 2 * s / (root - slope) : (slope + root) / curvature;
}

/// How the separation along an axis develops.
struct Outlook
{
    double separation = 0; ///< less the target [m]
    double step = 0;       ///< for which it surely stays positive
};

/// @param w_axis spin of the axis [rad]
/// @param excess of the separation of the cores that is not to be used up: target and radii [m]
Outlook look_ahead(const Pair& pair, double time, Rot q_a, Rot q_b, Vec2d axis, double w_axis, double excess)
{
    const double horizon = 1 - time;
    const Vec2d u = pair.offset(time);
    const double w_a = pair.w_a - w_axis;
    const double w_b = pair.w_b - w_axis;
    // d/dt of n . u is n . (v - w_axis x u), and so on: with the axis, everything else seems to turn back.
    const Corner center_b = {dot(axis, u), dot(axis, pair.velocity - cross(w_axis, u))};
    const Projection on_a = project(pair.arms_a, q_a, axis, w_a, {0, 0});
    const Projection on_b = project(pair.arms_b, q_b, axis, w_b, center_b);

    const double farthest = std::max(length(u), length(pair.offset(1)));
    const double curvature = w_axis * w_axis * farthest + 2 * std::abs(w_axis) * length(pair.velocity) + w_a * w_a * pair.arms_a.longest +
                             w_b * w_b * pair.arms_b.longest;
    Outlook outlook = {1e300, horizon};
    for (std::size_t j = 0; j < static_cast<std::size_t>(on_b.count); ++j)
    {
        for (std::size_t i = 0; i < static_cast<std::size_t>(on_a.count); ++i)
        {
            const double s = on_b.corners[j].at - on_a.corners[i].at - excess;
            outlook.separation = std::min(outlook.separation, s);
            if (!(s > 0)) return {s, 0};
            outlook.step = safe_step(s, on_b.corners[j].slope - on_a.corners[i].slope, curvature, outlook.step);
        }
    }
    return outlook;
}

/// From A to B at some time, or (0, 0) when their cores overlap.
Vec2d normal_at(const Pair& pair, double time, Rot q_a, Rot q_b)
{
    // In A's frame, whose origin is moved so that both are near it.
    const Vec2d arm_a = rotated(q_a, Vec2d(pair.sweep_a.local_center));
    const Vec2d arm_b = rotated(q_b, Vec2d(pair.sweep_b.local_center));
    const Vec2d origins = pair.offset(time) + arm_a - arm_b;
    const DistanceResult nearest = distance(pair.a, pair.b, {to_float(rotated(inverse(q_a), origins)), relative(q_a, q_b)});
    return rotated(q_a, Vec2d(nearest.normal));
}

/// The best of the axes that stand still, turn with A, and turn with B.
Outlook best_outlook(const Pair& pair, double time, double excess)
{
    const Rot q_a = turned(pair.sweep_a, time);
    const Rot q_b = turned(pair.sweep_b, time);
    const Vec2d axis = normal_at(pair, time, q_a, q_b);
    if (dot(axis, axis) == 0) return {-excess, 0};

    Outlook best = look_ahead(pair, time, q_a, q_b, axis, 0, excess);
    if (!(best.separation > 0)) return best;
    for (const double w : {pair.w_a, pair.w_b})
    {
        if (w == 0 || best.step >= 1 - time) continue;
        best.step = std::max(best.step, look_ahead(pair, time, q_a, q_b, axis, w, excess).step);
    }
    return best;
}

} // namespace

Transform Sweep::at(float time) const
{
    const Rot q = turned(*this, double{time});
    return {lerp(center_start, center_end, time) - rotate(q, local_center), q};
}

std::optional<float> time_of_impact(const ConvexPoints& a, const Sweep& sweep_a, const ConvexPoints& b, const Sweep& sweep_b,
                                    float target_distance, const Tolerances& tolerances)
{
    const Vec2d way_a = Vec2d(sweep_a.center_end) - Vec2d(sweep_a.center_start);
    const Vec2d way_b = Vec2d(sweep_b.center_end) - Vec2d(sweep_b.center_start);
    const Pair pair = {.a = a,
                       .b = b,
                       .sweep_a = sweep_a,
                       .sweep_b = sweep_b,
                       .arms_a = arms_of(a, sweep_a.local_center),
                       .arms_b = arms_of(b, sweep_b.local_center),
                       .offset_start = Vec2d(sweep_b.center_start) - Vec2d(sweep_a.center_start),
                       .velocity = way_b - way_a,
                       .w_a = double{sweep_a.turn},
                       .w_b = double{sweep_b.turn}};
    const double excess = double{target_distance} + double{a.radius} + double{b.radius};

    double time = 0;
    double before = 1e300;
    for (int i = 0; i < max_steps; ++i)
    {
        const Outlook outlook = best_outlook(pair, time, excess);
        if (!(outlook.separation > 0)) break;
        if (outlook.step >= 1 - time) return std::nullopt;
        // Near the target and coming nearer, or unable to tell: that is the impact.
        const bool is_near = outlook.separation <= double{tolerances.impact_tolerance};
        if (is_near && (outlook.separation < before || outlook.step < least_step) && time > 0) break;
        if (is_near && outlook.step < least_step) break;
        before = outlook.separation;
        time += outlook.step;
    }
    return std::nextafter(static_cast<float>(time), 0.0f); // the conversion may have rounded up
}

} // namespace carom::detail
