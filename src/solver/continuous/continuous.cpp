// Continuous collision from the fast bodies of a step to the places where they end.
#include "solver/continuous/continuous.hpp"

#include "dynamics/walks.hpp"
#include "geometry/bounds.hpp"

namespace carom::detail
{

namespace
{

/// The way of a body that is not fast, told by its velocity at the end: what rides on a lift does not run into it.
Sweep slow_way(const BodyStore& bodies, std::uint32_t body, float dt)
{
    const BodyPose& pose = bodies.poses[body];
    const float turn = dt * bodies.spin(body);
    return {pose.local_center, pose.center - dt * bodies.velocity(body), pose.center, rotation(-turn) * pose.transform.q, turn};
}

} // namespace

ContinuousCollision::ContinuousCollision(std::pmr::memory_resource& scratch)
    : movers_(&scratch),
      mover_of_body_(&scratch),
      ways_(&scratch),
      way_of_shape_(&scratch),
      candidates_(&scratch),
      late_pairs_(&scratch),
      sensor_pairs_(&scratch),
      impacts_(&scratch),
      changed_(&scratch),
      near_(&scratch),
      refusals_(&scratch),
      crossings_(&scratch)
{
}

void ContinuousCollision::run(const FastMotion& fast, BodyStore& bodies, ShapeStore& shapes, const JointStore& joints,
                              const ContactStore& contacts, const ContactRules& rules, BroadPhase& broad_phase, float dt)
{
    if (fast.bodies.empty()) return;
    const Surroundings near = {bodies, shapes, joints, contacts, rules, fast.displacements, dt};
    add_movers(fast.bodies, near);
    find_candidates(fast.strayed_shapes, near, broad_phase);
    judge_candidates(near);
    resolve_impacts(near, broad_phase);
    place_bodies(bodies, shapes, broad_phase, dt);
    find_crossings(bodies, shapes);
}

void ContinuousCollision::add_movers(std::span<const FastBody> fast, const Surroundings& near)
{
    const ShapeStore& shapes = near.shapes;
    movers_.reserve(fast.size());
    ways_.reserve(fast.size());
    mover_of_body_.resize(near.bodies.records.size(), null_index);
    way_of_shape_.resize(shapes.records.size(), null_index);
    for (const FastBody& body : fast)
    {
        const BodyRecord& record = near.bodies.records[body.body];
        const auto mover = static_cast<std::uint32_t>(movers_.size());
        mover_of_body_[body.body] = mover;
        const bool is_held = record.first_joint != null_index;
        const bool can_stop = record.type == BodyType::Dynamic;
        has_carriers_ = has_carriers_ || is_held || !can_stop;
        movers_.push_back({.body = body.body,
                           .whole_way = body.sweep,
                           .sweep = body.sweep,
                           .can_stop = can_stop,
                           .is_held = is_held,
                           .is_bullet = record.is_bullet,
                           .is_fast = true});
        for (const std::uint32_t s : shapes_of(near.bodies, near.shapes, body.body))
        {
            way_of_shape_[s] = static_cast<std::uint32_t>(ways_.size());
            ways_.push_back({.path = path_of(shapes.extents[s], body.sweep),
                             .bounds = shapes.bounds[s].fat,
                             .least_way = record.is_bullet ? 0 : fast_way(shapes.extents[s].inner, shapes.tolerances),
                             .shape = s,
                             .mover = mover,
                             .is_sensor = shapes.records[s].is_sensor});
        }
    }
}

/// The mover of a body, made if it was slow so far.
std::uint32_t ContinuousCollision::mover_of(std::uint32_t body, PairKey made_for, const Surroundings& near)
{
    std::uint32_t& mover = mover_of_body_[body];
    if (mover != null_index) return mover;
    mover = static_cast<std::uint32_t>(movers_.size());
    const Sweep sweep = slow_way(near.bodies, body, near.dt);
    const BodyRecord& record = near.bodies.records[body];
    movers_.push_back({.body = body,
                       .whole_way = sweep,
                       .sweep = sweep,
                       .can_stop = true,
                       .is_held = record.first_joint != null_index,
                       .is_bullet = record.is_bullet,
                       .is_fast = false,
                       .made_for = made_for});
    return mover;
}

void ContinuousCollision::place_bodies(BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float dt)
{
    for (const Mover& mover : movers_)
    {
        bool has_moved = false;
        if (mover.version > 0)
        {
            // At the ends of float a way has no middle: then the body stays where the step took it.
            const Transform end = mover.sweep.at(1);
            // One that was carried may have come out of the world: then too.
            has_moved = is_in_world(end.p) && is_in_world(mover.sweep.center_end) && is_finite(Vec2{end.q.c, end.q.s});
            if (has_moved)
            {
                BodyPose& pose = bodies.poses[mover.body];
                bodies.watches[bodies.motion_index[mover.body]].set_back = pose.center - mover.sweep.center_end;
                pose.transform = end;
                pose.transform.q = normalize(pose.transform.q);
                pose.center = mover.sweep.center_end;
            }
        }
        const Vec2 ahead = dt * bodies.velocity(mover.body);
        for (const std::uint32_t s : shapes_of(bodies, shapes, mover.body))
        {
            ShapeBounds& bounds = shapes.bounds[s];
            if (has_moved) bounds.tight = bounds_of(shapes.geometry[s], bodies.poses[mover.body].transform);
            bounds.fat = fattened(bounds.tight, ahead, shapes.tolerances.max_bounds_margin);
            broad_phase.update(s, bounds.fat);
            shapes.mark_moved(s);
        }
    }
}

} // namespace carom::detail
