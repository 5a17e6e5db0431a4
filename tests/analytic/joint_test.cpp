// Joints against what mechanics says of them: pendulums keep their energy, ropes carry their loads, gears and pulleys keep their ratios.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

namespace carom
{

namespace
{

constexpr double g = 9.81;

double square(double x) { return x * x; }

/// Of all dynamic bodies: motion and height [J].
double mechanical_energy(const World& world)
{
    double sum = 0;
    for (const BodyId id : world.bodies())
    {
        const BodyView body = world.body(id);
        if (body.type() != BodyType::Dynamic) continue;
        const MassData mass = body.mass_data();
        const Vec2 v = body.linear_velocity();
        sum += 0.5 * double{mass.mass} * double{dot(v, v)} + 0.5 * double{mass.inertia} * square(body.angular_velocity());
        sum += g * double{mass.mass} * double{body.center_of_mass().y};
    }
    return sum;
}

/// What a spring holds when `mass` swings on it and it is `x` from rest [J].
double spring_energy(double mass, double hertz, double x) { return 0.5 * mass * square(2 * double{pi} * hertz * x); }

double worst_error(const World& world)
{
    double worst = 0;
    for (const JointId id : world.joints()) worst = std::max(worst, double{world.joint(id).error()});
    return worst;
}

struct Swing
{
    double worst_error = 0; ///< [m]
    double drift = 0;       ///< mean energy of the last 5 s less that of the first 5 s, as a share of the energy of the swing
};

/// One minute.
/// @param scale   energy that the swing turns from height into motion [J]
/// @param springs energy of springs [J]
Swing swing_for_a_minute(World& world, double scale, const std::function<double()>& springs = [] { return 0.0; }, int substeps = 4)
{
    Swing swing;
    std::vector<double> energy;
    for (int i = 0; i < 3600; ++i)
    {
        world.step(dt, substeps);
        swing.worst_error = std::max(swing.worst_error, worst_error(world));
        energy.push_back(mechanical_energy(world) + springs());
    }
    const auto mean = [](auto begin, auto end) { return std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin); };
    swing.drift = (mean(energy.end() - 300, energy.end()) - mean(energy.begin(), energy.begin() + 300)) / scale;
    return swing;
}

void expect_sound(const Swing& swing)
{
    EXPECT_LT(swing.worst_error, 0.001);
    EXPECT_LT(std::abs(swing.drift), 0.01);
}

/// A bar of 2 m, pinned to the world at its left end, level.
BodyId add_arm(World& world)
{
    const BodyId arm = world.create_body({.position = {1, 0}}, box(2, 0.2f));
    world.create_joint(world.joint_at({}, arm, {0, 0}), RevoluteJoint{});
    return arm;
}

double mass_of(const World& world, BodyId id) { return double{world.body(id).mass_data().mass}; }

} // namespace

// ---- a pendulum on each joint type ----

TEST(Pendulum, revolute)
{
    World world;
    const BodyId arm = add_arm(world);
    expect_sound(swing_for_a_minute(world, g * mass_of(world, arm)));
}

namespace
{

/// Two arms on revolutes, stretched out and let go at an angle below level [rad].
Swing double_pendulum(float below, int substeps)
{
    World world;
    const Rot q = rotation(-below);
    const BodyId arm = world.create_body({.position = rotate(q, Vec2{1, 0}), .angle = -below}, box(2, 0.2f));
    const BodyId second = world.create_body({.position = rotate(q, Vec2{3, 0}), .angle = -below}, box(2, 0.2f));
    world.create_joint(world.joint_at({}, arm, {0, 0}), RevoluteJoint{});
    world.create_joint(world.joint_at(arm, second, rotate(q, Vec2{2, 0})), RevoluteJoint{});
    return swing_for_a_minute(world, 4 * g * mass_of(world, arm) * double{1 - sin_cos(below).sin}, [] { return 0.0; }, substeps);
}

} // namespace

TEST(Pendulum, two_arms_on_revolutes)
{
    // Let go 45 degrees below level it swings without whirling over, and keeps its energy to 0.01%.
    expect_sound(double_pendulum(pi / 4, 4));
}

