// Adds and removes joints and keeps the lists of each body's joints.
#include "dynamics/joint_store.hpp"

#include "dynamics/body_store.hpp"
#include "memory/make_room.hpp"

#include <cmath>

namespace carom::detail
{

std::uint32_t JointStore::create(const Joint& joint, BodyStore& bodies)
{
    make_room(joints, joints.size() + 1);
    const std::uint32_t slot = slots.acquire();
    if (slot == joints.size()) joints.emplace_back();
    joints[slot] = joint;
    link(2 * slot, joint.body_a, bodies);
    link(2 * slot + 1, joint.body_b, bodies);
    return slot;
}

void JointStore::destroy(std::uint32_t slot, BodyStore& bodies)
{
    unlink(2 * slot, joints[slot].body_a, bodies);
    unlink(2 * slot + 1, joints[slot].body_b, bodies);
    slots.release(slot);
}

void JointStore::link(std::uint32_t edge, std::uint32_t body, BodyStore& bodies)
{
    if (body == null_index) return;
    std::uint32_t& first = bodies.records[body].first_joint;
    joints[edge / 2].previous[edge % 2] = null_index;
    joints[edge / 2].next[edge % 2] = first;
    if (first != null_index) joints[first / 2].previous[first % 2] = edge;
    first = edge;
}

void JointStore::unlink(std::uint32_t edge, std::uint32_t body, BodyStore& bodies)
{
    if (body == null_index) return;
    const std::uint32_t previous = joints[edge / 2].previous[edge % 2];
    const std::uint32_t next = joints[edge / 2].next[edge % 2];
    if (previous != null_index)
        joints[previous / 2].next[previous % 2] = next;
    else
        bodies.records[body].first_joint = next;
    if (next != null_index) joints[next / 2].previous[next % 2] = previous;
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
