// Joints between two free bodies push both alike: whatever a joint does, the momentum and the angular momentum of the pair stay.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace carom
{

namespace
{

struct Momentum
{
    double x = 0; ///< [kg m/s]
    double y = 0;
    double angular = 0; ///< about the origin [kg m^2/s]
    double scale = 0;   ///< sum of the sizes of all parts, to which rounding is relative
};

Momentum momentum_of(const World& world)
{
    Momentum sum;
    for (const BodyId id : world.bodies())
    {
        const BodyView body = world.body(id);
        if (body.type() != BodyType::Dynamic) continue;
        const MassData mass = body.mass_data();
        const Vec2 c = body.center_of_mass();
        const Vec2 v = body.linear_velocity();
        const double orbit = double{mass.mass} * (double{c.x} * double{v.y} - double{c.y} * double{v.x});
        const double spin = double{mass.inertia} * double{body.angular_velocity()};
        sum.x += double{mass.mass} * double{v.x};
        sum.y += double{mass.mass} * double{v.y};
        sum.angular += orbit + spin;
        sum.scale += double{mass.mass} * double{length(v)} * (1 + double{length(c)}) + std::abs(spin);
    }
    return sum;
}

/// How a joint starts. What is rigid starts closed: where it is open, bodies are moved together, and a moved body's angular momentum is another.
enum class Start
{
    Closed, ///< the origins of both frames meet, their axes agree
    Turned, ///< the origins meet
    Apart   ///< 1.5 m lie between the origins
};

struct NamedJoint
{
    const char* name;
    JointSpec spec;
    Start start;
};

/// Each type with each of its parts. Three kinds are not here, since they do not keep the momentum of their pair: mouse and pulley pull from points
/// of the world, and a gear whose ratio is not -1 turns its bodies by different torques, which their bearings have to hold.
const std::vector<NamedJoint> all_joints = {
    {"pin", RevoluteJoint{}, Start::Turned},
    {"pin_with_motor", RevoluteJoint{.motor = Motor{.speed = 3, .max_force = 20}}, Start::Turned},
    {"pin_with_spring", RevoluteJoint{.spring = Spring{.hertz = 3, .damping_ratio = 0.2f, .target = 1}}, Start::Turned},
    {"rail", PrismaticJoint{}, Start::Closed},
    {"rail_with_limit", PrismaticJoint{.limit = Range{-0.2f, 0.4f}}, Start::Closed},
    {"rail_with_motor", PrismaticJoint{.motor = Motor{.speed = -1, .max_force = 30}}, Start::Closed},
    {"rail_with_spring", PrismaticJoint{.spring = Spring{.hertz = 2, .damping_ratio = 0.5f, .target = 0.5f}}, Start::Closed},
    {"rod", DistanceJoint{.length = 1.5f}, Start::Apart},
    {"rope", DistanceJoint{.limit = Range{0, 1}}, Start::Apart},
    {"spring", DistanceJoint{.length = 1, .spring = Spring{.hertz = 2, .damping_ratio = 0.1f}}, Start::Apart},
    {"weld", WeldJoint{}, Start::Closed},
    {"soft_weld", WeldJoint{.linear = Spring{.hertz = 4}, .angular = Spring{.hertz = 4}}, Start::Apart},
    {"weld_with_soft_place", WeldJoint{.linear = Spring{.hertz = 4}}, Start::Closed},
    {"weld_with_soft_angle", WeldJoint{.angular = Spring{.hertz = 4}}, Start::Turned},
    {"wheel", WheelJoint{}, Start::Closed},
    {"wheel_with_all", WheelJoint{.limit = Range{-0.3f, 0.3f}, .motor = Motor{.speed = 10, .max_force = 50}}, Start::Closed},
    {"motor", MotorJoint{.max_force = 500, .max_torque = 500}, Start::Apart},
    {"motor_with_offset",
     MotorJoint{.offset = {3, 1}, .angle = 0.7f, .spring = {.hertz = 2, .damping_ratio = 0.5f}, .max_force = 500, .max_torque = 500},
     Start::Apart},
    {"gear", GearJoint{.ratio = -1}, Start::Apart},
};

class JointMomentum : public testing::TestWithParam<NamedJoint>
{
};

/// Two bodies with a joint in random frames.
World random_pair(std::mt19937& random, const NamedJoint& joint)
{
    const auto draw = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
    World world({.gravity = {}, .sleep = {.is_enabled = false}});
    const auto body = [&](Vec2 place)
    {
        const BodyDef def = {
            .position = place, .angle = draw(-3, 3), .linear_velocity = {draw(-2, 2), draw(-2, 2)}, .angular_velocity = draw(-3, 3)};
        const ShapeDef shape = {.density = draw(0.5f, 4), .filter = {.mask = 0}};
        return world.create_body(def, offset_box(draw(0.3f, 2), draw(0.3f, 2), {draw(-0.5f, 0.5f), 0}, 0), shape);
    };
    const BodyId a = body({draw(-1, 1), draw(-1, 1)});
    const BodyId b = body({draw(1, 3), draw(-1, 1)});
    const Vec2 point = {draw(0, 2), draw(-1, 1)};
    const SinCos way = sin_cos(draw(-3, 3));
    const float gap = joint.start == Start::Apart ? 1.5f : 0.0f;
    JointDef def = world.joint_between(a, b, point, point + gap * Vec2{way.cos, way.sin});
    if (joint.start != Start::Closed) def.frame_b.q = def.frame_b.q * rotation(draw(-2, 2));
    world.create_joint(def, joint.spec);
    return world;
}

} // namespace

TEST_P(JointMomentum, stays_whatever_the_joint_does)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        std::mt19937 random(seed);
        World world = random_pair(random, GetParam());
        const Momentum before = momentum_of(world);
        for (int i = 0; i < 120; ++i)
        {
            world.step(dt);
            const Momentum now = momentum_of(world);
            const double scale = before.scale + now.scale;
            ASSERT_NEAR(now.x, before.x, 2e-5 * scale) << "seed " << seed << ", step " << i;
            ASSERT_NEAR(now.y, before.y, 2e-5 * scale) << "seed " << seed << ", step " << i;
            // A pin that turns faster than a substep can follow opens by a hair, and its force then has an arm.
            ASSERT_NEAR(now.angular, before.angular, 5e-4 * scale) << "seed " << seed << ", step " << i;
        }
    }
}