TEST(Pendulum, two_arms_let_go_level_lose_less_with_more_substeps)
{
    // Chaotic: the second arm whirls over several times, at up to 11 rad/s. It has lost 0.8% after a minute of 4 substeps a step, 0.12%
    // with 8, and 0.03% with 16: what is lost falls at least with the square of the substep. Chaos can double a figure.
    const Swing at_4 = double_pendulum(0, 4);
    const Swing at_8 = double_pendulum(0, 8);
    const Swing at_16 = double_pendulum(0, 16);
    EXPECT_LT(std::abs(at_4.drift), 0.02);
    EXPECT_LT(std::abs(at_8.drift), 0.005);
    EXPECT_LT(std::abs(at_16.drift), 0.00125);
    EXPECT_LT(at_4.worst_error, 0.001);
    EXPECT_LT(at_8.worst_error, 0.00025);
}

TEST(Pendulum, rod)
{
    World world;
    const BodyId bob = world.create_body({.position = {2, 0}}, circle(0.2f));
    world.create_joint(world.joint_between({}, bob, {0, 0}, {2, 0}), DistanceJoint{.length = 2});
    expect_sound(swing_for_a_minute(world, 2 * g * mass_of(world, bob)));
}

TEST(Pendulum, rope)
{
    World world;
    const BodyId bob = world.create_body({.position = {2, 0}}, circle(0.2f));
    world.create_joint(world.joint_between({}, bob, {0, 0}, {2, 0}), DistanceJoint{.limit = Range{0, 2}});
    expect_sound(swing_for_a_minute(world, 2 * g * mass_of(world, bob)));
}

TEST(Pendulum, elastic)
{
    World world;
    const BodyId bob = world.create_body({.position = {2, 0}}, circle(0.2f));
    world.create_joint(world.joint_between({}, bob, {0, 0}, {2, 0}), DistanceJoint{.length = 2, .spring = Spring{2, 0}});
    const double mass = mass_of(world, bob);
    expect_sound(
        swing_for_a_minute(world, 2 * g * mass, [&] { return spring_energy(mass, 2, double{length(world.body(bob).position())} - 2); }));
}

TEST(Pendulum, weld)
{
    World world;
    const BodyId arm = add_arm(world);
    const BodyId tip = world.create_body({.position = {3, 0}}, box(2, 0.2f));
    world.create_joint(world.joint_at(arm, tip, {2, 0}), WeldJoint{});
    expect_sound(swing_for_a_minute(world, 4 * g * mass_of(world, arm)));
}

TEST(Pendulum, prismatic_at_its_limit)
{
    World world;
    const BodyId arm = add_arm(world);
    const BodyId slider = world.create_body({.position = {3, 0}}, box(2, 0.2f));
    world.create_joint(world.joint_at(arm, slider, {2, 0}), PrismaticJoint{.limit = Range{0, 0}});
    expect_sound(swing_for_a_minute(world, 4 * g * mass_of(world, arm)));
}

TEST(Pendulum, prismatic_on_a_spring)
{
    World world;
    const BodyId arm = add_arm(world);
    const BodyId slider = world.create_body({.position = {3, 0}}, box(2, 0.2f));
    const JointId rail = world.create_joint(world.joint_at(arm, slider, {2, 0}), PrismaticJoint{.spring = Spring{2, 0}});
    const double mass = mass_of(world, arm); // of each: the two swing against each other with half of it
    expect_sound(swing_for_a_minute(world, 4 * g * mass, [&] { return spring_energy(mass / 2, 2, double{world.joint(rail).offset().x}); }));
}

TEST(Pendulum, wheel_on_a_suspension)
{
    World world;
    const BodyId arm = add_arm(world);
    const BodyId wheel = world.create_body({.position = {2, 0}}, circle(0.4f));
    // The suspension's axis leads through both centres of mass, so that turning does not give way with it.
    const JointId joint = world.create_joint(world.joint_at(arm, wheel, {2, 0}), WheelJoint{.suspension = Spring{3, 0}});
    const double reduced = 1 / (1 / mass_of(world, arm) + 1 / mass_of(world, wheel));
    const auto springs = [&] { return spring_energy(reduced, 3, double{world.joint(joint).offset().x}); };
    expect_sound(swing_for_a_minute(world, 3 * g * mass_of(world, arm), springs));
}

