// Keeps the dense arrays of active bodies in step with the records.
#include "dynamics/body_store.hpp"

#include "memory/make_room.hpp"

#include <utility>

namespace carom::detail
{

BodyStore::BodyStore(std::pmr::memory_resource& memory)
    : slots(memory),
      records(&memory),
      poses(&memory),
      motion_index(&memory),
      motions(&memory),
      masses(&memory),
      drives(&memory),
      watches(&memory)
{
    motions.emplace_back();
    masses.emplace_back();
    drives.emplace_back();
    watches.emplace_back();
}

void BodyStore::reserve(std::size_t count)
{
    slots.reserve(count);
    records.reserve(count);
    poses.reserve(count);
    motion_index.reserve(count);
    motions.reserve(count + 1);
    masses.reserve(count + 1);
    drives.reserve(count + 1);
    watches.reserve(count + 1);
}

void BodyStore::make_room()
{
    const std::size_t count = records.size() + 1;
    detail::make_room(motions, count);
    detail::make_room(masses, count);
    detail::make_room(drives, count);
    detail::make_room(watches, count);
}

void BodyStore::shrink()
{
    slots.drop_tail();
    for (std::uint32_t slot = 0; slot < slots.size(); ++slot)
        if (!slots.is_live(slot)) records[slot] = BodyRecord(records.get_allocator().resource()); // its name may be long
    cut(records, slots.size());
    cut(poses, slots.size());
    cut(motion_index, slots.size());
    cut(motions, motions.size());
    cut(masses, masses.size());
    cut(drives, drives.size());
    cut(watches, watches.size());
    make_room();
}

void BodyStore::make_room_for_one()
{
    const std::size_t count = records.size() + 1;
    detail::make_room(records, count);
    detail::make_room(poses, count);
    detail::make_room(motion_index, count);
    // As if every body were active: activating one never allocates.
    detail::make_room(motions, count + 1);
    detail::make_room(masses, count + 1);
    detail::make_room(drives, count + 1);
    detail::make_room(watches, count + 1);
}

std::uint32_t BodyStore::create(const BodyDef& def)
{
    std::pmr::memory_resource* memory = records.get_allocator().resource();
    std::pmr::string name(def.name, memory); // copied before the records grow: it may be another body's name
    make_room_for_one();
    const std::uint32_t slot = slots.acquire();
    if (slot == records.size())
    {
        records.emplace_back();
        poses.emplace_back();
        motion_index.push_back(0);
    }

    BodyRecord& record = records[slot];
    record = BodyRecord(memory);
    record.type = def.type;
    record.is_enabled = def.is_enabled;
    record.is_attractor = def.is_attractor;
    record.can_sleep = def.can_sleep;
    record.is_bullet = def.is_bullet;
    record.locks = def.locks;
    record.linear_damping = def.linear_damping;
    record.angular_damping = def.angular_damping;
    record.gravity_scale = def.gravity_scale;
    record.user_data = def.user_data;
    record.name = std::move(name);

    poses[slot] = {.transform = {def.position, rotation(def.angle)}, .center = def.position, .local_center = {}};
    refresh_mass(slot);
    set_velocity(slot, def.linear_velocity);
    set_spin(slot, def.angular_velocity);
    return slot;
}

void BodyStore::destroy(std::uint32_t slot)
{
    if (is_active(slot)) deactivate(slot);
    slots.release(slot);
}

void BodyStore::activate(std::uint32_t slot)
{
    const BodyRecord& record = records[slot];
    motion_index[slot] = static_cast<std::uint32_t>(motions.size());
    motions.push_back({.v = record.saved_v, .w = record.saved_w, .dp = {}, .dq = {}, .slot = slot});
    masses.emplace_back();
    drives.emplace_back();
    watches.emplace_back();
}

void BodyStore::deactivate(std::uint32_t slot)
{
    ++revision;
    const std::uint32_t index = motion_index[slot];
    records[slot].saved_v = motions[index].v;
    records[slot].saved_w = motions[index].w;

    const std::uint32_t last = static_cast<std::uint32_t>(motions.size() - 1);
    motions[index] = motions[last];
    masses[index] = masses[last];
    drives[index] = drives[last];
    watches[index] = watches[last];
    motion_index[motions[index].slot] = index;
    motions.pop_back();
    masses.pop_back();
    drives.pop_back();
    watches.pop_back();
    motion_index[slot] = 0;
}

void BodyStore::refresh(std::uint32_t slot)
{
    ++revision;
    BodyRecord& record = records[slot];
    const bool should_be_active = record.is_enabled && record.type != BodyType::Static && !record.is_asleep;
    if (should_be_active && !is_active(slot)) activate(slot);
    if (!should_be_active && is_active(slot)) deactivate(slot);
    if (record.type == BodyType::Static)
    {
        record.saved_v = {};
        record.saved_w = 0;
    }
    if (!should_be_active) return;

    const std::uint32_t index = motion_index[slot];
    BodyMass& mass = masses[index];
    BodyDrive& drive = drives[index];
    mass = {};
    drive.gravity_scale = {};
    drive.linear_damping = record.linear_damping;
    drive.angular_damping = record.angular_damping;
    BodyWatch& watch = watches[index];
    watch.island = record.island;
    watch.inner_radius = record.inner_radius;
    watch.outer_radius = record.outer_radius;
    watch.can_sleep = record.can_sleep;
    watch.is_bullet = record.is_bullet;
    if (record.type == BodyType::Kinematic)
    {
        drive.force = {};
        drive.torque = 0;
        drive.linear_damping = 0;
        drive.angular_damping = 0;
        return;
    }

    const float inv_mass = 1 / record.mass.mass;
    const Vec2 free_axes = {record.locks.x ? 0.0f : 1.0f, record.locks.y ? 0.0f : 1.0f};
    const bool can_turn = !record.locks.rotation && record.mass.inertia > 0;
    mass.inv_mass = inv_mass * free_axes;
    mass.inv_inertia = can_turn ? 1 / record.mass.inertia : 0.0f;
    drive.gravity_scale = record.gravity_scale * free_axes;
    motions[index].v = {motions[index].v.x * free_axes.x, motions[index].v.y * free_axes.y};
    if (record.locks.rotation) motions[index].w = 0;
}

void BodyStore::set_velocity(std::uint32_t slot, Vec2 v)
{
    const BodyRecord& record = records[slot];
    if (record.type == BodyType::Dynamic) v = {record.locks.x ? 0.0f : v.x, record.locks.y ? 0.0f : v.y};
    (is_active(slot) ? motions[motion_index[slot]].v : records[slot].saved_v) = v;
    forget_plans(slot);
}

void BodyStore::set_spin(std::uint32_t slot, float w)
{
    if (records[slot].type == BodyType::Dynamic && records[slot].locks.rotation) w = 0;
    (is_active(slot) ? motions[motion_index[slot]].w : records[slot].saved_w) = w;
    forget_plans(slot);
}

void BodyStore::forget_plans(std::uint32_t slot)
{
    if (!is_active(slot)) return; // it has no watch
    BodyWatch& watch = watches[motion_index[slot]];
    watch.has_goal = false;
    watch.set_back = {};
}

void BodyStore::set_goal(std::uint32_t slot, const Transform& goal, float dt)
{
    if (!is_active(slot)) return;
    records[slot].goal = goal;
    records[slot].goal_dt = dt;
    watches[motion_index[slot]].has_goal = true;
}

void BodyStore::push(std::uint32_t slot, Vec2 impulse, float angular_impulse)
{
    BodyMotion& motion = motions[motion_index[slot]];
    const BodyMass& mass = masses[motion_index[slot]];
    motion.v += {mass.inv_mass.x * impulse.x, mass.inv_mass.y * impulse.y};
    motion.w += mass.inv_inertia * angular_impulse;
}

void BodyStore::set_transform(std::uint32_t slot, const Transform& transform)
{
    poses[slot].transform = transform;
    poses[slot].center = transform * poses[slot].local_center;
    forget_plans(slot);
}

/// As finalize_bodies will do it.
BodyPose BodyStore::pose_now(std::uint32_t slot) const
{
    BodyPose pose = poses[slot];
    const BodyMotion& motion = motions[motion_index[slot]];
    if (motion.dp == Vec2{} && motion.dq == Rot{}) return pose;
    pose.center += motion.dp;
    pose.transform.q = normalize(motion.dq * pose.transform.q);
    pose.transform.p = pose.center - rotate(pose.transform.q, pose.local_center);
    return pose;
}

MassData combined(const MassData& a, const MassData& b)
{
    const float mass = a.mass + b.mass;
    if (mass <= 0) return {};
    const float share = b.mass / mass;
    // Steiner: both inertias move to the common centre.
    const float reduced_mass = a.mass * share;
    return {.mass = mass,
            .center = a.center + share * (b.center - a.center),
            .inertia = a.inertia + b.inertia + reduced_mass * length_squared(b.center - a.center)};
}

float BodyStore::gravity_mass(std::uint32_t slot) const
{
    const BodyRecord& record = records[slot];
    if (record.has_mass_override) return record.mass_override.mass;
    return record.type == BodyType::Dynamic ? record.mass.mass : record.shapes_mass.mass;
}

void BodyStore::refresh_mass(std::uint32_t slot)
{
    BodyRecord& record = records[slot];
    if (record.has_mass_override)
        record.mass = record.mass_override;
    else if (record.type != BodyType::Dynamic)
        record.mass = {};
    else if (record.shapes_mass.mass > 0)
        record.mass = record.shapes_mass;
    else
        record.mass = {.mass = 1, .center = {}, .inertia = 0};

    // The velocity is that of the centre of mass: moving the centre within a spinning body changes it.
    BodyPose& pose = poses[slot];
    const Vec2 old_center = pose.center;
    pose.local_center = record.mass.center;
    pose.center = pose.transform * pose.local_center;
    set_velocity(slot, velocity(slot) + cross(spin(slot), pose.center - old_center));
    refresh(slot);
}

} // namespace carom::detail