/// Closing an open joint moves bodies and gives them no speed that would stay.
TEST(JointMomentumAtRest, stays_zero_while_pins_rails_and_welds_that_start_open_close)
{
    for (const JointSpec& spec : {JointSpec{RevoluteJoint{}}, JointSpec{WeldJoint{}}, JointSpec{PrismaticJoint{}}, JointSpec{WheelJoint{}}})
    {
        World world({.gravity = {}, .sleep = {.is_enabled = false}});
        const BodyId a = world.create_body({}, box(1, 1), {.density = 1});
        const BodyId b = world.create_body({.position = {3, 0}}, box(2, 1), {.density = 1});
        const JointId joint = world.create_joint(world.joint_between(a, b, {0.4f, 0.3f}, {2, 1}), spec);
        for (int i = 0; i < 120; ++i)
        {
            world.step(dt);
            // 1 g m/s and 1 g m^2/s of bodies of 1 and 2 kg
            ASSERT_NEAR(momentum_of(world).x, 0, 1e-3) << spec.index() << ", step " << i;
            ASSERT_NEAR(momentum_of(world).y, 0, 1e-3) << spec.index() << ", step " << i;
            ASSERT_NEAR(momentum_of(world).angular, 0, 1e-3) << spec.index() << ", step " << i;
        }
        EXPECT_LT(world.joint(joint).error(), 0.001f) << spec.index();
    }
}

INSTANTIATE_TEST_SUITE_P(Joints, JointMomentum, testing::ValuesIn(all_joints),
                         [](const auto& joint) { return std::string(joint.param.name); });

namespace
{

/// Box A of 1 x 1 m at rest at the origin and box B of 2 x 1 m at (3, 0), where the motor joint holds it.
struct MotorPair
{
    explicit MotorPair(Vec2 gravity = {}) : world({.gravity = gravity, .sleep = {.is_enabled = false}})
    {
        a = world.create_body({}, box(1, 1), {.density = 1});
        b = world.create_body({.position = {3, 0}}, box(2, 1), {.density = 1});
        joint = world.create_joint(
            {.body_a = a, .body_b = b},
            MotorJoint{.offset = {3, 0}, .spring = {.hertz = 2, .damping_ratio = 0.5f}, .max_force = 500, .max_torque = 500});
    }
    World world;
    BodyId a;
    BodyId b;
    JointId joint;
};

} // namespace

TEST(MotorJointMomentum, a_new_angle_turns_both_bodies_against_each_other)
{
    MotorPair pair;
    World& world = pair.world;
    world.joint(pair.joint)
        .set_spec(MotorJoint{
            .offset = {3, 0}, .angle = 0.5f, .spring = {.hertz = 2, .damping_ratio = 0.5f}, .max_force = 500, .max_torque = 500});
    for (int i = 0; i < 600; ++i)
    {
        world.step(dt);
        ASSERT_NEAR(momentum_of(world).angular, 0, 0.01) << "step " << i;
    }
    EXPECT_NEAR(world.joint(pair.joint).angle(), 0.5f, 0.01f);
    EXPECT_NEAR(world.joint(pair.joint).offset().x, 3, 0.01f);
}

TEST(MotorJointMomentum, a_sideways_blow_leaves_the_angular_momentum_that_it_gave)
{
    MotorPair pair;
    World& world = pair.world;
    world.body(pair.b).apply_impulse({0, 1}, {3, 0});
    for (int i = 0; i < 600; ++i) world.step(dt);
    EXPECT_NEAR(momentum_of(world).angular, 3, 0.03);
    EXPECT_NEAR(momentum_of(world).y, 1, 1e-3);
}

TEST(MotorJointMomentum, a_box_held_out_beside_a_pillar_tips_the_box_that_holds_it)
{
    World world;
    world.create_body({.type = BodyType::Static, .position = {0, -0.5f}}, box(1, 1));
    world.create_body({.type = BodyType::Static, .position = {0, -20}}, box(100, 1));
    const BodyId a = world.create_body({.position = {0, 0.5f}}, box(1, 1));
    const BodyId b = world.create_body({.position = {4, 0.5f}}, box(1, 1));
    world.create_joint({.body_a = a, .body_b = b},
                       MotorJoint{.offset = {4, 0}, .spring = {.hertz = 10}, .max_force = 1e4f, .max_torque = 1e4f});
    for (int i = 0; i < 180; ++i) world.step(dt);
    EXPECT_LT(world.body(b).position().y, -1) << "B hangs in the air";
    EXPECT_GT(std::abs(world.body(a).angle()), 0.5f);
}

} // namespace carom