TEST(Pendulum, mouse_as_a_spring_in_the_plane)
{
    World world;
    const BodyId bob = world.create_body({.position = {1, 0}}, circle(0.2f));
    world.create_joint(world.joint_at({}, bob, {1, 0}), MouseJoint{.target = {}, .spring = {1, 0}, .max_force = 1e6f});
    const double mass = mass_of(world, bob);
    expect_sound(swing_for_a_minute(world, g * mass, [&] { return spring_energy(mass, 1, double{length(world.body(bob).position())}); }));
}

TEST(Pendulum, motor_holds_a_tip_on_a_stiff_spring)
{
    World world;
    const BodyId arm = add_arm(world);
    const BodyId tip = world.create_body({.position = {2.2f, 0}}, box(0.4f, 0.4f));
    const JointId motor =
        world.create_joint(world.joint_at(arm, tip, {2.2f, 0}), MotorJoint{.spring = {8, 0}, .max_force = 1e6f, .max_torque = 1e6f});
    const MassData a = world.body(arm).mass_data();
    const MassData b = world.body(tip).mass_data();
    const auto springs = [&]
    {
        // Along the arm the two masses swing against each other; across it the arm's turning gives way too; seen in the arm's frame.
        const Vec2 offset = world.joint(motor).offset();
        const double along = 1 / (1 / double{a.mass} + 1 / double{b.mass});
        const double across = 1 / (1 / double{a.mass} + 1 / double{b.mass} + 1.2 * 1.2 / double{a.inertia});
        const double turning = 1 / (1 / double{a.inertia} + 1 / double{b.inertia});
        return spring_energy(along, 8, double{offset.x}) + spring_energy(across, 8, double{offset.y}) +
               spring_energy(turning, 8, double{world.joint(motor).angle()});
    };
    expect_sound(swing_for_a_minute(world, g * (double{a.mass} + 2.2 * double{b.mass}), springs));
    EXPECT_LT(length(world.joint(motor).offset()), 0.02f) << "it holds";
}

TEST(Pendulum, geared_to_a_flywheel)
{
    World world;
    const BodyId arm = add_arm(world);
    const BodyId wheel = world.create_body({.position = {-2, 0}}, circle(0.6f));
    world.create_joint(world.joint_at({}, wheel, {-2, 0}), RevoluteJoint{});
    world.create_joint({.body_a = arm, .body_b = wheel}, GearJoint{.ratio = 0.5f});
    expect_sound(swing_for_a_minute(world, g * mass_of(world, arm)));
}

TEST(Pendulum, swings_on_a_pulley_against_a_weight)
{
    // A bob that swings 30 degrees aside pulls on the mean 1.07 times its weight: such a counterweight hardly moves.
    World world;
    const BodyId weight = world.create_body({.position = {-2, -3}}, box(1, 1), {.density = 1.07f});
    const BodyId bob = world.create_body({.position = {3.5f, -2.598f}}, circle(0.5642f)); // 1 kg
    world.create_joint(world.joint_between(weight, bob, {-2, -3}, world.body(bob).position()),
                       PulleyJoint{.ground_a = {-2, 0}, .ground_b = {2, 0}, .length = 6});
    expect_sound(swing_for_a_minute(world, g * 3 * (1 - std::cos(double{pi} / 6))));
}

// ---- forces ----

