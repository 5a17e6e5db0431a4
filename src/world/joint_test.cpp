// Joints through the public API: what can be read and set, what is refused, and what happens when bodies change or go.
#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace carom
{

namespace
{

constexpr float dt = 1 / 60.0f;
constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

const std::vector<JointSpec> all_specs = {RevoluteJoint{}, PrismaticJoint{}, DistanceJoint{}, WeldJoint{},  WheelJoint{},
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

    template <class Call>
    void expect_refused(const std::string& function, const std::string& field, Call&& call)
    {
        const std::uint64_t before = world.hash();
        try
        {
            call();
            ADD_FAILURE() << function << " took a bad " << field;
        }
        catch (const UsageError& error)
        {
            EXPECT_EQ(error.function(), function) << error.what();
            EXPECT_EQ(error.field(), field) << error.what();
            EXPECT_FALSE(error.value().empty()) << error.what();
            EXPECT_FALSE(error.remedy().empty()) << error.what();
        }
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

} // namespace

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

// ---- changes on the way ----

TEST_F(JointTest, ASpecCanChangeWhileItRuns)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), RevoluteJoint{});
    step(10);
    EXPECT_NEAR(world.joint(id).angle(), 0, 1e-4);
    world.joint(id).set_spec(RevoluteJoint{.motor = Motor{2, 1000}});
    step(60);
    EXPECT_NEAR(world.body(a).angular_velocity(), 2, 1e-3);
    world.joint(id).set_spec(RevoluteJoint{.limit = Range{-0.1f, 0.1f}});
    step(120);
    EXPECT_NEAR(world.joint(id).angle(), 0.1f, 0.01f) << "pushed back into its range";
    world.joint(id).set_spec(RevoluteJoint{.spring = Spring{2, 1, -1}});
    step(240);
    EXPECT_NEAR(world.joint(id).angle(), -1, 0.01f);
}

TEST_F(JointTest, AChangeOfFormStartsCold)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), WeldJoint{});
    step(30);
    EXPECT_NEAR(world.joint(id).force().y, 10, 0.1f);
    world.joint(id).set_spec(WeldJoint{.linear = Spring{3, 1}});
    EXPECT_EQ(world.joint(id).force(), Vec2{});
    step(300);
    EXPECT_NEAR(world.joint(id).force().y, 10, 0.1f);
    EXPECT_LT(world.body(a).position().y, -0.01f) << "the spring gives way";
}

TEST_F(JointTest, FramesCanChangeWhileItRuns)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), WeldJoint{});
    step(10);
    world.joint(id).set_frames({{0, 1}, {}}, {});
    step(120);
    EXPECT_NEAR(world.body(a).position().y, 1, 1e-3);
    EXPECT_EQ(world.joint(id).frame_a().p, (Vec2{0, 1}));
}

TEST_F(JointTest, UserDataAndBreakLimitsCanChange)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), WeldJoint{});
    world.joint(id).set_user_data(5);
    world.joint(id).set_break_limits(3, inf);
    EXPECT_EQ(world.joint(id).user_data(), 5u);
    EXPECT_EQ(world.joint(id).break_force(), 3);
    EXPECT_EQ(world.joint(id).break_torque(), inf);
}

TEST_F(JointTest, AnAngleIsCountedOverFullTurns)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), RevoluteJoint{.motor = Motor{10, 1e5f}});
    step(180);
    EXPECT_NEAR(world.joint(id).angle(), 30, 0.2f);
    world.joint(id).set_spec(RevoluteJoint{.motor = Motor{-10, 1e5f}});
    step(360);
    EXPECT_NEAR(world.joint(id).angle(), -30, 0.5f);
}

TEST_F(JointTest, ALimitMayBeWiderThanATurn)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), RevoluteJoint{.limit = Range{-15, 15}, .motor = Motor{6, 100}});
    step(120);
    EXPECT_NEAR(world.joint(id).angle(), 12, 0.1f) << "free within two turns";
    step(120);
    EXPECT_NEAR(world.joint(id).angle(), 15, 0.02f);
    EXPECT_NEAR(world.body(a).angular_velocity(), 0, 0.02f);
    world.joint(id).set_spec(RevoluteJoint{.limit = Range{-15, 15}, .motor = Motor{-6, 100}});
    step(400);
    EXPECT_NEAR(world.joint(id).angle(), -15, 0.02f);
}

