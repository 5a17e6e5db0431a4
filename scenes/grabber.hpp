// Drags bodies with the pointer, by a mouse joint.
#pragma once

#include "scenes/draw_list.hpp"
#include "scenes/scene.hpp"

#include <carom/carom.hpp>

#include <optional>

namespace carom::scenes
{

/// The left button takes hold of the dynamic body under the pointer, moving drags it, and letting go drops it.
class Grabber
{
public:
    /// @return whether the event was for the grabber: it took, moved or dropped a body
    bool on_pointer(World& world, const PointerEvent& event);
    void draw(const World& world, DrawList& list) const;
    bool holds(const World& world) const { return world.find_joint(joint_).has_value(); }

private:
    JointId joint_;
};

} // namespace carom::scenes