TEST(JointForce, of_a_hanging_body_is_its_weight)
{
    const std::vector<JointSpec> specs = {RevoluteJoint{},
                                          DistanceJoint{.length = 2},
                                          DistanceJoint{.limit = Range{0, 2}},
                                          DistanceJoint{.length = 2, .spring = Spring{3, 1}},
                                          WeldJoint{},
                                          WeldJoint{.linear = Spring{5, 1}},
                                          PrismaticJoint{.limit = Range{0, 0}},
                                          WheelJoint{.suspension = Spring{3, 1}},
                                          MotorJoint{.spring = {5, 1}, .max_force = 1e5f, .max_torque = 1e5f}};
    for (const JointSpec& spec : specs)
    {
        World world;
        const BodyId body = world.create_body({.position = {0, -2}}, box(1, 1), {.density = 7});
        const bool is_rod = std::holds_alternative<DistanceJoint>(spec);
        const JointId joint =
            world.create_joint(is_rod ? world.joint_between({}, body, {0, 0}, {0, -2}) : world.joint_at({}, body, {0, -2}, -pi / 2), spec);
        for (int i = 0; i < 600; ++i) world.step(dt);
        EXPECT_NEAR(world.joint(joint).force().y, 7 * g, 0.01 * 7 * g) << "spec " << spec.index();
        EXPECT_NEAR(world.joint(joint).force().x, 0, 0.07 * g) << "spec " << spec.index();
        EXPECT_NEAR(world.joint(joint).torque(), 0, 0.07 * g) << "spec " << spec.index();
    }
}

TEST(JointForce, of_a_cantilever_is_its_weight_and_its_moment)
{
    World world;
    const BodyId beam = world.create_body({.position = {1, 0}}, box(2, 0.2f), {.density = 5}); // 2 kg
    const JointId weld = world.create_joint(world.joint_at({}, beam, {0, 0}), WeldJoint{});
    for (int i = 0; i < 60; ++i) world.step(dt);
    EXPECT_NEAR(world.joint(weld).force().y, 2 * g, 0.002 * g);
    EXPECT_NEAR(world.joint(weld).torque(), 2 * g, 0.002 * g) << "2 kg on a lever of 1 m";
}

TEST(JointForce, of_a_conical_swing_holds_weight_and_centripetal_force)
{
    World world({.gravity = {}});
    const BodyId bob = world.create_body({.position = {2, 0}, .linear_velocity = {0, 6}}, box(1, 1));
    const JointId rod = world.create_joint(world.joint_between({}, bob, {0, 0}, {2, 0}), DistanceJoint{.length = 2});
    for (int i = 0; i < 100; ++i)
    {
        world.step(dt);
        ASSERT_NEAR(length(world.joint(rod).force()), 6 * 6 / 2.0, 0.01 * 18) << "v^2 / r";
    }
}

// ---- chains ----

namespace
{

struct ChainRun
{
    double worst_stretch = 0; ///< sum of the links' errors as a share of the chain's length
    double gain = 0;          ///< most energy past that of the start, as a share of what letting it fall could give
};

/// Links of 0.5 m and 1 kg, the last of which has `load` times the mass, let go at an angle from hanging down.
ChainRun run_chain(int count, float load, float angle, int seconds, int substeps = 4)
{
    constexpr float link = 0.5f;
    World world;
    BodyId before;
    const Rot q = rotation(angle);
    for (int i = 0; i < count; ++i)
    {
        const float top = -link * static_cast<float>(i);
        const BodyId body = world.create_body({.position = rotate(q, Vec2{0, top - link / 2}), .angle = angle}, box(0.1f, link),
                                              {.density = i == count - 1 ? 20 * load : 20});
        world.create_joint(world.joint_at(before, body, rotate(q, Vec2{0, top})), RevoluteJoint{});
        before = body;
    }
    const double length = count * double{link};
    const double scale = g * length * (count / 2.0 + double{load});
    const double start = mechanical_energy(world);
    ChainRun run;
    for (int i = 0; i < 60 * seconds; ++i)
    {
        world.step(dt, substeps);
        double sum = 0;
        for (const JointId id : world.joints()) sum += double{world.joint(id).error()};
        run.worst_stretch = std::max(run.worst_stretch, sum / length);
        run.gain = std::max(run.gain, (mechanical_energy(world) - start) / scale);
    }
    return run;
}

} // namespace

TEST(Chain, of_100_links_carries_100_and_1000_times_a_links_mass)
{
    for (const float load : {1.0f, 100.0f, 1000.0f})
        for (const float angle : {0.0f, pi / 6})
        {
            const ChainRun run = run_chain(100, load, angle, 20);
            EXPECT_LT(run.worst_stretch, 0.0005) << load << " times, let go at " << angle;
            EXPECT_LT(run.gain, 0.001) << load << " times, let go at " << angle;
        }
}

