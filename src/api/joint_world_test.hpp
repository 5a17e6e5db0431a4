// What the tests of joints share: a world with two boxes, and a joint of every type.
#pragma once

#include "math/expect_refused_test.hpp"
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace carom::joint_tests
{

inline const std::vector<JointSpec> all_specs = {RevoluteJoint{}, PrismaticJoint{}, DistanceJoint{}, WeldJoint{},  WheelJoint{},
                                                 MotorJoint{},    MouseJoint{},     GearJoint{},     PulleyJoint{}};

class JointTest : public testing::Test
{
protected:
    World world{{.gravity = {0, -10}}};
    BodyId a = world.create_body({.position = {0, 0}}, box(1, 1));
    BodyId b = world.create_body({.position = {2, 0}}, box(1, 1));

    void step(int count)
    {
        for (int i = 0; i < count; ++i) world.step(dt);
    }

    /// A definition that suits a spec.
    JointDef def_for(const JointSpec& spec) { return {.body_a = std::holds_alternative<MouseJoint>(spec) ? BodyId{} : a, .body_b = b}; }

    /// And the world is what it was.
    template <class Call>
    void expect_refused(const std::string& function, const std::string& field, Call&& call)
    {
        const std::uint64_t before = world.hash();
        carom::expect_refused(function, field, call);
        EXPECT_EQ(world.hash(), before);
    }

    void expect_bad_spec(const JointSpec& spec, const std::string& field)
    {
        expect_refused("create_joint", field, [&] { world.create_joint(def_for(spec), spec); });
        const JointSpec good = all_specs[spec.index()];
        const JointId joint = world.create_joint(def_for(good), good);
        expect_refused("set_spec", field, [&] { world.joint(joint).set_spec(spec); });
        world.destroy_joint(joint);
    }
};

} // namespace carom::joint_tests
