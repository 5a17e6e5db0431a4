// Sensors that were crossed within a step.
#include "solver/continuous/continuous.hpp"

#include "geometry/extent.hpp"
#include "geometry/manifold.hpp"

#include <algorithm>

namespace carom::detail
{

void ContinuousCollision::find_crossings(const BodyStore& bodies, const ShapeStore& shapes)
{
    const Tolerances& tolerances = shapes.tolerances;
    for (const Pair& pair : sensor_pairs_)
    {
        const Geometry& a = shapes.geometry[pair.shape_a];
        const Geometry& b = shapes.geometry[pair.shape_b];
        const BodyPose& pose_b = bodies.poses[shapes.records[pair.shape_b].body];
        const Transform start_b = pair.mover_b == null_index ? pose_b.transform : movers_[pair.mover_b].whole_way.at(0);
        const BodyPose& pose_a = bodies.poses[shapes.records[pair.shape_a].body];
        const Transform start_a = movers_[pair.mover_a].whole_way.at(0);
        const bool starts_in = overlap(a, b, relative(start_a, start_b), tolerances);
        if (starts_in || overlap(a, b, relative(pose_a.transform, pose_b.transform), tolerances)) continue;

        const auto whole_way = [](const BodyPose& pose, const Transform& start)
        { return Sweep{pose.local_center, start * pose.local_center, pose.center, start.q, angle(relative(start.q, pose.transform.q))}; };
        const Sweep way_a = whole_way(pose_a, start_a);
        const Sweep way_b = whole_way(pose_b, start_b);
        const float touch = tolerances.crossing_distance;
        const std::optional<float> time = time_of_impact(convex_points(a), way_a, convex_points(b), way_b, touch, tolerances);
        if (!time) continue;
        // From just outside, it goes through when its core does.
        const bool is_through = *time > 0 || time_of_impact(core_of(a, sliding_share * shapes.extents[pair.shape_a].inner), way_a,
                                                            convex_points(b), way_b, touch, tolerances);
        if (is_through) crossings_.push_back({std::min(pair.shape_a, pair.shape_b), std::max(pair.shape_a, pair.shape_b)});
    }
    std::sort(crossings_.begin(), crossings_.end());
    crossings_.erase(std::unique(crossings_.begin(), crossings_.end()), crossings_.end()); // one that was carried was looked at twice
}

} // namespace carom::detail