TEST_F(JointTest, ATeleportCountsNoTurn)
{
    const JointId id = world.create_joint(world.joint_at({}, a, {0, 0}), RevoluteJoint{});
    world.body(a).set_transform({0, 0}, 3);
    EXPECT_NEAR(world.joint(id).angle(), 3, 1e-5);
    step(1);
    world.body(a).set_transform({0, 0}, -3); // the short way from 3
    EXPECT_NEAR(world.joint(id).angle(), 2 * pi - 3, 1e-5);
}

// ---- bodies ----

TEST_F(JointTest, ADestroyedBodyTakesItsJointsAlong)
{
    const JointId both = world.create_joint(world.joint_at(a, b, {1, 0}), RevoluteJoint{});
    const JointId other = world.create_joint(world.joint_at({}, b, {2, 0}), RevoluteJoint{});
    step(3);
    world.destroy_body(a);
    EXPECT_FALSE(world.find_joint(both));
    EXPECT_TRUE(world.find_joint(other));
    EXPECT_EQ(world.joints_of(b), (std::vector<JointId>{other}));
    step(30);
    EXPECT_TRUE(world.events().joint_break.empty()) << "no break: it was taken away";
    EXPECT_NEAR(world.body(b).position().y, 0, 1e-3);
}

TEST_F(JointTest, ADisabledBodyHoldsNothingAndIsHeldAgain)
{
    world.create_joint(world.joint_at({}, a, {0, 0}), WeldJoint{});
    world.create_joint(world.joint_at(a, b, {1, 0}), WeldJoint{});
    step(30);
    EXPECT_NEAR(world.body(b).position().y, 0, 1e-3);
    world.body(a).set_enabled(false);
    step(6);
    EXPECT_LT(world.body(b).position().y, -0.02f) << "falls";
    world.body(a).set_enabled(true);
    step(120);
    EXPECT_NEAR(world.body(b).position().y, 0, 0.01f);
    EXPECT_NEAR(world.body(b).position().x, 2, 0.01f);
}

TEST_F(JointTest, AStaticBodyIsAsGoodAsTheWorld)
{
    const JointId id = world.create_joint(world.joint_at(a, b, {1, 0}), WeldJoint{});
    world.body(a).set_type(BodyType::Static);
    step(60);
    EXPECT_NEAR(world.body(b).position().y, 0, 1e-3);
    EXPECT_NEAR(world.joint(id).force().y, 10, 0.1f);
    world.body(b).set_type(BodyType::Static);
    step(5);
    EXPECT_EQ(world.body(b).position().y, world.body(b).position().y);
    world.body(b).set_type(BodyType::Dynamic);
    world.body(a).set_type(BodyType::Dynamic);
    step(60);
    EXPECT_LT(world.body(a).position().y, -1) << "both fall";
    EXPECT_LT(world.joint(id).error(), 1e-3f);
}

TEST_F(JointTest, AKinematicBodyLeads)
{
    const BodyId leader = world.create_body({.type = BodyType::Kinematic, .position = {0, 5}, .linear_velocity = {1, 0}});
    const BodyId load = world.create_body({.position = {0, 3}}, circle(0.2f));
    const JointId rod = world.create_joint(world.joint_between(leader, load, {0, 5}, {0, 3}), DistanceJoint{.length = 2});
    step(300);
    EXPECT_NEAR(world.body(leader).position().x, 5, 1e-3);
    EXPECT_LT(std::abs(world.body(load).position().x - 5), 1.5f);
    EXPECT_LT(world.joint(rod).error(), 1e-3f);
}

