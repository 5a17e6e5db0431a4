// Joints of Box2D 2.4.
#pragma once

#include "lab/peers/box2d2/engine.hpp"

namespace carom::lab::box2d2
{

/// @param spec of the type that the joint was made as, perhaps changed since
b2Joint* create_joint(b2World& world, const FileJoint& made_as, const JointSpec& spec, b2Body& a, b2Body& b);

/// Changes a joint in place where the engine can. False: it has to be made anew.
bool change_joint(b2Joint& joint, const SetJoint& set);

/// What the engine lacks of this joint; empty when it has it all.
std::string lacks(const JointSpec& spec);
void add_differences(std::vector<std::string>& list, const JointSpec& spec);

} // namespace carom::lab::box2d2