TEST(Chain, energy_of_a_whip)
{
    // Let go level, a chain folds, and its fold runs to the end ever faster. What happens there is too fast for the substeps: the whip
    // may lose energy, but must not gain.
    struct Case
    {
        int count;
        float load;
        float angle;
        int substeps;
    };
    const std::vector<Case> cases = {{100, 1, 1.57f, 4},  {100, 1, 1.57f, 16}, {100, 100, 1.57f, 4}, {100, 100, 1.57f, 16},
                                     {100, 10, 1.57f, 4}, {10, 1, 3.0f, 4},    {20, 1, 2.0f, 4},     {30, 1, 1.57f, 2}};
    for (const Case& c : cases)
    {
        const ChainRun run = run_chain(c.count, c.load, c.angle, 20, c.substeps);
        EXPECT_LT(run.gain, 0.02) << c.count << " links, " << c.load << " times, let go at " << c.angle << ", " << c.substeps
                                  << " substeps";
        EXPECT_LT(run.worst_stretch, 0.03) << c.count << " links, " << c.load << " times, let go at " << c.angle;
    }
}

TEST(Chain, of_ropes_carries_too)
{
    // Ends of ranges are solved one by one, not together: what a chain of them stretches is told here.
    World world;
    BodyId before;
    for (int i = 0; i < 5; ++i)
    {
        const Vec2 place{0, -1.0f - static_cast<float>(i)};
        const BodyId body = world.create_body({.position = place}, circle(0.2f), {.density = i == 4 ? 80.0f : 8.0f});
        world.create_joint(world.joint_between(before, body, place + Vec2{0, 1}, place), DistanceJoint{.limit = Range{0, 1}});
        before = body;
    }
    for (int i = 0; i < 600; ++i) world.step(dt);
    EXPECT_NEAR(world.body(before).position().y, -5, 0.02 * 5);
}

// ---- gears, pulleys, motors ----

TEST(Gear, keeps_its_ratio_under_load)
{
    World world;
    const BodyId small = world.create_body({.position = {0, 0}}, circle(0.5f));
    const BodyId large = world.create_body({.position = {1.5f, 0}}, circle(1), {.density = 30});
    world.create_joint(world.joint_at({}, small, {0, 0}), RevoluteJoint{.motor = Motor{6, 400}});
    world.create_joint(world.joint_at({}, large, {1.5f, 0}), RevoluteJoint{});
    const JointId gear = world.create_joint({.body_a = small, .body_b = large}, GearJoint{.ratio = 2});
    for (int i = 0; i < 3600; ++i)
    {
        world.step(dt);
        ASSERT_NEAR(world.body(small).angular_velocity(), -2 * world.body(large).angular_velocity(), 1e-3f) << i;
        ASSERT_LT(world.joint(gear).error(), 1e-3f);
    }
    EXPECT_NEAR(world.body(small).angular_velocity(), 6, 0.01);
}

TEST(Gear, a_rack_goes_as_far_as_the_wheel_rolls)
{
    World world({.gravity = {}});
    const BodyId wheel = world.create_body({.position = {0, 0.5f}}, circle(0.5f));
    const BodyId rack = world.create_body({.position = {0, -0.1f}}, box(6, 0.2f));
    const JointId pin = world.create_joint(world.joint_at({}, wheel, {0, 0.5f}), RevoluteJoint{.motor = Motor{1, 500}});
    world.create_joint(world.joint_at({}, rack, {0, 0}), PrismaticJoint{});
    // Turning by one radian to the left carries the rack below by the radius to the right: angle - 2 way stays 0.
    JointDef def{.body_a = wheel, .body_b = rack};
    world.create_joint(def, GearJoint{.ratio = -2, .motion_b = GearMotion::Slide});
    for (int i = 0; i < 300; ++i) world.step(dt);
    EXPECT_NEAR(world.joint(pin).angle(), 5, 0.01);
    EXPECT_NEAR(world.body(rack).position().x, 2.5f, 0.01);
}

