// Adds and removes joints and keeps the lists of each body's joints.
#include "dynamics/joint_store.hpp"

#include "dynamics/body_store.hpp"
#include "dynamics/edge_list.hpp"
#include "memory/make_room.hpp"

#include <cmath>

namespace carom::detail
{

std::uint32_t JointStore::create(const Joint& joint, BodyStore& bodies)
{
    make_room(joints, joints.size() + 1);
    make_room(active, joints.size() + 1);
    const std::uint32_t slot = slots.acquire();
    if (slot == joints.size()) joints.emplace_back();
    joints[slot] = joint;
    if (joint.body_a != null_index) link_edge(joints, 2 * slot, bodies.records[joint.body_a].first_joint);
    link_edge(joints, 2 * slot + 1, bodies.records[joint.body_b].first_joint);
    return slot;
}

void JointStore::destroy(std::uint32_t slot, BodyStore& bodies)
{
    const Joint& joint = joints[slot];
    if (joint.body_a != null_index) unlink_edge(joints, 2 * slot, bodies.records[joint.body_a].first_joint);
    unlink_edge(joints, 2 * slot + 1, bodies.records[joint.body_b].first_joint);
    slots.release(slot);
}

void JointStore::shrink()
{
    slots.drop_tail();
    cut(joints, slots.size());
    cut(active, active.size());
    make_room(active, joints.size()); // so that activating never allocates
}

void JointStore::activate(std::uint32_t slot)
{
    joints[slot].place_in_active = static_cast<std::uint32_t>(active.size());
    active.push_back(slot);
    ++revision;
}

void JointStore::set_spec(std::uint32_t slot, const JointSpec& spec)
{
    joints[slot].spec = spec;
    ++revision;
}

void JointStore::deactivate(std::uint32_t slot)
{
    const std::uint32_t place = joints[slot].place_in_active;
    const std::uint32_t last = active.back();
    active[place] = last;
    joints[last].place_in_active = place;
    active.pop_back();
    joints[slot].place_in_active = null_index;
    ++revision;
}

void forget_impulses(Joint& joint)
{
    joint.rigid = {};
    joint.controls = {};
    joint.drive = {};
    joint.force = {};
    joint.torque = 0;
}

Transform world_frame(const BodyStore& bodies, std::uint32_t body, const Transform& frame)
{
    return body == null_index ? frame : bodies.poses[body].transform * frame;
}

float unwrapped(float angle, float near)
{
    const float turns = std::round((near - angle) / (2 * pi));
    return angle + turns * (2 * pi);
}

} // namespace carom::detail