TEST_F(JointTest, LockedAxesAreHeeded)
{
    world.body(b).set_locks({.x = true, .rotation = true});
    const JointId id = world.create_joint(world.joint_between({}, b, {2, 3}, {2, 0}), DistanceJoint{.length = 3});
    step(120);
    EXPECT_EQ(world.body(b).position().x, 2);
    EXPECT_NEAR(world.body(b).position().y, 0, 1e-3);
    EXPECT_NEAR(world.joint(id).force().y, 10, 0.1f);
    world.body(b).set_locks({true, true, true}); // nothing left to push
    step(10);
    EXPECT_TRUE(is_finite(world.joint(id).force()));
}

// ---- what the two bodies may touch ----

TEST_F(JointTest, ConnectedBodiesTouchOnlyWhenTheyMay)
{
    World flat({.gravity = {}});
    const auto touching = [&](BodyId body) { return !flat.shape(flat.body(body).shapes()[0]).touching().empty(); };
    const BodyId first = flat.create_body({.position = {0, 0}}, box(1, 1));
    const BodyId second = flat.create_body({.position = {0.9f, 0}}, box(1, 1));
    flat.step(dt);
    EXPECT_TRUE(touching(first));

    const JointId id = flat.create_joint(flat.joint_at(first, second, {0.45f, 0}), RevoluteJoint{});
    EXPECT_FALSE(touching(first)) << "the contact ends with the joint";
    flat.step(dt);
    EXPECT_FALSE(touching(first));
    EXPECT_EQ(flat.events().contact_end.size(), 1u);

    flat.joint(id).set_collide_connected(true);
    flat.step(dt);
    EXPECT_TRUE(touching(first));
    flat.joint(id).set_collide_connected(false);
    flat.step(dt);
    EXPECT_FALSE(touching(first));

    flat.destroy_joint(id);
    flat.step(dt);
    EXPECT_TRUE(touching(first)) << "and comes back without it";
}

TEST_F(JointTest, OneOfTwoJointsIsEnoughToKeepBodiesApart)
{
    World flat({.gravity = {}});
    const BodyId first = flat.create_body({.position = {0, 0}}, box(1, 1));
    const BodyId second = flat.create_body({.position = {0.9f, 0}}, box(1, 1));
    JointDef def = flat.joint_at(first, second, {0.45f, 0});
    const JointId quiet = flat.create_joint(def, RevoluteJoint{});
    def.collide_connected = true;
    const JointId loud = flat.create_joint(def, RevoluteJoint{});
    const auto touching = [&]
    {
        flat.step(dt);
        return !flat.shape(flat.body(first).shapes()[0]).touching().empty();
    };
    EXPECT_FALSE(touching());
    flat.joint(loud).set_collide_connected(false);
    flat.joint(loud).set_collide_connected(true);
    EXPECT_FALSE(touching());
    flat.destroy_joint(quiet);
    EXPECT_TRUE(touching());
}

// ---- breaking ----

TEST_F(JointTest, BreaksUnderAForceAndTellsOnce)
{
    JointDef def = world.joint_at({}, a, {0, 0});
    def.user_data = 9;
    def.break_force = 20;
    const JointId id = world.create_joint(def, WeldJoint{}); // carries 10 N
    step(60);
    EXPECT_TRUE(world.find_joint(id));
    world.body(a).apply_force_to_center({0, -30});
    step(1);
    ASSERT_EQ(world.events().joint_break.size(), 1u);
    const JointBreak& event = world.events().joint_break[0];
    EXPECT_EQ(event.joint, id);
    EXPECT_EQ(event.body_a, BodyId{});
    EXPECT_EQ(event.body_b, a);
    EXPECT_NEAR(event.force, 40, 1);
    EXPECT_EQ(event.user_data, 9u);
    EXPECT_FALSE(world.find_joint(id));
    step(1);
    EXPECT_TRUE(world.events().joint_break.empty());
    step(60);
    EXPECT_LT(world.body(a).position().y, -3);
}

TEST_F(JointTest, BreaksUnderATorque)
{
    JointDef def = world.joint_at(a, b, {1, 0});
    def.break_torque = 5;
    const JointId id = world.create_joint(def, WeldJoint{});
    world.body(a).set_type(BodyType::Static); // B's weight of 10 N now hangs on a lever of 1 m
    int breaks = 0;
    for (int i = 0; i < 60; ++i)
    {
        step(1);
        for (const JointBreak& event : world.events().joint_break)
        {
            ++breaks;
            EXPECT_EQ(event.joint, id);
            EXPECT_EQ(event.body_a, a);
            EXPECT_GT(event.torque, 5);
        }
    }
    EXPECT_EQ(breaks, 1);
}