TEST(Pulley, balances_two_to_one)
{
    World world;
    const BodyId heavy = world.create_body({.position = {-1, 0}}, box(1, 1), {.density = 10});
    const BodyId light = world.create_body({.position = {1, 0}}, box(1, 1), {.density = 5});
    // length_a + ratio length_b: B moves 1/ratio of A's way and is pulled ratio times as hard.
    const JointId joint = world.create_joint(world.joint_between(light, heavy, {1, 0}, {-1, 0}),
                                             PulleyJoint{.ground_a = {1, 5}, .ground_b = {-1, 5}, .ratio = 2, .length = 15});
    for (int i = 0; i < 600; ++i) world.step(dt);
    EXPECT_NEAR(world.body(heavy).position().y, 0, 0.005);
    EXPECT_NEAR(world.body(light).position().y, 0, 0.005);
    EXPECT_NEAR(world.joint(joint).force().y, 10 * g, 0.1 * g) << "on B";
    world.body(light).apply_impulse_to_center({0, -5});
    for (int i = 0; i < 30; ++i) world.step(dt);
    EXPECT_NEAR(world.body(heavy).position().y, -0.5f * world.body(light).position().y, 0.005);
    EXPECT_LT(world.body(light).position().y, -0.1f);
}

TEST(Pulley, atwoods_machine_falls_as_the_masses_say)
{
    World world;
    const BodyId heavy = world.create_body({.position = {-1, 0}}, box(1, 1), {.density = 3});
    const BodyId light = world.create_body({.position = {1, -4}}, box(1, 1), {.density = 2});
    world.create_joint(world.joint_between(heavy, light, {-1, 0}, {1, -4}),
                       PulleyJoint{.ground_a = {-1, 5}, .ground_b = {1, 5}, .length = 14});
    for (int i = 0; i < 60; ++i) world.step(dt);
    const double a = g * (3 - 2) / (3 + 2);
    EXPECT_NEAR(world.body(heavy).position().y, -a / 2, 0.01 * a / 2);
    EXPECT_NEAR(world.body(light).position().y, -4 + a / 2, 0.01 * a / 2);
}

TEST(Motor, accelerates_by_torque_over_inertia_up_to_its_speed)
{
    World world({.gravity = {}});
    const BodyId wheel = world.create_body({}, circle(0.5f), {.density = 4});
    const JointId pin = world.create_joint(world.joint_at({}, wheel, {}), RevoluteJoint{.motor = Motor{20, 1}});
    const float rate = 1 / world.body(wheel).mass_data().inertia;
    for (int i = 0; i < 60; ++i) world.step(dt);
    EXPECT_NEAR(world.body(wheel).angular_velocity(), rate, 0.001f * rate);
    EXPECT_NEAR(world.joint(pin).torque(), 1, 0.001);
    for (int i = 0; i < 3600; ++i) world.step(dt);
    EXPECT_NEAR(world.body(wheel).angular_velocity(), 20, 0.001);
    EXPECT_NEAR(world.joint(pin).torque(), 0, 0.001);
}

TEST(Motor, on_a_rail_accelerates_by_force_over_mass)
{
    World world({.gravity = {}});
    const BodyId cart = world.create_body({}, box(1, 1), {.density = 4});
    const JointId rail = world.create_joint(world.joint_at({}, cart, {}, 0.5f), PrismaticJoint{.motor = Motor{5, 8}});
    for (int i = 0; i < 60; ++i) world.step(dt);
    EXPECT_NEAR(length(world.body(cart).linear_velocity()), 2, 0.001);
    EXPECT_NEAR(world.joint(rail).offset().y, 0, 1e-4);
    for (int i = 0; i < 120; ++i) world.step(dt);
    EXPECT_NEAR(length(world.body(cart).linear_velocity()), 5, 0.001);
}

// ---- springs ----

