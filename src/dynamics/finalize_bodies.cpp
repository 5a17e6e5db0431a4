// The only place where a step writes poses.
#include "dynamics/finalize_bodies.hpp"

#include "dynamics/walks.hpp"
#include "geometry/bounds.hpp"
#include "memory/make_room.hpp"

#include <algorithm>
#include <cmath>

namespace carom::detail
{

namespace
{

/// Squares of larger numbers come near the end of float: a body there is as lost as one at infinity [m], [m/s], [rad/s].
constexpr float end_of_world = 1e15f;

bool is_good(float value) { return std::abs(value) < end_of_world; } // false for NaN
bool is_good(Vec2 v) { return is_good(v.x) && is_good(v.y); }

/// How far a body turned in a step: its rotation tells the angle, its spin how many full turns [rad].
float motion_turn(const BodyMotion& motion, float dt)
{
    // Small turns, which are nearly all, need no arctangent.
    if (motion.dq.c > 0.99f) return motion.dq.s;
    const float turn = angle(motion.dq);
    return turn + 2 * pi * std::round((motion.w * dt - turn) / (2 * pi));
}

bool is_fast(const Sweep& sweep, const BodyWatch& watch, BodyType type, const Tolerances& tolerances)
{
    const float way = distance(sweep.center_start, sweep.center_end) + std::abs(sweep.turn) * watch.outer_radius;
    if (watch.is_bullet && type == BodyType::Dynamic) return way > tolerances.linear_slop;
    return way > fast_way(watch.inner_radius, tolerances);
}

/// New bounds of a fast body's shapes: the fat ones hold all of its way. The broad phase keeps its box while that holds the way too.
void widen_bounds(const Sweep& sweep, std::uint32_t body, const BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase,
                  std::pmr::vector<std::uint32_t>& strayed)
{
    const Transform& transform = bodies.poses[body].transform;
    const bool turns = std::abs(sweep.turn) > 0.1f;
    const float reach = bodies.records[body].outer_radius;
    const Aabb around = merge(Aabb{sweep.center_start, sweep.center_start}, Aabb{sweep.center_end, sweep.center_end});
    for (const std::uint32_t s : shapes_of(bodies, shapes, body))
    {
        ShapeBounds& bounds = shapes.bounds[s];
        const Aabb start = bounds.tight;
        bounds.tight = bounds_of(shapes.geometry[s], transform);
        const Aabb ends = merge(start, bounds.tight);
        const Aabb way =
            expanded(turns ? merge(ends, expanded(around, reach)) : expanded(ends, std::abs(sweep.turn) * std::abs(sweep.turn) * reach),
                     shapes.tolerances.linear_slop);
        const bool has_strayed = !contains(bounds.fat, way);
        bounds.fat = way;
        shapes.mark_moved(s);
        if (!has_strayed) continue;
        broad_phase.update(s, way);
        strayed.push_back(s);
    }
}

void renew_fat_bounds(std::uint32_t shape, Vec2 way, ShapeStore& shapes, BroadPhase& broad_phase)
{
    ShapeBounds& bounds = shapes.bounds[shape];
    bounds.fat = fattened(bounds.tight, way, shapes.tolerances.max_bounds_margin);
    broad_phase.update(shape, bounds.fat);
    shapes.mark_moved(shape);
}

/// The same as refresh_bounds, and tells continuous collision of the shapes that have strayed. Those that leave their fat bounds in the next step keep
/// them for now: the pairs of this step were found with these.
void watch_bounds(const BodyMotion& motion, const BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float dt,
                  FastMotion& fast)
{
    const Transform& transform = bodies.poses[motion.slot].transform;
    const Vec2 next_way = dt * motion.v;
    for (const std::uint32_t s : shapes_of(bodies, shapes, motion.slot))
    {
        ShapeBounds& bounds = shapes.bounds[s];
        bounds.tight = bounds_of(shapes.geometry[s], transform);
        const Aabb around = expanded(bounds.tight, shapes.tolerances.linear_slop); // with what gravity adds in a step
        if (contains(bounds.fat, swept(around, next_way))) continue;
        const bool has_strayed = !contains(bounds.fat, bounds.tight);
        (has_strayed ? fast.strayed_shapes : fast.leaving_shapes).push_back(s);
        if (has_strayed) renew_fat_bounds(s, steps_ahead * next_way, shapes, broad_phase);
    }
}

} // namespace

void refresh_bounds(std::uint32_t body, const BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, Vec2 way)
{
    const Transform& transform = bodies.poses[body].transform;
    for (const std::uint32_t s : shapes_of(bodies, shapes, body))
    {
        ShapeBounds& bounds = shapes.bounds[s];
        bounds.tight = bounds_of(shapes.geometry[s], transform);
        if (!contains(bounds.fat, bounds.tight)) renew_fat_bounds(s, way, shapes, broad_phase);
    }
}

void renew_bounds(std::span<const std::uint32_t> leaving, const BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float dt)
{
    for (const std::uint32_t shape : leaving)
        renew_fat_bounds(shape, steps_ahead * dt * bodies.velocity(shapes.records[shape].body), shapes, broad_phase);
}

namespace
{

/// Where a motion takes a body.
BodyPose pose_after(const BodyPose& pose, const BodyMotion& motion)
{
    const Vec2 center = pose.center + motion.dp;
    const Rot q = normalize(motion.dq * pose.transform.q);
    return {{center - rotate(q, pose.local_center), q}, center, pose.local_center};
}

/// A body that is led arrives where it was to arrive, whatever the substeps have rounded.
BodyPose pose_at_goal(const BodyPose& pose, const BodyRecord& record, float dt)
{
    if (record.goal_dt != dt) return pose;
    return {record.goal, record.goal * pose.local_center, pose.local_center};
}

bool is_sound(const BodyPose& pose, const BodyMotion& motion)
{
    return is_good(pose.center) && is_good(motion.v) && is_good(motion.w) && is_good(Vec2{pose.transform.q.c, pose.transform.q.s});
}

/// Calls accept nothing faster, so a step leaves nothing faster: each state of a world can be made again.
void limit_speed(BodyMotion& motion)
{
    const float fastest = std::max(std::abs(motion.v.x), std::abs(motion.v.y));
    if (fastest > max_speed)
    {
        const Vec2 v = (max_speed / fastest) * motion.v;
        motion.v = {std::clamp(v.x, -max_speed, max_speed), std::clamp(v.y, -max_speed, max_speed)}; // rounding may lead beyond
    }
    motion.w = std::clamp(motion.w, -max_speed, max_speed);
}

/// Whether the body is slow, and has hardly moved since it became so.
bool is_at_rest(BodyWatch& watch, const BodyMotion& motion, const Sweep& sweep, float dt, float sleep_speed)
{
    // Most bodies that move show it in one component already.
    if (std::max(std::abs(motion.v.x), std::abs(motion.v.y)) > sleep_speed) return false;
    const Vec2 displacement = sweep.center_end - sweep.center_start;
    // A body that a joint is still pulling into place comes along without a velocity.
    const float speed = std::max(length(motion.v), length(displacement) / dt);
    if (speed + std::abs(motion.w) * watch.outer_radius > sleep_speed) return false;
    if (watch.rest_time == 0) watch.drift = {}, watch.turn = 0;
    watch.drift += displacement;
    watch.turn += sweep.turn;
    return length(watch.drift) + std::abs(watch.turn) * watch.outer_radius <= rest_drift(watch.outer_radius);
}

} // namespace

void finalize_bodies(BodyStore& bodies, ShapeStore& shapes, BroadPhase& broad_phase, float dt, float sleep_speed,
                     std::pmr::vector<LostBody>& lost, FastMotion* fast)
{
    if (fast) make_room(fast->bodies, bodies.motions.size());
    if (fast)
    {
        make_room(fast->strayed_shapes, shapes.records.size());
        make_room(fast->leaving_shapes, shapes.records.size());
        fast->displacements.resize(bodies.motions.size());
    }
    make_room(lost, bodies.motions.size()); // a pass that stopped half-way would move some bodies twice
    for (std::size_t i = 1; i < bodies.motions.size(); ++i)
    {
        BodyMotion& motion = bodies.motions[i];
        BodyPose& pose = bodies.poses[motion.slot];
        BodyWatch& watch = bodies.watches[i];
        const BodyRecord& record = bodies.records[motion.slot];
        BodyPose next = pose_after(pose, motion);
        if (watch.has_goal) next = pose_at_goal(next, record, dt);
        const Sweep sweep = {pose.local_center, pose.center, next.center, pose.transform.q, motion_turn(motion, dt)};
        motion.dp = {};
        motion.dq = {};
        bodies.drives[i].force = {};
        bodies.drives[i].torque = 0;
        watch.has_goal = false;
        watch.set_back = {};

        const bool has_values = is_sound(next, motion);
        if (!has_values || !is_in_world(next.center) || !is_in_world(next.transform.p))
        {
            motion.v = {};
            motion.w = 0;
            lost.push_back({motion.slot, has_values ? QuarantineReason::LeftWorld : QuarantineReason::NotFinite});
            continue;
        }
        limit_speed(motion);
        pose = next;
        if (watch.is_settling) watch.rest_time = 0;
        watch.is_settling = false;
        const bool rests = is_at_rest(watch, motion, sweep, dt, sleep_speed) && watch.can_sleep && !watch.is_driven;
        watch.rest_time = rests ? watch.rest_time + dt : 0;
        watch.is_driven = false;
        if (fast) fast->displacements[i] = {sweep.center_end - sweep.center_start, sweep.turn};
        if (fast && is_fast(sweep, watch, record.type, shapes.tolerances))
        {
            fast->bodies.push_back({motion.slot, sweep});
            widen_bounds(sweep, motion.slot, bodies, shapes, broad_phase, fast->strayed_shapes);
        }
        else if (fast)
        {
            watch_bounds(motion, bodies, shapes, broad_phase, dt, *fast);
        }
        else
        {
            refresh_bounds(motion.slot, bodies, shapes, broad_phase, steps_ahead * dt * motion.v);
        }
    }
}

} // namespace carom::detail
