// Joints that start open or beyond their limits come together at a bounded speed and are calm afterwards.
#include "math/values_test.hpp"

#include <carom/carom.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace carom
{

namespace
{

/// The most speed at which a joint undoes an error: 4 m/s and 4 rad/s in a world of 1 m bodies, and what rounding and arcs add.
constexpr float most_speed = 4.4f;

/// A bar of 2 x 0.3 m that is joined to the world by its left end, without gravity.
struct Bar
{
    Bar() : world({.gravity = {}, .sleep = {.is_enabled = false}}), id(world.create_body({}, box(2, 0.3f), {.density = 1})) {}

    World world;
    BodyId id;
};

struct Undoing
{
    float fastest_place = 0; ///< of the bar's centre, from its places step by step [m/s]
    float fastest_turn = 0;  ///< [rad/s]
    float speed_after = 0;   ///< [m/s]
    float spin_after = 0;    ///< [rad/s]
};

/// Two seconds. Places are compared, since a body that is moved together has no speed that would show it.
Undoing undo(Bar& bar)
{
    Undoing seen;
    const BodyView body = bar.world.body(bar.id);
    for (int i = 0; i < 120; ++i)
    {
        const Vec2 place = body.position();
        const Rot q = body.transform().q;
        bar.world.step(dt);
        seen.fastest_place = std::max(seen.fastest_place, distance(place, body.position()) / dt);
        seen.fastest_turn = std::max(seen.fastest_turn, std::abs(angle(relative(q, body.transform().q))) / dt);
    }
    seen.speed_after = length(body.linear_velocity());
    seen.spin_after = std::abs(body.angular_velocity());
    return seen;
}

void expect_calm(const Undoing& seen)
{
    EXPECT_LT(seen.speed_after, 0.01f);
    EXPECT_LT(seen.spin_after, 0.01f);
}

} // namespace

TEST(JointStart, a_rail_beyond_its_limit_slides_back_at_a_bounded_speed)
{
    Bar bar;
    const JointDef def = bar.world.joint_between({}, bar.id, {-4, 0}, {0, 0});
    const JointId joint = bar.world.create_joint(def, PrismaticJoint{.limit = Range{-1, 1}});
    const Undoing seen = undo(bar);
    EXPECT_LT(seen.fastest_place, most_speed);
    EXPECT_NEAR(bar.world.joint(joint).offset().x, 1, 0.01f);
    expect_calm(seen);
}

TEST(JointStart, a_rope_that_is_too_long_pulls_in_at_a_bounded_speed)
{
    Bar bar;
    const JointDef def = bar.world.joint_between({}, bar.id, {-5, 0}, {0, 0});
    const JointId joint = bar.world.create_joint(def, DistanceJoint{.limit = Range{0, 2}});
    const Undoing seen = undo(bar);
    EXPECT_LT(seen.fastest_place, most_speed);
    EXPECT_NEAR(bar.world.joint(joint).offset().x, 2, 0.01f);
    expect_calm(seen);
}

TEST(JointStart, a_weld_and_a_pin_that_are_open_close_at_a_bounded_speed)
{
    for (const JointSpec& spec : {JointSpec{WeldJoint{}}, JointSpec{RevoluteJoint{}}})
    {
        Bar bar;
        const JointDef def = bar.world.joint_between({}, bar.id, {-3, 0}, {0, 0});
        const JointId joint = bar.world.create_joint(def, spec);
        const Undoing seen = undo(bar);
        EXPECT_LT(seen.fastest_place, most_speed);
        EXPECT_LT(bar.world.joint(joint).error(), 0.001f);
        expect_calm(seen);
    }
}

TEST(JointStart, a_weld_that_is_turned_turns_back_at_a_bounded_speed)
{
    Bar bar;
    JointDef def = bar.world.joint_at({}, bar.id, {-1, 0});
    def.frame_b.q = rotation(2.5f);
    const JointId joint = bar.world.create_joint(def, WeldJoint{});
    const Undoing seen = undo(bar);
    EXPECT_LT(seen.fastest_turn, most_speed);
    EXPECT_LT(bar.world.joint(joint).error(), 0.001f);
    expect_calm(seen);
}

TEST(JointStart, a_pinned_bar_beyond_its_limit_turns_back_at_a_bounded_speed)
{
    Bar bar;
    JointDef def = bar.world.joint_at({}, bar.id, {-1, 0});
    def.frame_b.q = rotation(2.5f);
    const JointId joint = bar.world.create_joint(def, RevoluteJoint{.limit = Range{-0.5f, 0.5f}});
    const Undoing seen = undo(bar);
    EXPECT_LT(seen.fastest_turn, most_speed);
    EXPECT_NEAR(bar.world.joint(joint).angle(), 0.5f, 0.01f);
    expect_calm(seen);
}

TEST(JointStart, a_motor_brings_a_pinned_bar_to_its_speed_in_one_step)
{
    Bar bar;
    bar.world.create_joint(bar.world.joint_at({}, bar.id, {-1, 0}), RevoluteJoint{.motor = Motor{.speed = 2}});
    bar.world.step(dt);
    EXPECT_NEAR(bar.world.body(bar.id).angular_velocity(), 2, 0.02f);
    bar.world.step(dt);
    EXPECT_NEAR(bar.world.body(bar.id).angular_velocity(), 2, 1e-4f);
}

} // namespace carom