TEST(JointSpring, swings_with_its_frequency_and_its_damping)
{
    // Every joint with a spring, a body of 3 kg at its other end: x'' + 2 zeta omega x' + omega^2 x = 0.
    for (const float hertz : {1.0f, 4.0f, 8.0f})
        for (const float zeta : {0.0f, 0.1f, 0.5f})
        {
            const Spring spring{hertz, zeta, 0};
            const std::vector<JointSpec> specs = {PrismaticJoint{.spring = spring}, WheelJoint{.suspension = spring},
                                                  MouseJoint{.spring = spring, .max_force = 1e6f}, WeldJoint{.linear = spring},
                                                  MotorJoint{.spring = spring, .max_force = 1e6f, .max_torque = 1e6f}};
            for (const JointSpec& spec : specs)
            {
                World world({.gravity = {}});
                const BodyId body = world.create_body({}, box(1, 1), {.density = 3});
                world.create_joint(world.joint_at({}, body, {}), spec);
                world.body(body).set_transform({0.2f, 0}, 0);
                const double omega = 2 * double{pi} * double{hertz};
                const double damped = omega * std::sqrt(1 - square(zeta));
                for (int i = 1; i <= 30; ++i)
                {
                    world.step(dt, 16);
                    const double t = i / 60.0;
                    const double expected = 0.2 * std::exp(-double{zeta} * omega * t) *
                                            (std::cos(damped * t) + double{zeta} * omega / damped * std::sin(damped * t));
                    ASSERT_NEAR(world.body(body).position().x, expected, 0.012)
                        << hertz << " Hz, " << zeta << ", spec " << spec.index() << " at " << t;
                }
            }
        }
}

// ---- Newton's cradle ----

namespace
{

/// Speeds of five balls on rods along x, after the first has come down from 1 rad and hit the others.
std::vector<double> speeds_after_the_blow(float gap)
{
    constexpr float radius = 0.5f;
    constexpr float rod = 4;
    World world;
    std::vector<BodyId> balls;
    for (int i = 0; i < 5; ++i)
    {
        const Vec2 top{static_cast<float>(i) * (2 * radius + gap), 0};
        const Rot q = rotation(i == 0 ? -1.0f : 0.0f);
        const Vec2 place = top + rotate(q, Vec2{0, -rod});
        balls.push_back(world.create_body({.position = place}, circle(radius), {.material = {.friction = 0, .restitution = 1}}));
        world.create_joint(world.joint_between({}, balls.back(), top, place), DistanceJoint{.length = rod});
    }
    const auto speeds = [&]
    {
        std::vector<double> all;
        for (const BodyId id : balls) all.push_back(double{world.body(id).linear_velocity().x});
        return all;
    };
    for (int i = 0; i < 300 && speeds().back() < 1; ++i) world.step(dt);
    return speeds();
}

} // namespace

TEST(Cradle, passes_momentum_through_five_balls)
{
    const double speed = std::sqrt(2 * g * 4 * (1 - std::cos(1.0)));
    for (const float gap : {0.0f, 0.001f, 0.01f})
    {
        const std::vector<double> after = speeds_after_the_blow(gap);
        EXPECT_NEAR(after[4], speed, 0.02 * speed) << "gap " << gap;
        for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(after[i], 0, 0.02 * speed) << "ball " << i << ", gap " << gap;
    }
}

// ---- mass ratios ----

TEST(MassRatio, a_weight_of_200_hangs_from_a_light_link)
{
    World world;
    const BodyId link = world.create_body({.position = {0, -0.5f}}, box(0.1f, 1), {.density = 10});
    const BodyId weight = world.create_body({.position = {0, -1.5f}}, box(1, 1), {.density = 200});
    world.create_joint(world.joint_at({}, link, {0, 0}), RevoluteJoint{});
    world.create_joint(world.joint_at(link, weight, {0, -1}), RevoluteJoint{});
    for (int i = 0; i < 600; ++i) world.step(dt);
    EXPECT_NEAR(world.body(weight).position().y, -1.5f, 0.001);
}

TEST(MassRatio, a_light_column_of_welds_carries_a_weight_of_200)
{
    World world;
    BodyId before;
    for (int i = 0; i < 10; ++i)
    {
        const float low = static_cast<float>(i);
        const BodyId body = world.create_body({.position = {0, low + 0.5f}}, box(0.5f, 1), {.density = i == 9 ? 200.0f : 1.0f});
        world.create_joint(world.joint_at(before, body, {0, low}), WeldJoint{});
        before = body;
    }
    for (int i = 0; i < 1800; ++i) world.step(dt);
    EXPECT_NEAR(world.body(before).position().y, 9.5f, 0.001);
    EXPECT_NEAR(world.body(before).position().x, 0, 0.001);
}

} // namespace carom
