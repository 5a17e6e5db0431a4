// Joints through the public API: what can be read, and what is refused.
#include "api/joint_world_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace carom::joint_tests
{

TEST_F(JointTest, ReadsWhatItWasMadeOf)
{
    JointDef def{.body_a = a,
                 .body_b = b,
                 .frame_a = {{1, 2}, rotation(0.3f)},
                 .frame_b = {{-1, 0}, rotation(-0.2f)},
                 .collide_connected = true,
                 .break_force = 1000,
                 .break_torque = 200,
                 .user_data = 77};
    const JointId id = world.create_joint(def, RevoluteJoint{.limit = Range{-1, 2}});
    const JointView joint = std::as_const(world).joint(id);
    EXPECT_EQ(joint.id(), id);
    EXPECT_EQ(joint.type(), JointType::Revolute);
    EXPECT_EQ(std::get<RevoluteJoint>(joint.spec()).limit, (Range{-1, 2}));
    EXPECT_EQ(joint.body_a(), a);
    EXPECT_EQ(joint.body_b(), b);
    EXPECT_EQ(joint.frame_a().p, (Vec2{1, 2}));
    EXPECT_EQ(joint.frame_b().q, rotation(-0.2f));
    EXPECT_TRUE(joint.collide_connected());
    EXPECT_EQ(joint.break_force(), 1000);
    EXPECT_EQ(joint.break_torque(), 200);
    EXPECT_EQ(joint.user_data(), 77u);
    EXPECT_EQ(joint.force(), Vec2{});
    EXPECT_EQ(joint.torque(), 0);
    EXPECT_NEAR(joint.angle(), -0.5f, 1e-6);
    EXPECT_NEAR(joint.error(), length(Vec2{1, 0} - Vec2{1, 2}), 1e-6);
}

TEST_F(JointTest, EveryTypeCanBeMadeReadAndStepped)
{
    for (const JointSpec& spec : all_specs)
    {
        const JointId id = world.create_joint(def_for(spec), spec);
        EXPECT_EQ(world.joint(id).type(), static_cast<JointType>(spec.index()));
        EXPECT_EQ(world.joint(id).spec().index(), spec.index());
        step(5);
        EXPECT_TRUE(is_finite(world.joint(id).force()));
        EXPECT_TRUE(std::isfinite(world.joint(id).torque()) && std::isfinite(world.joint(id).error()));
        EXPECT_TRUE(std::isfinite(world.joint(id).angle()) && is_finite(world.joint(id).offset()));
        world.destroy_joint(id);
    }
}

TEST_F(JointTest, AngleAndOffsetFollowTheBodies)
{
    const JointId id = world.create_joint(world.joint_at(a, b, {1, 0}, pi / 2), PrismaticJoint{});
    EXPECT_NEAR(world.joint(id).angle(), 0, 1e-6);
    EXPECT_NEAR(length(world.joint(id).offset()), 0, 1e-6);
    world.body(b).set_transform({2, 0.5f}, 0.25f);
    EXPECT_NEAR(world.joint(id).angle(), 0.25f, 1e-6);
    // The axis points up; B's point went along with its turn.
    const Vec2 point = Vec2{2, 0.5f} + rotate(rotation(0.25f), Vec2{-1, 0}) - Vec2{1, 0};
    EXPECT_NEAR(world.joint(id).offset().x, point.y, 1e-6);
    EXPECT_NEAR(world.joint(id).offset().y, -point.x, 1e-6);
}

TEST_F(JointTest, FramesFromPlacesInTheWorld)
{
    world.body(b).set_transform({2, 0}, 1);
    const JointDef at = world.joint_at(a, b, {1, 1}, 0.5f);
    EXPECT_EQ(at.body_a, a);
    EXPECT_NEAR(distance(world.body(a).transform() * at.frame_a.p, Vec2{1, 1}), 0, 1e-6);
    EXPECT_NEAR(distance(world.body(b).transform() * at.frame_b.p, Vec2{1, 1}), 0, 1e-6);
    EXPECT_NEAR(angle(world.body(b).transform().q * at.frame_b.q), 0.5f, 1e-6);
    const JointDef between = world.joint_between({}, b, {0, 5}, {2, 0});
    EXPECT_EQ(between.body_a, BodyId{});
    EXPECT_EQ(between.frame_a.p, (Vec2{0, 5}));
    EXPECT_NEAR(angle(between.frame_a.q), std::atan2(-5.0f, 2.0f), 1e-6);
    EXPECT_EQ(world.joint_between({}, b, {1, 1}, {1, 1}).frame_a.q, Rot{}) << "no direction";
}

TEST_F(JointTest, ListsJoints)
{
    const JointId first = world.create_joint(world.joint_at(a, b, {1, 0}), RevoluteJoint{});
    const JointId second = world.create_joint(world.joint_at({}, b, {2, 0}), RevoluteJoint{});
    EXPECT_EQ(world.joints(), (std::vector<JointId>{first, second}));
    EXPECT_EQ(world.joints_of(a), (std::vector<JointId>{first}));
    EXPECT_EQ(world.joints_of(b), (std::vector<JointId>{first, second}));
    EXPECT_EQ(world.joint_count(), 2);
    world.destroy_joint(first);
    EXPECT_EQ(world.joints_of(b), (std::vector<JointId>{second}));
    EXPECT_TRUE(world.joints_of(a).empty());
    EXPECT_EQ(world.joint_count(), 1);
}

TEST_F(JointTest, StaleIdsAreDetected)
{
    const JointId id = world.create_joint(world.joint_at(a, b, {1, 0}), RevoluteJoint{});
    Joint view = world.joint(id);
    EXPECT_TRUE(world.find_joint(id));
    EXPECT_TRUE(std::as_const(world).find_joint(id));
    World other;
    EXPECT_FALSE(other.find_joint(id));
    world.destroy_joint(id);
    const JointId next = world.create_joint(world.joint_at(a, b, {1, 0}), RevoluteJoint{});
    EXPECT_EQ(next.index, id.index);
    EXPECT_FALSE(world.find_joint(id));
    EXPECT_FALSE(world.find_joint({}));
    EXPECT_THROW(world.joint(id), UsageError);
    EXPECT_THROW(world.destroy_joint(id), UsageError);
    EXPECT_THROW(view.type(), UsageError);
    EXPECT_THROW(view.spec(), UsageError);
    EXPECT_THROW(view.force(), UsageError);
    EXPECT_THROW(view.error(), UsageError);
    EXPECT_THROW(view.set_spec(RevoluteJoint{}), UsageError);
    EXPECT_THROW(view.set_frames({}, {}), UsageError);
    EXPECT_THROW(view.set_collide_connected(true), UsageError);
    EXPECT_THROW(view.set_break_limits(1, 1), UsageError);
    EXPECT_THROW(view.set_user_data(1), UsageError);
    EXPECT_EQ(world.joint_count(), 1);
}

// ---- what is refused ----

TEST_F(JointTest, RefusesBadDefinitions)
{
    const auto refused = [&](const std::string& field, const JointDef& def, const JointSpec& spec = RevoluteJoint{})
    { expect_refused("create_joint", field, [&] { world.create_joint(def, spec); }); };
    const BodyId gone = world.create_body({});
    world.destroy_body(gone);
    refused("body_a", {.body_a = gone, .body_b = b});
    refused("body_b", {.body_a = a, .body_b = gone});
    refused("body_b", {.body_a = a});
    refused("body_b", {.body_a = a, .body_b = a});
    refused("frame_a.p.x", {.body_a = a, .body_b = b, .frame_a = {{nan, 0}, {}}});
    refused("frame_b.p.y", {.body_a = a, .body_b = b, .frame_b = {{0, inf}, {}}});
    refused("frame_a.q", {.body_a = a, .body_b = b, .frame_a = {{}, {2, 0}}});
    refused("frame_b.q", {.body_a = a, .body_b = b, .frame_b = {{}, {nan, 0}}});
    refused("break_force", {.body_a = a, .body_b = b, .break_force = 0});
    refused("break_force", {.body_a = a, .body_b = b, .break_force = nan});
    refused("break_torque", {.body_a = a, .body_b = b, .break_torque = -1});
    refused("body_a", {.body_a = a, .body_b = b}, MouseJoint{});
    refused("body_a", {.body_b = b}, GearJoint{});
    refused("body_a", {.body_b = b}, PulleyJoint{});
    expect_refused("joint_at", "point.x", [&] { world.joint_at(a, b, {nan, 0}); });
    expect_refused("joint_at", "axis", [&] { world.joint_at(a, b, {}, inf); });
    expect_refused("joint_between", "point_b.y", [&] { world.joint_between(a, b, {}, {0, nan}); });
    expect_refused("destroy_joint", "joint", [&] { world.destroy_joint({}); });
    expect_refused("joint_at", "b", [&] { world.joint_at(a, gone, {}); });
    expect_refused("joint_between", "a", [&] { world.joint_between(gone, b, {}, {}); });
    expect_refused("joints_of", "body", [&] { world.joints_of(gone); });
}

TEST_F(JointTest, RefusesBadSpecs)
{
    const Spring spring{.hertz = -1};
    expect_bad_spec(RevoluteJoint{.limit = Range{1, -1}}, "limit.lower");
    expect_bad_spec(RevoluteJoint{.limit = Range{nan, 1}}, "limit.lower");
    expect_bad_spec(RevoluteJoint{.limit = Range{0, inf}}, "limit.upper");
    expect_bad_spec(RevoluteJoint{.motor = Motor{nan, 1}}, "motor.speed");
    expect_bad_spec(RevoluteJoint{.motor = Motor{1, -1}}, "motor.max_force");
    expect_bad_spec(RevoluteJoint{.spring = spring}, "spring.hertz");
    expect_bad_spec(PrismaticJoint{.limit = Range{2, 1}}, "limit.lower");
    expect_bad_spec(PrismaticJoint{.motor = Motor{1, inf}}, "motor.max_force");
    expect_bad_spec(PrismaticJoint{.spring = Spring{1, -0.1f}}, "spring.damping_ratio");
    expect_bad_spec(DistanceJoint{.length = 0}, "length");
    expect_bad_spec(DistanceJoint{.length = nan}, "length");
    expect_bad_spec(DistanceJoint{.limit = Range{-1, 1}}, "limit.lower");
    expect_bad_spec(DistanceJoint{.spring = Spring{2e4f, 1}}, "spring.hertz");
    expect_bad_spec(WeldJoint{.linear = spring}, "spring.hertz");
    expect_bad_spec(WeldJoint{.angular = Spring{1, nan}}, "spring.damping_ratio");
    expect_bad_spec(WheelJoint{.suspension = Spring{1, 1, nan}}, "spring.target");
    expect_bad_spec(WheelJoint{.limit = Range{3, 2}}, "limit.lower");
    expect_bad_spec(WheelJoint{.motor = Motor{inf, 1}}, "motor.speed");
    expect_bad_spec(MotorJoint{.offset = {nan, 0}}, "offset.x");
    expect_bad_spec(MotorJoint{.angle = 4}, "angle");
    expect_bad_spec(MotorJoint{.max_force = -1}, "max_force");
    expect_bad_spec(MotorJoint{.max_torque = nan}, "max_torque");
    expect_bad_spec(MouseJoint{.target = {0, inf}}, "target.y");
    expect_bad_spec(MouseJoint{.max_force = nan}, "max_force");
    expect_bad_spec(GearJoint{.ratio = 0}, "ratio");
    expect_bad_spec(GearJoint{.ratio = nan}, "ratio");
    expect_bad_spec(GearJoint{.motion_a = static_cast<GearMotion>(5)}, "motion");
    expect_bad_spec(PulleyJoint{.ground_a = {nan, 0}}, "ground_a.x");
    expect_bad_spec(PulleyJoint{.ground_b = {0, inf}}, "ground_b.y");
    expect_bad_spec(PulleyJoint{.ratio = -1}, "ratio");
    expect_bad_spec(PulleyJoint{.length = 0}, "length");
}

TEST_F(JointTest, RefusesBadChanges)
{
    const JointId id = world.create_joint(world.joint_at(a, b, {1, 0}), RevoluteJoint{});
    expect_refused("set_spec", "spec", [&] { world.joint(id).set_spec(WeldJoint{}); });
    expect_refused("set_frames", "frame_a.p.x", [&] { world.joint(id).set_frames({{nan, 0}, {}}, {}); });
    expect_refused("set_frames", "frame_b.q", [&] { world.joint(id).set_frames({}, {{}, {0, 0}}); });
    expect_refused("set_break_limits", "force", [&] { world.joint(id).set_break_limits(0, 1); });
    expect_refused("set_break_limits", "torque", [&] { world.joint(id).set_break_limits(1, nan); });
}

// ---- error ----

TEST_F(JointTest, ErrorTellsWhatEachTypeMisses)
{
    const auto error_of = [&](const JointSpec& spec, Vec2 place, float turn)
    {
        world.body(a).set_transform({0, 0}, 0);
        world.body(b).set_transform({0, 0}, 0);
        const JointId id = world.create_joint(def_for(spec), spec);
        world.body(b).set_transform(place, turn);
        const float error = world.joint(id).error();
        world.destroy_joint(id);
        return error;
    };
    EXPECT_NEAR(error_of(RevoluteJoint{}, {3, 4}, 1), 5, 1e-5);
    EXPECT_NEAR(error_of(PrismaticJoint{}, {3, 0.5f}, 0.1f), 0.5f, 1e-5);
    EXPECT_NEAR(error_of(PrismaticJoint{}, {3, 0.5f}, -0.7f), 0.7f, 1e-5);
    EXPECT_NEAR(error_of(WheelJoint{}, {3, -0.5f}, 1), 0.5f, 1e-5);
    EXPECT_NEAR(error_of(DistanceJoint{.length = 2}, {3, 4}, 0), 3, 1e-5);
    EXPECT_NEAR(error_of(DistanceJoint{.limit = Range{0, 4}}, {3, 4}, 0), 1, 1e-5);
    EXPECT_NEAR(error_of(DistanceJoint{.limit = Range{6, 7}}, {3, 4}, 0), 1, 1e-5);
    EXPECT_NEAR(error_of(DistanceJoint{.limit = Range{4, 7}}, {3, 4}, 0), 0, 1e-5);
    EXPECT_NEAR(error_of(DistanceJoint{.spring = Spring{}}, {3, 4}, 0), 0, 1e-5);
    EXPECT_NEAR(error_of(WeldJoint{}, {0, 0.2f}, 0.5f), 0.5f, 1e-5);
    EXPECT_NEAR(error_of(WeldJoint{.angular = Spring{}}, {0, 0.2f}, 0.5f), 0.2f, 1e-5);
    EXPECT_NEAR(error_of(WeldJoint{.linear = Spring{}}, {0, 0.9f}, 0.5f), 0.5f, 1e-5);
    EXPECT_NEAR(error_of(PulleyJoint{.ground_a = {0, 5}, .ground_b = {3, 5}, .ratio = 2, .length = 6}, {3, 4}, 0), 1, 1e-5);
    EXPECT_EQ(error_of(MotorJoint{}, {3, 4}, 1), 0);
    EXPECT_EQ(error_of(MouseJoint{}, {3, 4}, 1), 0);
}

} // namespace carom::joint_tests