TEST_F(JointTest, SeveralBreaksComeInOrder)
{
    std::vector<JointId> ids;
    for (const BodyId body : {b, a})
    {
        JointDef def = world.joint_at({}, body, world.body(body).position());
        def.break_force = 1;
        ids.push_back(world.create_joint(def, WeldJoint{}));
    }
    step(1);
    ASSERT_EQ(world.events().joint_break.size(), 2u);
    EXPECT_EQ(world.events().joint_break[0].joint, ids[0]);
    EXPECT_EQ(world.events().joint_break[1].joint, ids[1]);
    EXPECT_EQ(world.joint_count(), 0);
}

// ---- the rest ----

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

TEST_F(JointTest, AMouseMovesABodyToItsTarget)
{
    const JointId id =
        world.create_joint(world.joint_at({}, a, {0.4f, 0}), MouseJoint{.target = {0.4f, 0}, .spring = {3, 1}, .max_force = 500});
    for (int i = 0; i < 120; ++i)
    {
        world.joint(id).set_spec(MouseJoint{.target = {0.4f, 0.02f * static_cast<float>(i)}, .spring = {3, 1}, .max_force = 500});
        step(1);
    }
    step(300);
    const Vec2 held = world.body(a).transform() * Vec2{0.4f, 0};
    EXPECT_NEAR(held.x, 0.4f, 0.05f);
    EXPECT_NEAR(held.y, 2.38f, 0.05f);
}

TEST_F(JointTest, AMotorJointLeadsWithALimitedForce)
{
    World flat({.gravity = {}});
    const BodyId body = flat.create_body({}, box(1, 1), {.density = 2});
    const JointId id = flat.create_joint(flat.joint_at({}, body, {}),
                                         MotorJoint{.offset = {3, 0}, .angle = 1, .spring = {2, 1}, .max_force = 4, .max_torque = 1});
    flat.step(dt);
    EXPECT_NEAR(length(flat.joint(id).force()), 4, 0.01f) << "all the force that it has";
    for (int i = 0; i < 600; ++i) flat.step(dt);
    EXPECT_NEAR(flat.body(body).position().x, 3, 0.01f);
    EXPECT_NEAR(flat.body(body).angle(), 1, 0.01f);
}

TEST_F(JointTest, EditsAreRefusedDuringAStepAndTheCopyOfAStepIsEqual)
{
    // Two worlds with the same joints go the same way.
    const auto run = [](bool jitters)
    {
        World one;
        const BodyId first = one.create_body({.position = {1, 0}}, box(2, 0.2f));
        const BodyId second = one.create_body({.position = {3, 0}}, box(2, 0.2f));
        one.create_joint(one.joint_at({}, first, {0, 0}), RevoluteJoint{});
        const JointId id = one.create_joint(one.joint_at(first, second, {2, 0}), RevoluteJoint{.limit = Range{-1, 1}});
        for (int i = 0; i < 200; ++i)
        {
            if (jitters && i == 100) one.joint(id).set_break_limits(1e6f, 1e6f);
            one.step(dt);
        }
        return one.hash();
    };
    EXPECT_EQ(run(false), run(false));
    EXPECT_NE(run(false), run(true)) << "break limits are state";
}

TEST_F(JointTest, AWarmStepWithJointsAllocatesNothing)
{
    BodyId before;
    for (int i = 0; i < 30; ++i)
    {
        const float x = 5 + static_cast<float>(i);
        const BodyId body = world.create_body({.position = {x + 0.5f, 0}}, box(1, 0.2f), {.filter = {.group = -1}});
        world.create_joint(world.joint_at(before, body, {x, 0}), RevoluteJoint{});
        before = body;
    }
    step(30);
    for (int i = 0; i < 120; ++i) EXPECT_EQ(world.step(dt).allocations, 0u) << i;
}

} // namespace carom
